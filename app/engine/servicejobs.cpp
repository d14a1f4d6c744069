// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/engine/servicejobs.h"

#include <algorithm>

namespace mb {
namespace {

constexpr Duration armedAgain = std::chrono::milliseconds(100);

/// One more, as long as it lives.
class Counted {
public:
    explicit Counted(int &count)
        : m_count(count)
    {
        ++m_count;
    }
    Counted(const Counted &) = delete;
    Counted &operator=(const Counted &) = delete;
    ~Counted() { --m_count; }

private:
    int &m_count;
};

} // namespace

ServiceJobs::ServiceJobs(EngineCore &core, Surroundings surroundings)
    : m_core(core)
    , m_around(std::move(surroundings))
    , m_armedUntil(core.session().clock())
{
    m_sessionChanged = core.session().changed().add([this] { followLinks(); });
}

ServiceJobs::~ServiceJobs()
{
    leave();
}

Result<void> ServiceJobs::begin(const ServiceDesk::Plan &plan)
{
    if (isRunning())
        return fail(Fault::Unsafe, say("units are served already"), say("end that first"));
    leave();
    m_last = {};
    m_links = plan.links;
    if (auto lent = lendAll(); !lent)
        return lent;
    m_trouble = {};
    m_station.leaving = false;
    m_judged.clear();
    m_chosen.reset();
    if (plan.chosen)
        m_chosen.emplace(plan.chosen->begin(), plan.chosen->end());
    service::QueueOptions options;
    options.station = m_around.station;
    options.units = plan.units;
    options.run = plan.run;
    options.onlyChosen = plan.chosen.has_value();
    m_queue = std::make_unique<service::ServiceQueue>(m_core.session().clock(), *plan.matter,
        service::QueueSurroundings{m_around.journal, m_around.settings, m_around.trials, this, {}}, options);
    for (Link *const link : m_lent)
        m_queue->addBus(m_core.session(), *link);
    m_queueChanged = m_queue->changed().add([this] { queueChanged(); });
    m_visitEnded = m_queue->unitEnded().add([this](const service::Visit &visit) { ended(visit); });
    m_queueEnded = m_queue->ended().add([this] {
        if (m_queue->trouble())
            m_trouble = m_queue->trouble()->message();
        arm(false);
        giveBack();
    });
    m_queue->start();
    m_changed.notify();
    return {};
}

Result<void> ServiceJobs::setStation(std::string name)
{
    if (isRunning())
        return fail(Fault::Unsafe, say("units are served already"), say("end that first"));
    m_around.station = std::move(name);
    return {};
}

/// All of them or none.
Result<void> ServiceJobs::lendAll()
{
    std::vector<Link *> lent;
    for (const std::string &address : m_links) {
        Link *const link = m_core.lend(address);
        if (link) {
            lent.push_back(link);
            continue;
        }
        for (const Link *const other : lent)
            m_core.takeBack(other->address().text());
        return fail(Fault::Timeout, say("%1 is not open, or something runs there", address),
            say("open it, or end what runs there first"));
    }
    m_lent = std::move(lent);
    return {};
}

void ServiceJobs::giveBack()
{
    for (const std::string &address : m_links)
        m_core.takeBack(address);
}

/// A link that was closed takes its queue along: nothing can be done again there, and what is known stays in sight.
void ServiceJobs::followLinks()
{
    if (!m_queue)
        return;
    const auto links = m_core.session().links();
    const bool all = std::all_of(m_lent.begin(), m_lent.end(),
        [&links](const Link *link) { return std::find(links.begin(), links.end(), link) != links.end(); });
    if (all)
        return;
    ServiceView last = view();
    leave();
    last.running = false;
    last.armed = false;
    m_last = std::move(last);
    m_changed.notify();
}

void ServiceJobs::leave()
{
    m_station.armed = false;
    m_armedUntil.stop();
    m_queue.reset();
    giveBack();
    m_links.clear();
    m_lent.clear();
}

void ServiceJobs::queueChanged()
{
    choose();
    m_changed.notify();
}

/// Of what is found the chosen are taken, the others stay left out.
void ServiceJobs::choose()
{
    if (!m_chosen)
        return;
    for (const service::QueueRow &row : m_queue->rows()) {
        if (m_judged.insert(row.id).second && row.state == service::RowState::Skipped
            && m_chosen->count(row.device) > 0)
            m_queue->retry(row.id);
    }
}

void ServiceJobs::pause(bool on)
{
    if (m_queue)
        on ? m_queue->pause() : m_queue->resume();
}

void ServiceJobs::skip(std::uint32_t row)
{
    if (m_queue)
        m_queue->skip(row);
}

/// A queue that has ended gets its links back for it, if anything comes of the order.
void ServiceJobs::again(const std::function<void()> &order)
{
    if (!m_queue)
        return;
    const bool idle = !isRunning();
    if (idle && !lendAll())
        return;
    m_trouble = {};
    m_station.leaving = false;
    order();
    if (idle && !isRunning())
        giveBack();
    m_changed.notify();
}

void ServiceJobs::retry(std::uint32_t row)
{
    again([this, row] { m_queue->retry(row); });
}

void ServiceJobs::retryFailed()
{
    again([this] { m_queue->retryFailed(); });
}

void ServiceJobs::cancel()
{
    arm(false);
    if (!isRunning())
        return;
    m_station.leaving = true;
    m_queue->finish();
    for (const service::QueueRow &row : m_queue->rows()) {
        if (row.state == service::RowState::Running)
            m_queue->skip(row.id);
    }
}

void ServiceJobs::finish()
{
    arm(false);
    m_station.leaving = true;
    if (m_queue)
        m_queue->finish();
}

void ServiceJobs::stop()
{
    arm(false);
    m_station.leaving = true;
    if (isRunning())
        m_queue->stop();
}

void ServiceJobs::arm(bool on)
{
    m_station.armed = on && isRunning() && m_queue->matter().recipe.test;
    restartArmedTime();
    m_changed.notify();
}

void ServiceJobs::restartArmedTime()
{
    m_station.end = m_core.session().clock().now() + armedTime;
    if (m_station.armed)
        m_armedUntil.start(m_station.end, [this] { arm(false); });
    else
        m_armedUntil.stop();
}

void ServiceJobs::renew()
{
    if (m_queue)
        m_queue->renewLease();
}

void ServiceJobs::ended(const service::Visit &visit)
{
    if (visit.outcome == service::Outcome::Failed)
        arm(false);
    restartArmedTime();
    m_unitEnded.notify(visit);
    m_changed.notify();
}

/// Three seconds in which everybody is told, and somebody can still say no: then it waits again.
Task<void> ServiceJobs::beforeMotion(const Device &device, const service::SelfTest &, Progress &progress)
{
    do {
        auto waiting = untilArmed(device, progress);
        co_await std::move(waiting);
        const Counted announcing(m_station.announcing);
        restartArmedTime();
        m_changed.notify();
        Sleep warning(m_core.session().clock(), announcement);
        co_await warning;
    } while (!m_station.armed);
    m_changed.notify();
    co_return {};
}

/// Everything else is done by then, and nothing is lost while it waits.
Task<void> ServiceJobs::untilArmed(const Device &device, Progress &progress)
{
    const Counted waiting(m_station.waiting);
    const bool isFollowed = device.liveness().heard;
    Instant heardAt = device.clock().now();
    while (!m_station.armed) {
        if (m_station.leaving)
            co_return fail(Fault::Cancelled, say("left before the station was armed"));
        if (device.link().state() != LinkState::Open)
            co_return fail(
                Fault::LinkLost, say("%1: %2", device.link().address().shortName(), device.link().loss().message()));
        if (device.liveness().heard)
            heardAt = device.clock().now();
        if (isFollowed && device.clock().now() - heardAt >= takenOff)
            co_return fail(Fault::Timeout, say("the unit was taken off while it waited for the station to be armed"),
                say("hold Arm, then put it on again"));
        progress.step(say("waits until the station is armed"), 0, 0);
        Sleep looking(m_core.session().clock(), armedAgain);
        co_await looking;
    }
    co_return {};
}

ServiceView ServiceJobs::view() const
{
    if (!m_queue)
        return m_last;
    ServiceView view;
    view.links = m_links;
    view.armed = m_station.armed;
    view.armedUntil = m_station.end;
    view.announces = m_station.announcing > 0;
    view.waits = m_station.waiting > 0 && !m_station.armed;
    view.trouble = m_trouble;
    view.recipe = m_queue->matter().recipe.name;
    view.run = m_queue->run();
    view.running = m_queue->isRunning();
    view.moves = m_queue->matter().recipe.test.has_value();
    view.pausing = m_queue->isPausing();
    view.rows = m_queue->rows();
    view.counts = m_queue->counts();
    return view;
}

} // namespace mb
