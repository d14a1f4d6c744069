// SPDX-License-Identifier: GPL-3.0-or-later
#include "service/servicequeue.h"

#include "service/queuebus.h"

#include <algorithm>

namespace mb::service {

ServiceQueue::ServiceQueue(Clock &clock, RecipeMatter matter, QueueSurroundings surroundings, QueueOptions options)
    : m_run(clock, std::move(matter), std::move(surroundings), std::move(options))
    , m_scope(clock)
{
}

ServiceQueue::~ServiceQueue()
{
    m_scope.clear();
}

void ServiceQueue::addBus(Session &session, Link &link)
{
    m_buses.push_back(std::make_unique<QueueBus>(m_run, session, link));
}

void ServiceQueue::start()
{
    ++m_lanes; // until what was before is known
    m_scope.spawn<void>(m_run.recall(), [this](Result<void> recalled) {
        if (!recalled)
            m_run.setTrouble(recalled.error());
        else
            std::ranges::for_each(m_buses, [this](const auto &bus) { startLane(*bus); });
        closeLane();
    });
}

void ServiceQueue::startLane(QueueBus &bus)
{
    if (bus.isInLane())
        return;
    bus.setInLane(true);
    if (m_lanes++ == 0)
        m_run.forgetTrouble();
    m_scope.spawn<void>(bus.run(), [this, &bus](Result<void> result) { laneEnded(bus, result); });
}

void ServiceQueue::laneEnded(QueueBus &bus, const Result<void> &result)
{
    bus.setInLane(false);
    if (!result)
        m_run.setTrouble(result.error());
    closeLane();
}

void ServiceQueue::closeLane()
{
    --m_lanes;
    changed().notify();
    if (m_lanes == 0)
        m_ended.notify();
}

bool ServiceQueue::mustStayAwake() const
{
    return std::ranges::any_of(m_buses, [](const auto &bus) { return bus->isServing() && bus->isReal(); });
}

std::vector<Shared<QueueRow>> ServiceQueue::rows() const
{
    std::vector<Shared<QueueRow>> rows;
    for (const auto &bus : m_buses)
        bus->addRows(rows);
    std::ranges::sort(rows, {}, &QueueRow::id);
    return rows;
}

void ServiceQueue::skip(std::uint32_t row)
{
    for (const auto &bus : m_buses) {
        if (bus->skip(row))
            break;
    }
    changed().notify();
}

Result<void> ServiceQueue::retry(std::uint32_t row)
{
    const auto found = std::ranges::find_if(m_buses, [row](const auto &bus) { return bus->has(row); });
    if (found == m_buses.end())
        return fail(Fault::Refused, say("it is not in the queue"));
    Result<void> done = (*found)->retry(row);
    if (done)
        startLane(**found);
    changed().notify();
    return done;
}

bool ServiceQueue::retryFailed()
{
    bool any = false;
    for (const auto &bus : m_buses) {
        if (!bus->retryFailed())
            continue;
        startLane(*bus);
        any = true;
    }
    changed().notify();
    return any;
}

void ServiceQueue::stop()
{
    m_run.finish();
    for (const auto &bus : m_buses)
        bus->stop();
}

void ServiceQueue::renewLease()
{
    for (const auto &bus : m_buses)
        bus->renewLease();
}

} // namespace mb::service
