// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/proposals.h"

#include "experiment/envelope.h"
#include "experiment/figures.h"
#include "experiment/seconds.h"
#include "model/family.h"
#include "tuning/aside.h"
#include "tuning/gainsearch.h"
#include "tuning/loopfit.h"
#include "tuning/proof.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

namespace mb::tuning {
namespace {

constexpr double integralShare = 0.1; ///< weight of the integral where friction must be overcome by it
constexpr double usualMs = 1.6;       ///< largest sensitivity, of the model
constexpr double usualMsOff = 1.88;   ///< and of a motor not quite as it says; 1.9, less what that is off by
constexpr double briskMs = largestMs;
constexpr double briskMsOff = 2.3;
constexpr double currentOfStall = 0.15;   ///< that a proof of a current loop asks for
constexpr double clearCurrent = 1.5;      ///< A, or this much
constexpr double currentOfLimit = 0.3;    ///< of stall and limit, at most
constexpr double currentPrediction = 0.2; ///< s
constexpr double longestShown = 30.0;     ///< s
constexpr int smallerSteps = 32;
constexpr double vanishedStep = 1.0;      ///< that is none any more
constexpr double dutyOfStep = 0.95;       ///< of what is allowed, that a step of a loop which nothing bounds puts out
constexpr double wayOfStep = 0.6;         ///< of the travel, that it goes one way at most
constexpr double overshootOfDoubt = 0.02; ///< more than of the model itself, as the search allows
constexpr double lessForRounding = 0.995; ///< where rounding has taken a margin
constexpr int mostRoundings = 40;
constexpr double clearSteps = 12.0; ///< of a gain: fewer than ten mean nothing
constexpr double alikeSteps = 0.01; ///< of the step

double cycleOf(const ProposalBasis &basis)
{
    if (basis.scale)
        return basis.scale->cycle;
    return basis.family.loop ? basis.family.loop->cycle : 0.0;
}

LoopBounds boundsOf(const ProposalBasis &basis)
{
    LoopBounds bounds;
    bounds.period = cycleOf(basis);
    if (basis.scale)
        bounds.derivativeShare = basis.scale->strongest * basis.scale->d / bounds.period;
    else if (basis.loop == Mode::Position && !hasFrictionHelp(basis.family))
        bounds.integralWeight = integralShare;
    return bounds;
}

/// Of the step, that an aim allows itself; a position that takes more of it answers the set-points of a hand one by one.
double overshootOf(Mode loop, const ProposalWish &wish)
{
    const bool more = wish.isProven && loop != Mode::Position && wish.aim != Aim::Calm;
    return std::array<double, 3>{0.005, 0.03, 0.035}[static_cast<std::size_t>(wish.aim)] + (more ? 0.01 : 0.0);
}

double allowedDuty(const ProposalBasis &basis)
{
    return basis.envelope.duty.value_or(1.0);
}

/// Duty that the unit keeps its loop to: what its slot is told with the gains, else a limit that it has.
double heldDuty(const ProposalBasis &basis)
{
    if (basis.scale || !basis.family.trials || hasOutputLimits(basis.family))
        return allowedDuty(basis);
    const Envelope own = ownLimits(basis.family, basis.entries, basis.axis, basis.slot, 0.0);
    return std::max(own.duty.value_or(1.0), allowedDuty(basis));
}

LoopShape shapeOf(const ProposalBasis &basis)
{
    if (basis.family.loop && !basis.scale && basis.loop != Mode::Current) {
        Envelope held = basis.envelope;
        held.duty = heldDuty(basis);
        return tuning::shapeOf(basis.family, basis.loop, basis.plant, held, basis.taking);
    }
    LoopShape plain;
    plain.period = predictionPeriod(basis);
    plain.mostDuty = heldDuty(basis);
    plain.isCounted = basis.scale.has_value();
    if (basis.scale) {
        plain.setPointRate = basis.scale->rate;
        plain.winding = std::max(basis.plant.delay - cyclesOfDelay * basis.scale->cycle, 0.0);
    }
    return plain;
}

/// The loop with what its parameters bound it by, in place of what a proposal would.
LoopShape shapeWith(const ProposalBasis &basis, const ScaledGains &gains)
{
    LoopShape shape = shapeOf(basis);
    if (!basis.family.loop || basis.loop != Mode::Position)
        return shape;
    shape.integralMost = shape.leastOutput = shape.goodEnough = 0.0;
    const double full = basis.family.loop->fullDuty;
    for (const ScaledGains::Row &row : gains.rows) {
        if (row.role == Role::IntegralLimit)
            shape.integralMost = row.number / full;
        else if (row.role == Role::LeastForward)
            shape.leastOutput = row.number / full;
        else if (row.role == Role::AllowableError)
            shape.goodEnough = row.number;
    }
    return shape;
}

double secondsOfPrediction(const ProposalBasis &basis)
{
    return basis.loop == Mode::Current ? currentPrediction
                                       : std::min(1.0 + 10.0 * (basis.plant.tau + basis.plant.delay), longestShown);
}

/// The smallest gains that the device has steps enough for; 0 for what it cannot have at all.
ContinuousGains leastOf(const ProposalBasis &basis, const ContinuousGains &gains)
{
    ContinuousGains least;
    const auto scaled = scaleGains(basis.family, basis.profile, basis.loop, basis.axis, basis.slot, gains, basis.scale);
    if (!scaled)
        return least;
    for (const auto &[role, gain] : {std::pair(Role::Proportional, &ContinuousGains::p),
             std::pair(Role::Integral, &ContinuousGains::i), std::pair(Role::Derivative, &ContinuousGains::d)}) {
        for (const ScaledGains::Row &row : scaled->rows) {
            if (row.role == role && row.raw != 0)
                least.*gain = scaled->made.*gain * clearSteps / std::abs(static_cast<double>(row.raw));
        }
    }
    return least;
}

void limitOutput(const ProposalBasis &basis, ScaledGains &into)
{
    const KnownGains now = knownGains(basis.family, basis.loop, basis.axis, basis.slot, basis.entries);
    tuning::limitOutput(basis.family, basis.loop, basis.axis, basis.slot, allowedDuty(basis), now, into);
}

/// With what a loop needs beside its gains.
Result<ScaledGains> parametersOf(const ProposalBasis &basis, const Design &design)
{
    auto scaled
        = scaleGains(basis.family, basis.profile, basis.loop, basis.axis, basis.slot, design.gains, basis.scale);
    if (scaled) {
        addFrictionHelp(basis.family, basis.loop, basis.axis, basis.slot, basis.plant, *scaled);
        freeIntegral(basis.family, basis.loop, basis.axis, basis.slot, *scaled);
        limitOutput(basis, *scaled);
    }
    return scaled;
}

/// Before a limit of the current makes it smaller.
double usualStep(const ProposalBasis &basis, const ContinuousGains &gains)
{
    return basis.loop == Mode::Current ? currentStep(basis.plant.gain, basis.envelope)
                                       : proofStep(basis.loop, basis.plant, gains, basis.envelope);
}

/// By the rule alone.
Design ruleFor(const ProposalBasis &basis, const ProposalWish &wish, const LoopBounds &bounds)
{
    const MsBounds ms = msBoundsOf(wish);
    const double response = wish.response.value_or(responseOf(basis.loop, wish.aim, basis.plant));
    return design(basis.loop, basis.plant, std::max(response, basis.scale ? basis.scale->quickest : 0.0), bounds,
        ms.model, ms.off);
}

} // namespace

double currentStep(double stall, const Envelope &envelope)
{
    return std::min({std::max(currentOfStall * stall, clearCurrent), currentOfLimit * stall,
        currentOfLimit * envelope.current.value_or(stall)});
}

MsBounds msBoundsOf(const ProposalWish &wish)
{
    const bool brisk = wish.aim == Aim::Brisk && !wish.ms;
    const double model = wish.ms.value_or(brisk ? briskMs : usualMs);
    return {model, std::min(model * (brisk ? briskMsOff / briskMs : usualMsOff / usualMs), briskMsOff)};
}

double predictionPeriod(const ProposalBasis &basis)
{
    return std::clamp(cycleOf(basis), 1e-4, 0.025);
}

namespace {

std::optional<ProfileLimits> profileOf(const ProposalBasis &basis)
{
    if (basis.loop == Mode::Current)
        return std::nullopt;
    return profileLimits(basis.plant, basis.envelope.duty.value_or(1.0));
}

/// Less of all gains until those that the device stores have their margin: rounding makes more of some.
Result<void> lessenForRounding(const ProposalBasis &basis, const PlantModel &plant, const MsBounds &ms, Design &design)
{
    for (int i = 0; i < mostRoundings; ++i) {
        MB_TRY(const auto rounded, parametersOf(basis, design));
        if (hasMargin(basis.loop, plant, rounded.made, ms.model, ms.off))
            return {};
        for (const auto gain : {&ContinuousGains::p, &ContinuousGains::i, &ContinuousGains::d})
            design.gains.*gain *= lessForRounding;
    }
    return fail(Fault::OutOfRange,
        say("no gains as the device stores them keep a largest sensitivity of %1 in this loop", ms.model),
        say("take a finer encoder or a calmer loop"));
}

/// What a step makes of something that is bounded, over what it may.
struct Need {
    double share = 0.0;
    double least = 0.0; ///< step, below which there is none
    Error refusal{};
};

Need needOfCurrent(const ProposalBasis &basis, const Proposal &proposal)
{
    const double most = basis.envelope.current.value_or(std::numeric_limits<double>::infinity());
    return {proposal.predicted.metrics.peakCurrent.value_or(0.0) / most, vanishedStep,
        Error{Fault::OutOfRange, say("any step of these gains draws more than the %1 A that are allowed", most),
            say("allow more current or aim for a calmer loop")}};
}

double peakDuty(const Prediction &predicted)
{
    double peak = 0.0;
    for (const double duty : predicted.duty.y)
        peak = std::max(peak, std::abs(duty));
    return peak;
}

/// Where nothing in the unit keeps its loop to the duty that is allowed.
Need needOfDuty(const ProposalBasis &basis, const Proposal &proposal)
{
    const double most = allowedDuty(basis);
    if (heldDuty(basis) <= most)
        return {};
    const double peak = peakDuty(proposal.predicted);
    const double least = leastProofStep(basis.family, basis.loop, basis.plant, proposal.gains.made);
    return {peak / (dutyOfStep * most), least,
        Error{Fault::OutOfRange,
            say("the smallest step that proves these gains puts out %1 duty, %2 are allowed, and the unit has no "
                "limit of its own that keeps it to them",
                percentText(std::min(peak * least / proposal.step / dutyOfStep, 1.0)), percentText(most)),
            say("allow more duty or aim for a calmer loop")}};
}

/// Of a velocity loop, which goes on one way as long as its step is held.
Need needOfTravel(const ProposalBasis &basis, const Proposal &proposal)
{
    if (basis.loop != Mode::Velocity || !basis.envelope.travel)
        return {};
    const double hold = proofHold(basis.loop, proposal.gains.made, proposal.predicted);
    const double way = wayOfProof(basis.plant, proposal.step, hold, 1) / wayOfStep;
    const double least = leastProofStep(basis.family, basis.loop, basis.plant, proposal.gains.made);
    return {way / *basis.envelope.travel, least,
        Error{Fault::OutOfRange,
            say("the smallest step that proves these gains takes %1 counts of travel, %2 are allowed",
                std::ceil(way * least / proposal.step), *basis.envelope.travel),
            say("allow more travel")}};
}

/// Parameters, margins and prediction of designed gains; a step that would draw more than its limit, put out more or go farther is made
/// smaller. A current loop makes the step of its own plant.
Result<void> finish(const ProposalBasis &basis, double step, Proposal &proposal)
{
    const PlantModel &plant = basis.plant;
    MB_TRY(auto parameters, parametersOf(basis, proposal.design));
    proposal.gains = std::move(parameters);
    const ContinuousGains &gains = proposal.gains.made;
    const LoopShape shape = shapeOf(basis);
    proposal.margins = marginsOf(basis.loop, plant, gains);
    proposal.profile = profileOf(basis);
    proposal.step = basis.loop == Mode::Current ? usualStep(basis, gains) : step;
    const double seconds = secondsOfPrediction(basis);
    Need worst = needOfCurrent(basis, proposal);
    const double most = basis.envelope.current.value_or(std::numeric_limits<double>::infinity());
    const double breaksLoose = plant.stallCurrent * plant.friction; // A: with less it stands
    for (int i = 0; i < smallerSteps && breaksLoose < most; ++i) {
        proposal.predicted = predictStep(basis.loop, plant, gains, 0.0, proposal.step, seconds, shape);
        worst = std::max({needOfCurrent(basis, proposal), needOfDuty(basis, proposal), needOfTravel(basis, proposal)},
            [](const Need &a, const Need &b) { return a.share < b.share; });
        if (worst.share <= 1.0)
            return {};
        proposal.step = std::round(0.98 * proposal.step / worst.share);
        if (proposal.step < worst.least)
            break;
    }
    return tl::unexpected(worst.refusal);
}

} // namespace

Result<Proposal> proposalFor(const ProposalBasis &basis, const ProposalWish &wish)
{
    const PlantModel &plant = basis.plant;
    const MsBounds ms = msBoundsOf(wish);
    Proposal proposal;
    proposal.aim = wish.aim;
    proposal.design = ruleFor(basis, wish, boundsOf(basis));
    SearchTask task{boundsOf(basis), ms.model, ms.off, wish.step, overshootOf(basis.loop, wish), wish.aim == Aim::Calm,
        inSeconds(basis.family.capabilities.commandPeriod), {}, shapeOf(basis)};
    if (task.step == 0.0)
        task.step = usualStep(basis, proposal.design.gains);
    task.bounds.largestError = task.step;
    const bool rules = wish.response || wish.ms || (basis.loop == Mode::Current && wish.aim == Aim::Calm);
    if (!rules) {
        task.least = leastOf(basis, proposal.design.gains);
        task.isProven = wish.isProven;
        task.steepest = wish.steepest;
        task.quickest = basis.scale ? basis.scale->quickest : 0.0;
        proposal.design = searched(basis.loop, plant, proposal.design, task);
    }
    if (!isWithin(proposal.design.gains, task.bounds)) // nobody knew its step yet
        proposal.design = ruleFor(basis, wish, task.bounds);
    MB_TRY_VOID(lessenForRounding(basis, atLeastAsSteep(plant, wish.steepest), ms, proposal.design));
    MB_TRY_VOID(finish(basis, task.step, proposal));
    return proposal;
}

namespace {

/// What of the bounds of every proposal these do not keep.
Message beyondBounds(const ProposalBasis &basis, const Proposal &former)
{
    const ProposalWish wish{Aim::Brisk, {}, {}};
    const MsBounds ms = msBoundsOf(wish);
    LoopBounds bounds = boundsOf(basis);
    bounds.largestError = former.step;
    if (!isWithin(former.gains.made, bounds))
        return say("a count or their largest error makes more output than it may");
    if (!hasMargin(basis.loop, basis.plant, former.gains.made, ms.model, ms.off))
        return say("their largest sensitivity is %1, at most %2 are allowed, and %3 with more gain and delay",
            std::round(100.0 * former.margins.ms) / 100.0, ms.model, ms.off);
    const Metrics &metrics = former.predicted.metrics;
    if (const double share = metrics.overshoot.value_or(1.0); share > overshootOf(basis.loop, wish) + overshootOfDoubt)
        return say("they would overshoot by %1", percentText(share));
    if (needOfCurrent(basis, former).share > 1.0)
        return say("they would draw more current than is allowed");
    if (needOfDuty(basis, former).share > 1.0)
        return say("they would put out more duty than is allowed");
    return {};
}

} // namespace

std::optional<FormerProposal> formerProposal(const ProposalBasis &basis, const KnownGains &numbers, double step)
{
    auto made = gainsMadeBy(basis.family, basis.profile, basis.loop, basis.axis, basis.slot, numbers, basis.scale);
    if (!made || made->made.p <= 0.0)
        return std::nullopt;
    limitOutput(basis, *made);
    FormerProposal former;
    Proposal &proposal = former.proposal;
    proposal.design.gains = made->made;
    proposal.margins = marginsOf(basis.loop, basis.plant, made->made);
    proposal.step = step;
    proposal.profile = profileOf(basis);
    proposal.predicted = predictStep(
        basis.loop, basis.plant, made->made, 0.0, step, secondsOfPrediction(basis), shapeWith(basis, *made));
    proposal.gains = std::move(*made);
    former.beyond = beyondBounds(basis, proposal);
    return former;
}

double promisedError(const ProposalBasis &basis, const ContinuousGains &gains, const LoopShape &shape, double step)
{
    SearchTask task;
    task.step = step;
    task.shape = shape;
    return errorOfSteps(basis.loop, basis.plant, gains, task);
}

Result<Proposal> movedTo(const ProposalBasis &basis, Proposal proposal)
{
    const Design rule = ruleFor(basis, {proposal.aim, {}, {}}, boundsOf(basis));
    MB_TRY_VOID(finish(basis, usualStep(basis, rule.gains), proposal));
    return proposal;
}

bool isAlikeWithin(const Envelope &limits, const ProposalBasis &basis, const ContinuousGains &gains)
{
    ProposalBasis other = basis;
    other.envelope = limits;
    const double step = usualStep(basis, gains);
    const auto roomOf = [](const Envelope &envelope) { return envelope.travel.value_or(0.0); };
    if (basis.loop == Mode::Velocity && std::abs(roomOf(limits) - roomOf(basis.envelope)) > alikeSteps * roomOf(limits))
        return false; // its proof goes as far as it may
    return limits.duty == basis.envelope.duty && limits.current == basis.envelope.current
        && std::abs(usualStep(other, gains) - step) <= alikeSteps * step;
}

Task<std::vector<Result<Proposal>>> designed(Device &device, ProposalBasis basis, std::vector<ProposalWish> wishes)
{
    using Designs = std::vector<Result<Proposal>>;
    const std::function<Result<Designs>()> work
        = [basis, profile = basis.profile, wishes = std::move(wishes)]() -> Result<Designs> {
        const ProposalBasis own{basis.family, profile, basis.loop, basis.axis, basis.slot, basis.plant, basis.envelope,
            basis.scale, basis.taking, basis.entries};
        Designs designs;
        for (const ProposalWish &wish : wishes)
            designs.push_back(proposalFor(own, wish));
        return designs;
    };
    co_return co_await aside<Designs>(device, work).attempt();
}

} // namespace mb::tuning
