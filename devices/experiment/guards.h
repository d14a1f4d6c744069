// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"
#include "async/message.h"
#include "experiment/endreason.h"
#include "experiment/watchers.h"
#include "model/trialtraits.h"

#include <optional>

namespace mb::tuning {

/// Times a speed that is allowed, at which its guard stops.
constexpr double speedMargin = 1.2;

struct Trip {
    EndReason guard = EndReason::User;
    Message detail; ///< one clause with the numbers: "speed 5200 counts/s is above 1.2 × 4000 counts/s"
    Instant at{};   ///< when its condition was fulfilled: the sample, or for time and link the instant
};

/// What the guards know before a motor moves.
struct GuardPlan {
    Envelope envelope;       ///< what is missing is not watched
    double origin = 0.0;     ///< counts, where the motor was at the start
    double swing = 0.0;      ///< |Y − X| in the unit of the mode
    double noise = 0.0;      ///< σ of what is measured, in the same unit
    bool dutyKnown = true;   ///< else a large error on end stands for a duty that pushes
    bool isVelocity = false; ///< the loop's: there a large target does
    double lag = 0.15;       ///< s, in which a braked motor stops where nothing is known of it
    double breakaway = 0.1;  ///< duty that moves it
    Duration late{};         ///< after which a loop of which no duty is told puts out as much; its integral may be slow
    double hottest = 80.0;   ///< °C
    double lowestBus = 0.0;  ///< V
    double highestBus = 1e3; ///< V
    Duration telemetry{};    ///< period of the samples
    Duration command{};      ///< period of the set-points
    Duration longest{};      ///< of the plan, way back included; it may take half as long again
    Duration silence
        = std::chrono::milliseconds(100); ///< without a sample or a position, at least five periods of them
    double mostLost = 0.05;               ///< share of the samples of a second; 1: silence alone counts
};

/// Watches every sample of a moving motor. Pure: samples and instants in, the first trip out; nothing afterwards. A sample
/// is of the axis that moves, in the units of the channels.
class Guards {
public:
    Guards(const GuardPlan &plan, Instant start);

    [[nodiscard]] std::optional<Trip> position(Instant time, double counts);
    [[nodiscard]] std::optional<Trip> velocity(Instant time, double perSecond);
    [[nodiscard]] std::optional<Trip> current(Instant time, double amperes);
    [[nodiscard]] std::optional<Trip> duty(Instant time, double fraction);
    [[nodiscard]] std::optional<Trip> temperature(Instant time, double celsius);
    [[nodiscard]] std::optional<Trip> busVoltage(Instant time, double volts);
    /// Target minus measured value, in the unit of the mode, each time the measured value comes.
    [[nodiscard]] std::optional<Trip> error(Instant time, double error);
    /// What the loop is told to follow from now on, in the same unit.
    void target(double target)
    {
        m_target = target;
        m_oscillation.target(target);
    }
    /// A sample of any channel came while the motor was not driven: between two pushes.
    void rested(Instant time);
    /// `samples` and `lost` since the start, of all channels. Every few milliseconds.
    [[nodiscard]] std::optional<Trip> look(Instant now, std::uint64_t samples, std::uint64_t lost);

private:
    void heard(Instant time) { m_heardAt = std::max(m_heardAt, time); }
    [[nodiscard]] std::optional<Trip> judgeSilence(Instant now);
    [[nodiscard]] std::optional<Trip> trip(EndReason guard, Instant at, Message detail);
    [[nodiscard]] Message underPush(const Message &what) const;
    [[nodiscard]] double pushOf(double error) const;

    GuardPlan m_plan;
    Instant m_start;
    Instant m_heardAt;
    Instant m_positionAt; ///< without it most guards are blind, whatever else is heard
    bool m_tripped = false;
    double m_speed = 0.0;
    double m_target = 0.0;
    SlopeWatch m_slope;
    OverloadWatch m_overload;
    MotionWatch m_motion;
    OscillationWatch m_oscillation;
    LossWatch m_loss;
};

} // namespace mb::tuning
