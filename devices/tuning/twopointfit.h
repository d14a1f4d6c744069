// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/result.h"
#include "experiment/trial.h"

#include <cmath>
#include <optional>
#include <span>
#include <vector>

namespace mb::tuning {

/// One step of a position loop with known raw gains, from rest.
struct LoopRun {
    double p = 0.0;
    double d = 0.0;
    double step = 0.0; ///< counts from where it stood to its target, sign included
    Trace way;         ///< counts from where it stood; t = 0 at the order
    double rate = 0.0; ///< counts/s, with which its set-point goes there; 0: at once
    double from = 0.0; ///< counts from where it stood to where its set-point did

    /// It was first seen later than it was asked: the line had lost an answer, and the order may have waited for the next.
    [[nodiscard]] bool hasWaited() const;
    /// s that its set-point is on its way.
    [[nodiscard]] double rise() const { return rate > 0.0 ? std::abs(step - from) / rate : 0.0; }
};

/// The ways of a trial to its target and back, with these gains in force. None for what did not move.
[[nodiscard]] std::vector<LoopRun> runsOf(const Trial &trial, double p, double d, double rate = 0.0);

/// Signed P times counts that a run leaves at its end.
[[nodiscard]] double leftOf(const LoopRun &run);
/// When it passed the middle of its way, s after its set-point; never: when it was last seen.
[[nodiscard]] double halfWay(const LoopRun &run);

/// One run as a system of second order.
struct StepFit {
    double omega = 0.0; ///< rad/s
    double zeta = 0.0;
    double end = 0.0;      ///< where it ends, of its step
    double residual = 0.0; ///< RMS, of its step
};
/// Nothing for fewer than eight samples.
[[nodiscard]] std::optional<StepFit> fitStep(const LoopRun &run);

/// What runs with different gains have in common: y'' + (drag + d·D)·y' + p·P·y = p·P·r with t counted from the delay on, each
/// run with an end of its own. Friction is spread over the three: each alone may be far off, together they tell how the loop
/// moves with other gains.
struct TwoPointFit {
    double p = 0.0;        ///< 1/s² per raw P
    double d = 0.0;        ///< 1/s per raw D
    double drag = 0.0;     ///< 1/s, of the motor alone
    double delay = 0.0;    ///< s, what the link takes included
    double residual = 0.0; ///< RMS of what is left over, of a step
};
/// OutOfRange where the runs have one P or one D only, or too few samples.
[[nodiscard]] Result<TwoPointFit> fitTwoPoint(std::span<const LoopRun> runs);

/// s that a search of a delay takes for 1.
constexpr double delayUnit = 0.01;
/// s, of what such a search has found: within what a link and a loop can take.
[[nodiscard]] double delayOf(double number);

/// The step response of s² + drag·s + stiffness, from 0 to 1; 0 before its time.
[[nodiscard]] double stepOfSecondOrder(double drag, double stiffness, double t);
/// The same to a set-point that needs `rise` s to get there, and of whose speed the loop makes as much as `lead` s of it make.
[[nodiscard]] double rampOfSecondOrder(double drag, double stiffness, double lead, double t, double rise);

} // namespace mb::tuning
