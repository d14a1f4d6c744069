// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/supermodified/simulatorcontrol.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mb::supermodified::simulation {
namespace {

constexpr std::int64_t stallError = 200; ///< ticks
constexpr int stallLoops = 1953;         ///< 2 s
constexpr double fullDuty = 255.0;

/// 32-bit arithmetic of the AVR: what overflows wraps.
std::int32_t wrapped(std::int64_t value)
{
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(static_cast<std::uint64_t>(value) & 0xFFFFFFFFU));
}

} // namespace

void Control::clear()
{
    m_sum = 0;
    m_lastError = 0;
}

void Control::hold()
{
    m_leastError = 0;
    m_stuckLoops = 0;
}

double Control::step(std::int64_t error)
{
    m_sum = std::clamp(m_sum + error, -m_windup, m_windup);
    const std::int64_t scale = m_dialect == Dialect::D3 ? ticksPerTurn(Dialect::D3) / ticksPerTurn(Dialect::D1) : 1;
    const std::int64_t proportional = m_settings.p * error / scale;
    const std::int64_t derivative = m_settings.d * (error - m_lastError) / scale;
    const std::int64_t integral = wrapped(m_settings.i * m_sum / scale) / 256;
    const std::int32_t out = wrapped(proportional + derivative + integral);
    m_lastError = error;
    watchStall(std::abs(error));
    const double magnitude = std::min(std::abs(static_cast<double>(out)) / 256.0, fullDuty);
    return std::copysign(std::floor(magnitude) / fullDuty, -static_cast<double>(out));
}

void Control::watchStall(std::int64_t error)
{
    if (error < stallError || m_leastError == 0 || error < m_leastError) {
        m_leastError = error < stallError ? 0 : error;
        m_stuckLoops = 0;
        return;
    }
    if (++m_stuckLoops < stallLoops)
        return;
    m_stuckLoops = 0;
    m_leastError = 0;
    m_stalled = true;
}

} // namespace mb::supermodified::simulation
