// SPDX-License-Identifier: GPL-3.0-or-later
#include "service/queuerun.h"

#include "model/unit.h"

#include <QUuid>

#include <algorithm>
#include <span>
#include <utility>

namespace mb::service {

namespace {

/// As retrying does: what a unit came to at last counts. Who stands in a place may be another than the one before.
bool isTriedAgain(const Visit &visit, std::span<const Visit> later)
{
    return visit.outcome != Outcome::Passed && unitByOf(visit.unit) == UnitBy::Serial
        && std::ranges::any_of(later, [&visit](const Visit &one) { return one.unit == visit.unit; });
}

} // namespace

QueueRun::QueueRun(Clock &clock, RecipeMatter matter, QueueSurroundings surroundings, QueueOptions options)
    : m_clock(clock)
    , m_matter(std::move(matter))
    , m_around(std::move(surroundings))
    , m_options(std::move(options))
{
}

Task<void> QueueRun::recall()
{
    if (m_options.run.empty()) {
        m_options.run = QUuid::createUuid().toString(QUuid::WithoutBraces).toStdString();
        co_return {};
    }
    VisitFilter filter;
    filter.run = m_options.run;
    m_earlier = co_await m_around.journal.visits(std::move(filter));
    for (auto visit = m_earlier.begin(); visit != m_earlier.end(); ++visit) {
        if (!isTriedAgain(*visit, {std::next(visit), m_earlier.end()}))
            change(*visit, 1);
    }
    co_return {};
}

void QueueRun::count(const Visit &visit)
{
    change(visit, 1);
    if (visit.ending == Ending::NumbersUsedUp) {
        m_isFinishing = true;
        m_trouble = Error{Fault::OutOfRange, visit.cause, visit.remedy};
    }
    m_unitEnded.notify(visit);
    m_changed.notify();
}

void QueueRun::setPausing(bool is)
{
    m_isPausing = is;
    m_changed.notify();
}

void QueueRun::finish()
{
    m_isFinishing = true;
    m_changed.notify();
}

bool QueueRun::isComplete() const
{
    return m_options.units && *m_options.units > 0 && m_counts.ended() >= *m_options.units;
}

/// Units that are being served will count too. There is one programmer, one cable to a bootloader and one pair of hands: where the
/// firmware takes another way in, one unit is served after the other, whatever their buses.
bool QueueRun::mayBegin() const
{
    const bool sharesWayIn = m_matter.recipe.firmware && !m_matter.recipe.firmware->via.empty();
    return !m_isPausing && !m_isFinishing && !(sharesWayIn && isServing())
        && (!m_options.units || *m_options.units == 0
            || m_counts.ended() + static_cast<int>(m_serving.size()) < *m_options.units);
}

bool QueueRun::isElsewhere(const Link &link, const std::string &unit) const
{
    const auto isThere = [&](const auto &place) {
        return place.second != &link && std::ranges::any_of(place.first->devices(), [&](const Device *device) {
            return &device->link() == place.second && device->liveness().heard && unitKeyOf(*device) == unit;
        });
    };
    const auto isServed = [&](const auto &one) { return one.first != &link && one.second == unit; };
    return unitByOf(unit) == UnitBy::Serial
        && (std::ranges::any_of(m_serving, isServed) || std::ranges::any_of(m_places, isThere));
}

void QueueRun::setTrouble(const Error &error)
{
    if (!m_trouble)
        m_trouble = error;
}

void QueueRun::change(const Visit &visit, int by)
{
    m_counts.passed += visit.outcome == Outcome::Passed ? by : 0;
    m_counts.failed += visit.outcome == Outcome::Failed ? by : 0;
    m_counts.refused += visit.outcome == Outcome::Refused ? by : 0;
}

} // namespace mb::service
