// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/abstractdc/powercycledebt.h"

#include "families/abstractdc/parameters.h"

#include <cstdlib>
#include <utility>

namespace mb::abstractdc {
namespace {

constexpr std::int64_t turnedByHand = 100; ///< counts, between switching on and the first question

} // namespace

PowerCycleDebt::PowerCycleDebt(const DeviceProfile &profile, std::function<void(std::int64_t)> keep)
    : m_profile(profile)
    , m_keep(std::move(keep))
{
}

bool PowerCycleDebt::isOwed() const
{
    const auto owed = m_profile.counters.find(std::string(counter::powerCycle));
    return owed != m_profile.counters.end() && owed->second != 0;
}

void PowerCycleDebt::silent(bool linkOpen, std::optional<std::int64_t> position)
{
    m_wasUnheard = true;
    m_wasSilent = m_wasSilent || linkOpen;
    if (position)
        m_positionBefore = position;
}

bool PowerCycleDebt::heard(std::int32_t position)
{
    if (!std::exchange(m_wasUnheard, false))
        return false;
    const bool wasSilent = std::exchange(m_wasSilent, false);
    const bool startsAnew = std::abs(std::int64_t{position}) <= turnedByHand;
    const bool unmoved = m_positionBefore && *m_positionBefore == position && position != 0;
    m_positionBefore.reset();
    if (!startsAnew || unmoved)
        return false;
    if (wasSilent && isOwed())
        m_keep(0);
    return true;
}

} // namespace mb::abstractdc
