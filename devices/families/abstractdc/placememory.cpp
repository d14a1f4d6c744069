// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/abstractdc/placememory.h"

#include "families/abstractdc/parameters.h"
#include "families/abstractdc/restartsense.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace mb::abstractdc {
namespace {

constexpr std::int64_t sameCounts = 2; ///< of a shaft that stands

} // namespace

PlaceMemory::PlaceMemory(const DeviceProfile &profile, std::function<void(const Counters &values)> count)
    : m_profile(profile)
    , m_count(std::move(count))
{
}

std::optional<std::int64_t> PlaceMemory::place() const
{
    const std::int64_t place = counted(counter::place);
    return place != 0 ? std::optional(place) : std::nullopt;
}

/// The time line begins when the computer starts, so that a moment of an earlier start is longer ago than it looks.
std::optional<EntrySpeed::Seen> PlaceMemory::passed(std::int32_t position, Instant now) const
{
    const auto known = place();
    if (!known || std::abs(*known - position) > sameCounts)
        return std::nullopt;
    const Instant time{std::chrono::milliseconds(counted(counter::passedAt))};
    return EntrySpeed::Seen{static_cast<double>(counted(counter::passed)), std::min(time, now)};
}

void PlaceMemory::stands(std::int32_t position, const std::optional<EntrySpeed::Seen> &passed)
{
    const bool isFar = passed && std::abs(std::int64_t{position}) > RestartSense::turnedByHand;
    const std::int64_t place = isFar ? position : 0;
    const std::int64_t from = isFar ? std::llround(passed->position) : 0;
    if (std::abs(place - counted(counter::place)) <= sameCounts && (!isFar || from == counted(counter::passed)))
        return;
    const auto passedAt = isFar ? std::chrono::ceil<std::chrono::milliseconds>(passed->time.time_since_epoch())
                                : std::chrono::milliseconds(0);
    m_count({{std::string(counter::passed), from}, {std::string(counter::passedAt), passedAt.count()},
        {std::string(counter::place), place}});
}

std::int64_t PlaceMemory::counted(std::string_view key) const
{
    const auto found = m_profile.counters.find(std::string(key));
    return found == m_profile.counters.end() ? 0 : found->second;
}

} // namespace mb::abstractdc
