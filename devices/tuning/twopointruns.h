// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tuning/identification.h"
#include "tuning/loopfit.h"
#include "tuning/twopointfit.h"

#include <vector>

namespace mb::tuning {

/// The steps that a two-point identification has made, and what they tell beside a model. `drive`: raw P times counts of each step;
/// `isKnown`: so is what a raw gain makes, and the steps were chosen by it.
struct TwoPointRuns {
    std::vector<LoopRun> steps;
    std::vector<LoopRun> creeping; ///< slower than the model needs: they tell what friction holds

    [[nodiscard]] std::vector<LoopRun> all() const;
    /// What holds the motor, P times counts: it rests anywhere up to that, and within a count.
    [[nodiscard]] double holding() const;
    /// Friction makes a smaller step later on its way; only an output that is at its end makes it earlier, by a part of the time that a
    /// larger one takes to its middle, what leads it there included.
    [[nodiscard]] bool isLinear(double drive, bool isKnown) const;
    /// Fit, damping, friction, load and output: docs/tuning-method.md#without-a-duty-command.
    [[nodiscard]] std::vector<Gate> gates(const LoopFit &fit, double drive, bool isKnown) const;
};

/// Share, of what a D makes the motor do, that is not known.
[[nodiscard]] double doubtOf(const LoopFit &fit);
/// Whether the model leaves too much of the steps over, or knows too little of D, to be believed.
[[nodiscard]] bool isDoubtful(const LoopFit &fit);

} // namespace mb::tuning
