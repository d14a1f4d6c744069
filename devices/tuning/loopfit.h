// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tuning/gainscale.h"
#include "tuning/twopointfit.h"

namespace mb::tuning {

constexpr double cyclesOfDelay = 1.5; ///< of the delay of such a loop; the rest is its motor's winding

/// What is known beforehand of a loop that steps with raw gains.
struct LoopLaw {
    TriedScale scale;     ///< what its gains make; of D only a first guess unless `isKnown`
    bool isKnown = false; ///< as its firmware has it: what D makes, and that its output ends at full duty
};

/// A motor with its friction, as steps of its own position loop show it.
struct LoopFit {
    PlantModel plant;       ///< gain, tau, friction, braking; no delay
    double shift = 0.0;     ///< s from an order to the first that it does, what the link takes included
    double winding = 0.0;   ///< LoopShape::winding
    double d = 0.0;         ///< TriedScale::d
    double pushError = 0.0; ///< share of gain over tau, two standard errors
    double gainError = 0.0; ///< ± two standard errors
    double tauError = 0.0;
    double shiftError = 0.0;
    double dError = 0.0;   ///< 0 where it is known
    double residual = 0.0; ///< RMS of what is left over, of a step
};

/// Runs with different gains, simulated with friction, braking, winding and the end of the output, and moved until they are those that were
/// measured: those whose order waited behind a lost answer, by that wait as well. `first` is where the search begins. OutOfRange where
/// there are too few of them. Half a second of a processor.
[[nodiscard]] Result<LoopFit> fitLoop(std::span<const LoopRun> runs, const LoopLaw &law, const TwoPointFit &first);

} // namespace mb::tuning
