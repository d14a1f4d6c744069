// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/supermodified/protocol.h"
#include "simulation/motormodel.h"

#include <cstdint>
#include <optional>

namespace mb::supermodified::simulation {

/// The motor of one simulated unit and the magnetic encoder on its output shaft, in ticks of the dialect.
class Encoder {
public:
    /// `seed` says how the magnet sits on the shaft.
    Encoder(Dialect dialect, const MotorParameters &motor, double load, std::uint64_t seed);

    [[nodiscard]] MotorModel &motor() { return m_motor; }
    [[nodiscard]] const MotorModel &motor() const { return m_motor; }
    /// What it reads: whole ticks since the beginning.
    [[nodiscard]] std::int64_t ticks() const;
    /// Within one turn.
    [[nodiscard]] int absolutePosition() const;
    /// Of the output shaft itself, ticks/s and ticks.
    [[nodiscard]] double shaftSpeed() const { return m_motor.speed() * ticksPerRadian(); }
    [[nodiscard]] double shaftPosition() const { return m_motor.angle() * ticksPerRadian(); }
    void setReversed() { m_reversed = true; }
    /// It stays where it is.
    void setDead() { m_dead = ticks(); }

private:
    [[nodiscard]] double ticksPerRadian() const;

    Dialect m_dialect;
    MotorModel m_motor;
    double m_gear;
    std::int64_t m_offset;
    bool m_reversed = false;
    std::optional<std::int64_t> m_dead;
};

} // namespace mb::supermodified::simulation
