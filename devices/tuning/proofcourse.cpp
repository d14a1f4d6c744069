// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/proofcourse.h"

#include "model/family.h"

#include <algorithm>

namespace mb::tuning {
namespace {

constexpr double aroundTrial = 1.5; ///< s, to set it up and to come to rest
constexpr double aroundStep = 0.3;  ///< s before each step

/// As each way is announced when it is run.
Extent extentOfProof(const ProposalBasis &basis, double step, double hold, int repeats)
{
    ExperimentPlan plan;
    plan.mode = basis.loop;
    plan.repeat = repeats;
    Trial trial;
    trial.envelope = basis.envelope;
    trial.stimulus.to = step;
    trial.stimulus.time = hold;
    return extentOf(plan, trial, 0.0, basis.loop == Mode::Current ? 0.0 : basis.plant.gain);
}

} // namespace

double proofSeconds(double hold, int repeats)
{
    return aroundTrial + repeats * (aroundStep + 2.0 * hold);
}

ProofCourse courseOf(const ProposalBasis &basis, const Proposal &proposal)
{
    const ContinuousGains &gains = proposal.gains.made;
    const double hold = proofHold(basis.loop, gains, proposal.predicted);
    const bool isCurrent = basis.loop == Mode::Current;
    const int repeats = isCurrent
        ? currentRepeats(basis.plant.noise, proposal.step)
        : repeatsWithin(basis.envelope.travel, basis.loop, basis.plant, proposal.step, hold, usualProofs);
    const double resting = isCurrent ? 0.0
        : basis.scale                ? deadband(basis.plant, gains)
                      : restingError(basis.loop, proposal.predicted.shape, basis.plant, gains, hold).error;
    ProofCourse course;
    course.slot = basis.family.capabilities.gainSlots > 1 ? 1 - basis.slot : basis.slot;
    course.steps = 2 * repeats;
    course.seconds = 2.0 * proofSeconds(hold, repeats);
    course.extent = extentOfProof(basis, proposal.step, hold, repeats);
    course.limits = proofLimits(proposal.predicted.metrics, proposal.step, resting);
    return course;
}

} // namespace mb::tuning
