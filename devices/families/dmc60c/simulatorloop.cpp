// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/dmc60c/simulatorloop.h"

#include <algorithm>
#include <cstdlib>
#include <limits>

namespace mb::dmc60c::simulation {
namespace {

constexpr int loopsPerMillisecond = 2;
constexpr int releaseLoops = 50 * loopsPerMillisecond;
constexpr int currentFraction = 16;

std::int64_t limited(std::int64_t value, std::int64_t bound)
{
    return std::clamp(value, -bound, bound);
}

/// Product of a gain and a quantity in throttle units × 65536 × 2^fraction, held within what four of them may add up
/// to.
std::int64_t term(std::int32_t gain, std::int64_t quantity)
{
    constexpr std::int64_t quantityBound = std::int64_t{1} << 32;
    constexpr std::int64_t termBound = std::int64_t{1} << 60;
    const std::int64_t kept = limited(quantity, quantityBound);
    if (gain != 0 && std::abs(kept) > termBound / std::abs(static_cast<std::int64_t>(gain)))
        return (kept > 0) == (gain > 0) ? termBound : -termBound;
    return gain * kept;
}

} // namespace

Gains Gains::of(const ParameterBank &bank, std::uint8_t first)
{
    const auto at = [&](int offset) { return bank.value(static_cast<std::uint8_t>(first + offset)); };
    return {at(0), at(1), at(2), at(3), at(4)};
}

Slot Slot::of(const ParameterBank &bank, int slot)
{
    const std::uint8_t first = slot == 0 ? number::slot0 : number::slot1;
    const auto at = [&](int offset) { return bank.value(static_cast<std::uint8_t>(first + offset)); };
    return {Gains::of(bank, first), at(5), at(6), at(7), at(8), at(9), at(10)};
}

void Pid::preload(const Gains &gains, std::int32_t throttle, int fraction)
{
    if (gains.i != 0)
        m_sum = ((static_cast<std::int64_t>(throttle) << 16) / gains.i) * (std::int64_t{1} << fraction);
}

std::int64_t Pid::step(
    const Gains &gains, std::int64_t setPoint, std::int64_t feedback, std::int32_t allowableError, int fraction)
{
    const std::int64_t error = setPoint - feedback;
    const std::int64_t change = m_primed ? error - m_lastError : 0;
    m_lastError = error;
    m_primed = true;
    std::int64_t sum = term(gains.f, setPoint);
    if (allowableError != 0 && std::abs(error) < allowableError) {
        m_sum = 0;
    } else {
        const std::int64_t bound = gains.iZone != 0 ? gains.iZone : std::numeric_limits<std::int32_t>::max();
        m_sum = limited(m_sum + error, bound);
        sum += term(gains.p, error) + term(gains.i, m_sum) + term(gains.d, change);
    }
    return sum >> (16 + fraction);
}

std::int32_t ramped(std::int32_t present, std::int32_t duty, std::int32_t step)
{
    if (step == 0)
        return duty;
    const std::int64_t low = std::int64_t{present} - step;
    const std::int64_t high = std::int64_t{present} + step;
    return static_cast<std::int32_t>(std::clamp<std::int64_t>(duty, low, high));
}

std::int32_t shaped(const Slot &slot, std::int64_t throttle, std::int32_t present, bool outside)
{
    if (outside && throttle > 0)
        throttle = std::max<std::int64_t>(throttle, slot.forwardNominal);
    if (outside && throttle < 0)
        throttle = std::min<std::int64_t>(throttle, slot.reverseNominal);
    const auto duty = static_cast<std::int32_t>(std::clamp<std::int64_t>(throttle, slot.reverseMax, slot.forwardMax));
    return ramped(present, duty, slot.ramp);
}

void CurrentLimiter::reset()
{
    *this = CurrentLimiter();
}

bool CurrentLimiter::isExceeded(const ParameterBank &bank, std::int64_t magnitude)
{
    const std::int64_t continuous = bank.value(number::continuousLimit);
    const std::int64_t peak = bank.value(number::peakLimit);
    if (continuous >= peak)
        return magnitude > continuous;
    m_loopsAbovePeak = magnitude > peak ? m_loopsAbovePeak + 1 : 0;
    const auto duration = static_cast<int>(bank.raw(number::peakDuration)) * loopsPerMillisecond;
    return m_loopsAbovePeak > duration;
}

std::int32_t CurrentLimiter::step(
    const ParameterBank &bank, std::int32_t demand, std::int32_t present, std::int64_t current)
{
    if (!bank.flag(number::limiterEnable)) {
        reset();
        return demand;
    }
    const std::int64_t magnitude = std::abs(current);
    const Gains gains = Gains::of(bank, number::limiter);
    if (!m_active) {
        if (!isExceeded(bank, magnitude))
            return demand;
        reset();
        m_active = true;
        m_pid.preload(gains, std::abs(present), currentFraction);
    }
    const std::int64_t output = m_pid.step(gains, bank.value(number::continuousLimit), magnitude, 0, currentFraction);
    const std::int64_t allowed = std::clamp<std::int64_t>(output, 0, fullDuty);
    m_loopsBelow = std::abs(demand) <= allowed ? m_loopsBelow + 1 : 0;
    if (m_loopsBelow > releaseLoops)
        reset();
    const auto bound = static_cast<std::int32_t>(allowed);
    return std::clamp(demand, -bound, bound);
}

} // namespace mb::dmc60c::simulation
