// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"

#include <cstdint>
#include <deque>
#include <optional>
#include <utility>

namespace mb::tuning {

/// Speed out of positions, over the last samples: whole counts a sample are noise.
class SlopeWatch {
public:
    /// Counts per second; 0 until enough came. Samples that came at once tell no speed.
    double add(Instant time, double counts);

private:
    double m_speed = 0.0;
    std::deque<std::pair<Instant, double>> m_points;
};

/// A current above its limit for too long, and the heat of all of it.
class OverloadWatch {
public:
    void add(Instant time, double amperes, double limit);
    /// Nothing flows until the next sample.
    void pause();
    /// How long it has been above, without a break.
    [[nodiscard]] Duration above() const { return m_above; }
    /// ∫i²dt over limit², in seconds at the limit.
    [[nodiscard]] double heat() const { return m_seconds; }

private:
    std::optional<Instant> m_last;
    std::optional<Instant> m_since;
    double m_amperes = 0.0;
    Duration m_above{};
    double m_seconds = 0.0;
};

/// Whether the motor follows its duty: the right way round, and at all.
class MotionWatch {
public:
    /// `breakaway`: duty that moves it; three times as much surely does.
    void duty(Instant time, double fraction, double breakaway);
    void position(Instant time, double counts);
    /// Samples on end that went the other way than the duty pushes, and did not slow down.
    [[nodiscard]] int wrong() const { return m_wrong; }
    /// How long it was pushed much harder than friction without a move.
    [[nodiscard]] Duration stuck() const { return m_stuck; }
    /// The duty that pushes.
    [[nodiscard]] double pushed() const { return m_duty; }

private:
    void pushAnew(Instant time);

    double m_duty = 0.0;
    std::optional<double> m_counts;
    std::optional<Instant> m_pushedAt; ///< with this sign, above the breakaway
    double m_pushedFrom = 0.0;         ///< counts
    bool m_surely = false;             ///< it is pushed much harder than friction
    Instant m_movedAt{};
    double m_movedTo = 0.0;
    Instant m_lastAt{};
    double m_speed = 0.0;      ///< counts/s, between the last two samples
    double m_entrySpeed = 0.0; ///< when the push began: a motor that is braked goes on, but not faster
    int m_wrong = 0;
    Duration m_stuck{};
};

/// A loop that swings itself up, or that hits full duty both ways. A half wave of the error counts when it is larger than the
/// last, or as large while the duty is at its limit: there it cannot grow. One that the target made, by turning, counts only
/// when it is larger than the whole swing of the target.
class OscillationWatch {
public:
    void target(double target);
    void error(double error, double swing, double noise);
    void duty(Instant time, double fraction, double limit);
    /// Zero crossings of the error on end whose half waves count.
    [[nodiscard]] int growing() const { return m_growing; }
    /// Turns of the error, since the target was set.
    [[nodiscard]] int lasting() const { return m_lasting; }
    /// Of these the last ones on end that were broad and became no smaller: it does not come to rest by itself.
    [[nodiscard]] int sustained() const { return m_sustained; }
    /// Changes of direction above half the duty in the last second.
    [[nodiscard]] int flips() const { return static_cast<int>(m_flips.size()); }

private:
    void turn(double error, double swing, double real);

    std::optional<double> m_target;
    bool m_isRising = false;   ///< the target, when it moved last
    bool m_turned = false;     ///< since the error crossed zero last
    bool m_atLimit = false;    ///< the duty was, in this half wave
    bool m_wasAtLimit = false; ///< or in the one before
    bool m_isPositive = false;
    double m_peak = 0.0;
    double m_lastPositive = 0.0; ///< peak of the half wave before: a motor that turns brakes faster than it accelerates
    double m_lastNegative = 0.0;
    int m_growing = 0;
    int m_lasting = 0;
    int m_sustained = 0;
    double m_turnedAt = 0.0;
    double m_stroke = 0.0;   ///< between its last two turns
    bool m_isGoing = false;  ///< the error, to more
    double m_farthest = 0.0; ///< where it has been since it turned
    double m_strongDuty = 0.0;
    std::deque<Instant> m_flips;
};

/// Share of samples that were lost in the last second, of what a whole one brings.
class LossWatch {
public:
    void add(Instant now, std::uint64_t samples, std::uint64_t lost);
    [[nodiscard]] double share() const { return m_share; }

private:
    struct Count {
        Instant at{};
        std::uint64_t samples = 0;
        std::uint64_t lost = 0;
    };
    std::deque<Count> m_counts;
    double m_share = 0.0;
};

} // namespace mb::tuning
