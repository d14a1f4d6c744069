// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/supermodified/simulatorencoder.h"

#include <cmath>
#include <numbers>

namespace mb::supermodified::simulation {

Encoder::Encoder(Dialect dialect, const MotorParameters &motor, double load, std::uint64_t seed)
    : m_dialect(dialect)
    , m_motor(motor, load)
    , m_gear(motor.gearRatio)
    , m_offset(static_cast<std::int64_t>(seed * 997U % static_cast<std::uint64_t>(ticksPerTurn(dialect))))
{
}

double Encoder::ticksPerRadian() const
{
    return ticksPerTurn(m_dialect) / (2.0 * std::numbers::pi * m_gear);
}

std::int64_t Encoder::ticks() const
{
    if (m_dead)
        return *m_dead;
    const double exact = m_motor.angle() * ticksPerRadian();
    return static_cast<std::int64_t>(std::floor(m_reversed ? -exact : exact));
}

int Encoder::absolutePosition() const
{
    const std::int64_t turn = ticksPerTurn(m_dialect);
    return static_cast<int>(((ticks() + m_offset) % turn + turn) % turn);
}

} // namespace mb::supermodified::simulation
