// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tuning/tunereport.h"

namespace mb::tuning {

/// A number of the model that a tuning stands on. Of a unit of SI, of full duty, or of MotorFound::unit.
struct ModelNumber {
    std::optional<double> value{}; ///< nothing: nobody knows it
    std::optional<double> error{}; ///< its ±; nothing: none is known
};

/// What all that tell a model tell of it (console, window, report).
struct ModelNumbers {
    ModelNumber gain;
    ModelNumber tau;
    ModelNumber delay; ///< of the whole loop
    ModelNumber friction;
    ModelNumber load; ///< that pulls one way
    ModelNumber forward;
    ModelNumber reverse;
    ModelNumber noise;
    ModelNumber latency;
};
[[nodiscard]] ModelNumbers modelNumbers(const TuneReport &report);

} // namespace mb::tuning
