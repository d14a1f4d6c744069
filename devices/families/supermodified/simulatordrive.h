// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"
#include "families/supermodified/simulatorcontrol.h"
#include "families/supermodified/simulatorencoder.h"
#include "families/supermodified/simulatorprofile.h"

#include <cstdint>
#include <functional>

namespace mb::supermodified::simulation {

/// The bridge and the loop of README.md#settings, every 1.024 ms: profiler, integer PID, and what watches stall and encoder.
/// Computed up to the present only when somebody looks.
class Drive {
public:
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
    void moveAt(std::int64_t velocity, bool profiled) { m_profile.moveAt(velocity, profiled); }
    /// The loop's interrupt comes while the encoder is asked (README.md#hang).
    [[nodiscard]] bool isAboutToLoop(Instant now) const;

    [[nodiscard]] bool isOn() const { return m_on; }
    [[nodiscard]] bool isResting() const { return !m_on && m_encoder.motor().speed() == 0.0; }
    [[nodiscard]] std::int64_t position() const { return m_encoder.ticks() - m_zero; }
    [[nodiscard]] std::int64_t setPoint() const { return m_profile.setPoint(); }
    /// Refreshed ten times a second, in what the firmware takes for ticks/s.
    [[nodiscard]] std::int32_t reportedVelocity() const { return m_reported; }
    [[nodiscard]] Encoder &encoder() { return m_encoder; }
    [[nodiscard]] MotorModel &motor() { return m_encoder.motor(); }

    std::function<void(std::uint8_t)> fault; ///< a code; the bridge is off then
    std::function<void(bool)> switched;      ///< the bridge went on or off

private:
    void zero();
    void loop();
    void watchEncoder();
    void measure();
    void setOn(bool on);
    void hold(std::int64_t position);

    Dialect m_dialect;
    Encoder m_encoder;
    LoopSettings m_settings;
    Profile m_profile;
    Control m_control;
    bool m_on = false;
    Instant m_next{};
    std::int64_t m_zero = 0;
    double m_duty = 0.0;
    int m_sinceMeasure = 0;
    std::int64_t m_measuredAt = 0;
    std::int32_t m_reported = 0;
};

} // namespace mb::supermodified::simulation
