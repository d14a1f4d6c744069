// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/engine/serviceroom.h"

namespace mb {

ServiceRoom::ServiceRoom(EngineCore &core, Surroundings surroundings)
    : m_core(core)
    , m_around(std::move(surroundings))
    , m_armedUntil(core.session().clock())
{
}

ServiceRoom::~ServiceRoom()
{
    leave();
}

Result<void> ServiceRoom::begin(const ServiceDesk::Plan &plan)
{
    if (m_queue && m_queue->isRunning())
        return fail(Fault::Unsafe, say("units are served already"), say("end that first"));
    Link *link = m_core.lend(plan.link);
    if (!link)
        return fail(Fault::Timeout, say("the link is not open"), say("open it first"));
    if (m_link == plan.link)
        m_link.clear(); // lent anew, and not to be given back
    leave();
    m_link = plan.link;
    m_trouble.clear();
    service::QueueOptions options;
    options.station = m_around.station;
    options.units = plan.units;
    m_queue = std::make_unique<service::ServiceQueue>(m_core.session().clock(), *plan.matter,
        service::QueueSurroundings{m_around.journal, m_around.settings, m_around.trials, this, {}}, options);
    m_queue->addBus(m_core.session(), *link);
    m_queueChanged = m_queue->changed().add([this] { m_changed.notify(); });
    m_visitEnded = m_queue->unitEnded().add([this](const service::Visit &visit) { ended(visit); });
    m_queueEnded = m_queue->ended().add([this] {
        if (m_queue->trouble())
            m_trouble = m_queue->trouble()->text();
        arm(false);
        m_core.takeBack(m_link);
    });
    m_queue->start();
    m_changed.notify();
    return {};
}

void ServiceRoom::leave()
{
    m_armed = false;
    m_announces = false;
    m_armedUntil.stop();
    m_queue.reset();
    if (!m_link.empty())
        m_core.takeBack(m_link);
    m_link.clear();
}

void ServiceRoom::pause(bool on)
{
    if (m_queue)
        on ? m_queue->pause() : m_queue->resume();
}

void ServiceRoom::skip(std::uint32_t row)
{
    if (m_queue)
        m_queue->skip(row);
}

void ServiceRoom::retry(std::uint32_t row)
{
    if (!m_queue)
        return;
    const bool lent = !m_queue->isRunning() && m_core.lend(m_link);
    if (lent || m_queue->isRunning())
        m_queue->retry(row);
    if (lent && !m_queue->isRunning())
        m_core.takeBack(m_link); // nothing came of it
}

void ServiceRoom::finish()
{
    arm(false);
    if (m_queue)
        m_queue->finish();
}

void ServiceRoom::stop()
{
    arm(false);
    if (m_queue && m_queue->isRunning())
        m_queue->stop();
}

void ServiceRoom::arm(bool on)
{
    m_armed = on && m_queue && m_queue->isRunning() && m_queue->matter().recipe.test;
    restartArmedTime();
    m_changed.notify();
}

void ServiceRoom::restartArmedTime()
{
    if (m_armed)
        m_armedUntil.startIn(armedTime, [this] { arm(false); });
    else
        m_armedUntil.stop();
}

void ServiceRoom::renew()
{
    if (m_queue)
        m_queue->renewLease();
}

void ServiceRoom::ended(const service::Visit &visit)
{
    if (visit.outcome == service::Outcome::Failed)
        arm(false);
    restartArmedTime();
    m_unitEnded.notify(visit);
    m_changed.notify();
}

/// Three seconds in which everybody is told, and somebody can still say no.
Task<void> ServiceRoom::beforeMotion(const Device &, const service::SelfTest &)
{
    const auto refusal = [] {
        return fail(Fault::Unsafe, say("self-tests are not armed"), say("hold Arm on the page, then test again"));
    };
    if (!m_armed)
        co_return refusal();
    m_announces = true;
    restartArmedTime();
    m_changed.notify();
    Sleep warning(m_core.session().clock(), announcement);
    co_await warning;
    m_announces = false;
    m_changed.notify();
    if (!m_armed)
        co_return refusal();
    co_return {};
}

ServiceView ServiceRoom::view() const
{
    ServiceView view;
    view.link = m_link;
    view.armed = m_armed;
    view.announces = m_announces;
    view.trouble = m_trouble;
    if (!m_queue)
        return view;
    view.running = m_queue->isRunning();
    view.pausing = m_queue->isPausing();
    view.rows = m_queue->rows();
    view.counts = m_queue->counts();
    return view;
}

} // namespace mb
