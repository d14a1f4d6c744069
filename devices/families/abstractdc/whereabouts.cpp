// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/abstractdc/whereabouts.h"

#include "families/abstractdc/parameters.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace mb::abstractdc {
namespace {

constexpr std::int64_t sameCounts = 2; ///< of a shaft that stands
constexpr double leastElapsed = 0.001; ///< seconds, of the drive

} // namespace

Whereabouts::Whereabouts(const DeviceProfile &profile, std::function<void(const Counters &values)> count)
    : m_profile(profile)
    , m_count(std::move(count))
{
}

// Whether it has restarted

void Whereabouts::silent(bool lineOpen, bool stood)
{
    m_wasSilent = m_wasSilent || lineOpen;
    if (m_first)
        m_before = Place{static_cast<std::int64_t>(m_last.position), stood};
    m_first.reset();
    m_knowsPass = false;
}

Restart Whereabouts::heard(std::int32_t position, Instant now)
{
    if (m_first)
        return Restart::No;
    const bool wasSilent = std::exchange(m_wasSilent, false);
    auto before = std::exchange(m_before, std::nullopt);
    if (const std::int64_t kept = counted(counter::place); kept != 0) { // where an earlier run saw it stand last
        if (!before)
            before = Place{kept, false};
        if (std::abs(kept - position) <= sameCounts) {
            // The time line begins when the computer starts: a moment of an earlier start is longer ago than it looks.
            const Instant time{std::chrono::milliseconds(counted(counter::passedAt))};
            m_passed = Seen{static_cast<double>(counted(counter::passed)), std::min(time, now)};
            m_knowsPass = true;
        }
    }
    const bool startsAnew = std::abs(std::int64_t{position}) <= turnedByHand;
    const bool unmoved = before && before->position == position && position != 0;
    const bool wasAway = before && std::abs(before->position) > turnedByHand;
    if (!startsAnew || unmoved || (!wasSilent && !wasAway))
        return Restart::No;
    const bool isFar = before && before->stood && std::abs(before->position) >= provesPower;
    return wasSilent && isFar ? Restart::Proven : Restart::Maybe;
}

Restart Whereabouts::between(double before, double position, double reach)
{
    return std::abs(position) <= reach && std::abs(position - before) > reach ? Restart::Seen : Restart::No;
}

void Whereabouts::restarted(Instant time)
{
    m_passed = Seen{0.0, time};
    m_knowsPass = true;
}

// Where it is, and where its velocity loop passed

void Whereabouts::located(double position, Instant time, bool passing)
{
    m_last = {position, time};
    if (!m_first)
        m_first = m_last;
    if (!passing)
        return;
    m_passed = m_last;
    m_knowsPass = true;
}

std::optional<Whereabouts::Seen> Whereabouts::lastPass() const
{
    if (m_knowsPass || !m_first)
        return m_knowsPass ? m_passed : std::nullopt;
    return Seen{0.0, m_first->time};
}

Whereabouts::SpeedRange Whereabouts::entrySpeed(double now) const
{
    SpeedRange range{now, now};
    const auto include = [&range](double speed) { range = {std::min(range.low, speed), std::max(range.high, speed)}; };
    if (m_passed)
        include(meanSince(*m_passed).value_or(now));
    if (m_knowsPass || !m_first)
        return range;
    include(0.0);
    include(meanSince(*m_first).value_or(0.0));
    include(meanSince({0.0, m_first->time}).value_or(0.0));
    return range;
}

std::optional<double> Whereabouts::meanSince(const Seen &seen) const
{
    if (seen.position == m_last.position && seen.time == m_last.time)
        return std::nullopt;
    const double seconds = std::chrono::duration<double>(m_last.time - seen.time).count();
    return (m_last.position - seen.position) / std::max(seconds, leastElapsed);
}

void Whereabouts::stands()
{
    const auto passed = lastPass();
    const bool isFar = passed && std::abs(m_last.position) > turnedByHand;
    const std::int64_t place = isFar ? std::llround(m_last.position) : 0;
    const std::int64_t from = isFar ? std::llround(passed->position) : 0;
    if (std::abs(place - counted(counter::place)) <= sameCounts && (!isFar || from == counted(counter::passed)))
        return;
    const auto passedAt = isFar ? std::chrono::ceil<std::chrono::milliseconds>(passed->time.time_since_epoch())
                                : std::chrono::milliseconds(0);
    m_count({{std::string(counter::passed), from}, {std::string(counter::passedAt), passedAt.count()},
        {std::string(counter::place), place}});
}

std::int64_t Whereabouts::counted(std::string_view key) const
{
    const auto found = m_profile.counters.find(std::string(key));
    return found == m_profile.counters.end() ? 0 : found->second;
}

} // namespace mb::abstractdc
