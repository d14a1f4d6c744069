// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/supermodified/protocol.h"

#include <cstdint>

namespace mb::supermodified::simulation {

/// What the loop of the firmware works with. Times of profiles are those it believes in.
struct LoopSettings {
    std::uint16_t p = 0;
    std::uint16_t i = 0;
    std::uint16_t d = 0;
    std::uint32_t acceleration = 0; ///< ticks/s²
    std::uint32_t velocity = 0;     ///< ticks/s
};

/// How often the firmware believes that its loop runs, Hz.
[[nodiscard]] double believedRate(Dialect dialect);

/// The profiler: where the set-point is in each loop, on its way to the target. Ticks.
class Profile {
public:
    /// The settings outlive it.
    Profile(Dialect dialect, const LoopSettings &settings)
        : m_dialect(dialect)
        , m_settings(settings)
    {
    }

    /// At once.
    void hold(std::int64_t position);
    void moveTo(std::int64_t position);
    void moveAt(std::int64_t velocity, bool profiled);
    /// One loop.
    void step();
    [[nodiscard]] std::int64_t setPoint() const { return m_setPoint; }

private:
    enum class Target { Position, Velocity, ProfiledVelocity, ProfiledPosition };

    void stepPosition(double step);
    void stepByKnee(double step);
    void setKnee();
    void arrive();
    void approach(double target, double most);

    Dialect m_dialect;
    const LoopSettings &m_settings;
    Target m_target = Target::Position;
    double m_goal = 0.0;  ///< ticks or ticks/s, by target
    double m_exact = 0.0; ///< set-point with its fraction
    double m_pace = 0.0;  ///< ticks/s
    double m_knee = 0.0;  ///< D1, D2: where it begins to brake
    double m_ahead = 1.0; ///< 1 or -1, the way of the move
    bool m_braking = false;
    std::int64_t m_setPoint = 0;
};

} // namespace mb::supermodified::simulation
