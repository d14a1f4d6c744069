// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiment/trial.h"

#include <optional>

namespace mb::tuning {

/// One way of a duty that grows slowly from nothing. Duties are of full duty at the supply at rest, without their sign.
struct RampWay {
    double breakaway = 0.0;      ///< at which the motor let go
    double breakawayError = 0.0; ///< whole counts hide the first of its way
    double friction = 0.0;       ///< that it takes while the motor turns; a load that pulls one way is in it
    double frictionError = 0.0;
    double gain = 0.0;          ///< counts/s per duty beyond friction
    double determination = 0.0; ///< R² of the regression

    friend bool operator==(const RampWay &, const RampWay &) = default;
};

/// A ramp each way.
struct RampFound {
    RampWay forward;
    RampWay reverse;

    [[nodiscard]] double friction() const { return 0.5 * (forward.friction + reverse.friction); }
    /// Of friction(), from both.
    [[nodiscard]] double error() const;
    /// That a load takes which always pulls one way.
    [[nodiscard]] double offset() const { return 0.5 * (forward.friction - reverse.friction); }
    /// The smaller R² of both.
    [[nodiscard]] double determination() const;
    /// Its friction is to be believed: R² of 0.98, and within a tenth the gain (counts/s per duty) that pushes have shown. A motor whose
    /// friction lets go late fails it.
    [[nodiscard]] bool agreesWith(double gain) const;

    friend bool operator==(const RampFound &, const RampFound &) = default;
};

/// What is known of a motor before its ramp.
struct RampedMotor {
    double tau = 0.0;    ///< s
    double delay = 0.0;  ///< s from an order until its position shows it
    double beat = 0.0;   ///< s between orders
    double noise = 0.0;  ///< counts, σ at rest
    double supply = 0.0; ///< V at rest; 0: not told
};

/// Regression on integrals, nothing is differentiated twice: ∫u dt = friction·t + (way + τ·speed)/gain, from where the motor makes a tenth
/// of its last speed. Nothing where it did not move, or too few samples saw it.
[[nodiscard]] std::optional<RampWay> readRamp(const Trial &ramp, const RampedMotor &motor);

} // namespace mb::tuning
