// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/abstractdc/restartsense.h"

#include <cmath>
#include <cstdlib>
#include <utility>

namespace mb::abstractdc {
void RestartSense::silent(bool lineOpen, std::optional<std::int64_t> position, bool stood)
{
    m_wasUnheard = true;
    m_wasSilent = m_wasSilent || lineOpen;
    if (position)
        m_before = Place{*position, stood};
}

Restart RestartSense::heard(std::int32_t position, std::optional<std::int64_t> kept)
{
    if (!std::exchange(m_wasUnheard, false))
        return Restart::No;
    const bool wasSilent = std::exchange(m_wasSilent, false);
    auto before = std::exchange(m_before, std::nullopt);
    if (!before && kept)
        before = Place{*kept, false};
    const bool startsAnew = std::abs(std::int64_t{position}) <= turnedByHand;
    const bool unmoved = before && before->position == position && position != 0;
    const bool wasAway = before && std::abs(before->position) > turnedByHand;
    if (!startsAnew || unmoved || (!wasSilent && !wasAway))
        return Restart::No;
    const bool isFar = before && before->stood && std::abs(before->position) >= provesPower;
    return wasSilent && isFar ? Restart::Proven : Restart::Maybe;
}

Restart RestartSense::between(double before, double position, double reach)
{
    return std::abs(position) <= reach && std::abs(position - before) > reach ? Restart::Seen : Restart::No;
}

} // namespace mb::abstractdc
