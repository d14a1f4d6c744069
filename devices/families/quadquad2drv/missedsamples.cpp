// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/quadquad2drv/missedsamples.h"

#include <algorithm>
#include <cmath>

namespace mb::quadquad2drv {
namespace {

constexpr std::uint8_t mostElapsed = 255; ///< it stays there

} // namespace

/// A packet that came garbled was sent, so that the board counts it as told: only the time tells how many there were.
std::uint64_t MissedSamples::before(
    std::optional<std::uint8_t> elapsed, Instant time, Duration period, PacketPort::Damage damage)
{
    const std::optional<Instant> last = std::exchange(m_streamAt, time);
    const bool same = std::exchange(m_period, period) == period;
    const bool goesOn = last && same && period > Duration::zero();
    const std::uint64_t told = elapsed.value_or(0);
    if (elapsed && *elapsed < mostElapsed && damage == PacketPort::Damage::None)
        return 0;
    const double periods
        = goesOn ? static_cast<double>((time - *last).count()) / static_cast<double>(period.count()) : 1.0;
    const auto missing = static_cast<std::uint64_t>(std::max(0.0, std::round(periods) - 1.0));
    const std::uint64_t least = told + (goesOn && damage == PacketPort::Damage::OfStream ? 1U : 0U);
    return std::max(missing, least) - told;
}

std::uint64_t MissedSamples::polled(bool answered)
{
    const std::uint64_t heldUp = std::exchange(m_heldUp, 0);
    return answered ? 0 : heldUp + 1;
}

} // namespace mb::quadquad2drv
