// SPDX-License-Identifier: GPL-3.0-or-later
#include "service/servicequeue.h"

#include "service/queuebus.h"

#include <QUuid>

#include <algorithm>

namespace mb::service {

ServiceQueue::ServiceQueue(Clock &clock, RecipeMatter matter, QueueSurroundings surroundings, QueueOptions options)
    : m_clock(clock)
    , m_matter(std::move(matter))
    , m_around(std::move(surroundings))
    , m_options(std::move(options))
    , m_scope(clock)
{
}

ServiceQueue::~ServiceQueue()
{
    m_scope.clear();
}

void ServiceQueue::addBus(Session &session, Link &link)
{
    m_buses.push_back(std::make_unique<Bus>(*this, session, link));
}

void ServiceQueue::start()
{
    ++m_lanes; // until what was before is known
    m_scope.spawn<void>(recall(), [this](Result<void> recalled) {
        if (!recalled)
            m_trouble = recalled.error();
        else
            std::for_each(m_buses.begin(), m_buses.end(), [this](const auto &bus) { startLane(*bus); });
        --m_lanes;
        m_changed.notify();
        if (m_lanes == 0)
            m_ended.notify();
    });
}

Task<void> ServiceQueue::recall()
{
    if (m_options.run.empty()) {
        m_options.run = QUuid::createUuid().toString(QUuid::WithoutBraces).toStdString();
        co_return {};
    }
    VisitFilter filter;
    filter.run = m_options.run;
    auto asking = m_around.journal.visits(std::move(filter));
    m_earlier = co_await std::move(asking);
    for (const Visit &visit : m_earlier)
        change(visit, 1);
    co_return {};
}

void ServiceQueue::startLane(Bus &bus)
{
    if (bus.isInLane())
        return;
    bus.setInLane(true);
    ++m_lanes;
    m_scope.spawn<void>(bus.run(), [this, &bus](Result<void> result) { laneEnded(bus, result); });
}

void ServiceQueue::laneEnded(Bus &bus, const Result<void> &result)
{
    bus.setInLane(false);
    if (!result && !m_trouble)
        m_trouble = result.error();
    --m_lanes;
    m_changed.notify();
    if (m_lanes == 0)
        m_ended.notify();
}

void ServiceQueue::change(const Visit &visit, int by)
{
    m_counts.passed += visit.outcome == Outcome::Passed ? by : 0;
    m_counts.failed += visit.outcome == Outcome::Failed ? by : 0;
    m_counts.refused += visit.outcome == Outcome::Refused ? by : 0;
}

void ServiceQueue::count(const Visit &visit)
{
    change(visit, 1);
    if (visit.cause.english().starts_with(numbersUsedUp)) {
        m_isFinishing = true;
        m_trouble = Error{Fault::OutOfRange, visit.cause, visit.remedy};
    }
    m_unitEnded.notify(visit);
    m_changed.notify();
}

bool ServiceQueue::isComplete() const
{
    return m_options.units && *m_options.units > 0 && m_counts.ended() >= *m_options.units;
}

/// Units that are being served will count too. There is one programmer, one cable to a bootloader and one pair of hands: where the
/// firmware takes another way in, one unit is served after the other, whatever their buses.
bool ServiceQueue::mayBegin() const
{
    const auto serving
        = std::count_if(m_buses.begin(), m_buses.end(), [](const auto &bus) { return bus->isServing(); });
    const bool sharesWayIn = m_matter.recipe.firmware && !m_matter.recipe.firmware->via.empty();
    return !m_isPausing && !m_isFinishing && !(sharesWayIn && serving > 0)
        && (!m_options.units || *m_options.units == 0
            || m_counts.ended() + static_cast<int>(serving) < *m_options.units);
}

bool ServiceQueue::mustStayAwake() const
{
    return std::any_of(
        m_buses.begin(), m_buses.end(), [](const auto &bus) { return bus->isServing() && bus->isReal(); });
}

bool ServiceQueue::isPaused() const
{
    return m_isPausing
        && std::none_of(m_buses.begin(), m_buses.end(), [](const auto &bus) { return bus->isServing(); });
}

std::vector<QueueRow> ServiceQueue::rows() const
{
    std::vector<QueueRow> rows;
    for (const auto &bus : m_buses)
        bus->addRows(rows);
    std::sort(rows.begin(), rows.end(), [](const QueueRow &a, const QueueRow &b) { return a.id < b.id; });
    return rows;
}

void ServiceQueue::pause()
{
    m_isPausing = true;
    m_changed.notify();
}

void ServiceQueue::resume()
{
    m_isPausing = false;
    m_changed.notify();
}

void ServiceQueue::skip(std::uint32_t row)
{
    for (const auto &bus : m_buses) {
        if (bus->skip(row))
            break;
    }
    m_changed.notify();
}

void ServiceQueue::retry(std::uint32_t row)
{
    for (const auto &bus : m_buses) {
        if (bus->retry(row) && !m_isFinishing)
            startLane(*bus);
    }
    m_changed.notify();
}

void ServiceQueue::retryFailed()
{
    for (const auto &bus : m_buses) {
        if (bus->retryFailed() && !m_isFinishing)
            startLane(*bus);
    }
    m_changed.notify();
}

void ServiceQueue::finish()
{
    m_isFinishing = true;
    m_changed.notify();
}

void ServiceQueue::stop()
{
    m_isFinishing = true;
    for (const auto &bus : m_buses)
        bus->stop();
    m_changed.notify();
}

void ServiceQueue::renewLease()
{
    for (const auto &bus : m_buses)
        bus->renewLease();
}

} // namespace mb::service
