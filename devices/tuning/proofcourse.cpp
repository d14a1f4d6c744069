// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/proofcourse.h"

#include "model/family.h"

#include <algorithm>

namespace mb::tuning {
namespace {

constexpr double proofSettles
    = 2.5; ///< predicted times to settle that a proof holds its step: twice may pass until it has settled
constexpr double proofCreeps = 2.0;    ///< times of the integral, in which it creeps to its target, at least
constexpr double slowProof = 1.2;      ///< s, that a slow one waits at most beyond what was predicted
constexpr double proofRest = 0.3;      ///< s longer
constexpr double leastProof = 0.7;     ///< s
constexpr double countedProof = 2.0;   ///< s, of a velocity that is counted over edges: swinging grows slowly
constexpr double longestProof = 5.0;   ///< s
constexpr double unknownSettle = 1.5;  ///< s, where none was predicted
constexpr double currentSettles = 4.0; ///< of a current loop
constexpr double leastCurrent = 0.08;  ///< s that it is held
constexpr double longestCurrent = 0.2; ///< s
constexpr double aroundTrial = 1.5;    ///< s, to set it up and to come to rest
constexpr double aroundStep = 0.3;     ///< s before each step

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

double proofHold(Mode loop, const ContinuousGains &gains, const Prediction &predicted)
{
    const double settle = predicted.metrics.settle.value_or(unknownSettle);
    if (loop == Mode::Current)
        return std::clamp(currentSettles * settle, leastCurrent, longestCurrent);
    const double creeps = loop == Mode::Velocity && gains.i > 0.0 ? gains.p / gains.i : 0.0;
    const double least = predicted.shape.windowCounts > 0.0 ? countedProof : leastProof;
    return std::clamp(std::max(std::min(proofSettles * settle, settle + slowProof), proofCreeps * creeps) + proofRest,
        least, longestProof);
}

double proofSeconds(double hold, int repeats)
{
    return aroundTrial + repeats * (aroundStep + 2.0 * hold);
}

ProofCourse courseOf(const ProposalBasis &basis, const Proposal &proposal)
{
    const ContinuousGains &gains = proposal.gains.made;
    const double hold = proofHold(basis.loop, gains, proposal.predicted);
    const bool isCurrent = basis.loop == Mode::Current;
    const int repeats = isCurrent ? currentRepeats(basis.plant.noise, proposal.step) : usualProofs;
    const double resting = isCurrent ? 0.0
        : basis.scale                ? deadband(basis.plant, gains)
                                     : restingError(basis.family, basis.loop, basis.plant, gains, hold).error;
    ProofCourse course;
    course.slot = basis.family.capabilities.gainSlots > 1 ? 1 - basis.slot : basis.slot;
    course.steps = 2 * repeats;
    course.seconds = 2.0 * proofSeconds(hold, repeats);
    course.extent = extentOfProof(basis, proposal.step, hold, repeats);
    course.limits = proofLimits(proposal.predicted.metrics, proposal.step, resting);
    return course;
}

} // namespace mb::tuning
