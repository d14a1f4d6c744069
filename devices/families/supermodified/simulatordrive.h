// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"
#include "families/supermodified/protocol.h"
#include "simulation/motormodel.h"

#include <cstdint>
#include <functional>
#include <optional>

namespace mb::supermodified::simulation {

/// What the loop of the firmware works with. Times of profiles are those it believes in.
struct LoopSettings {
    std::uint16_t p = 0;
    std::uint16_t i = 0;
    std::uint16_t d = 0;
    std::uint32_t acceleration = 0; ///< ticks/s²
    std::uint32_t velocity = 0;     ///< ticks/s
};

/// Motor, encoder on the output shaft, and the loop of README.md#settings: integer PID every 1.024 ms, profiler, stall detection.
/// Computed up to the present only when somebody looks.
class Drive {
public:
    enum class Target { Position, Velocity, ProfiledVelocity, ProfiledPosition };

    Drive(Dialect dialect, const MotorParameters &motor, double load, std::uint64_t seed);

    /// A restart: bridge off, position 0, the bound of the integral from this P.
    void restart(const LoopSettings &settings, Instant now);
    void advance(Instant now);
    void setSettings(const LoopSettings &settings) { m_settings = settings; }

    void start();
    void stop() { setOn(false); }
    void halt();
    /// D1 and D2 keep the set-point (README.md#start).
    void resetPosition();
    void moveTo(std::int64_t position, bool profiled);
    void moveAt(std::int64_t velocity, bool profiled);
    /// The loop's interrupt comes while the encoder is asked (README.md#hang).
    [[nodiscard]] bool isAboutToLoop(Instant now) const;

    [[nodiscard]] bool isOn() const { return m_on; }
    [[nodiscard]] bool isResting() const;
    [[nodiscard]] std::int64_t position() const { return ticks() - m_zero; }
    [[nodiscard]] std::int64_t setPoint() const { return m_setPoint; }
    [[nodiscard]] int absolutePosition() const;
    /// Refreshed ten times a second, in what the firmware takes for ticks/s.
    [[nodiscard]] std::int32_t reportedVelocity() const { return m_reported; }
    [[nodiscard]] double current() const { return m_motor.current(); }
    /// Of the output shaft itself, ticks/s and ticks.
    [[nodiscard]] double shaftSpeed() const { return m_motor.speed() * ticksPerRadian(); }
    [[nodiscard]] double shaftPosition() const { return m_motor.angle() * ticksPerRadian(); }
    [[nodiscard]] MotorModel &motor() { return m_motor; }
    void setEncoderReversed() { m_reversed = true; }
    void setEncoderDead() { m_dead = ticks(); }

    std::function<void(std::uint8_t)> fault; ///< a code; the bridge is off then
    std::function<void(bool)> switched;      ///< the bridge went on or off

private:
    void loop();
    void profile();
    void profilePosition(double step);
    void profileByKnee(double step);
    void setKnee();
    void approach(double target, double most);
    [[nodiscard]] double control();
    void watchStall(std::int64_t error);
    void watchEncoder();
    void measure();
    void setOn(bool on);
    void hold(std::int64_t position);
    [[nodiscard]] std::int64_t ticks() const;
    [[nodiscard]] double ticksPerRadian() const;
    [[nodiscard]] double believedRate() const;

    Dialect m_dialect;
    MotorModel m_motor;
    double m_gear;
    std::int64_t m_offset; ///< how the magnet sits on the shaft
    LoopSettings m_settings;
    bool m_on = false;
    Instant m_next{};
    Target m_target = Target::Position;
    double m_goal = 0.0;  ///< ticks or ticks/s, by target
    double m_exact = 0.0; ///< set-point with its fraction
    double m_pace = 0.0;  ///< ticks/s of the profile
    double m_knee = 0.0;  ///< D1, D2: where it begins to brake
    bool m_braking = false;
    std::int64_t m_setPoint = 0;
    std::int64_t m_zero = 0;
    std::int64_t m_lastError = 0;
    std::int64_t m_sum = 0;
    std::int64_t m_windup = 0;
    double m_duty = 0.0;
    std::int64_t m_leastError = 0;
    int m_stuckLoops = 0;
    int m_sinceMeasure = 0;
    std::int64_t m_measuredAt = 0;
    std::int32_t m_reported = 0;
    bool m_reversed = false;
    std::optional<std::int64_t> m_dead;
};

} // namespace mb::supermodified::simulation
