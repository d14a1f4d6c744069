// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/tuneproof.h"

#include "async/sleep.h"
#include "experiment/envelope.h"
#include "experiment/figures.h"
#include "experiment/gains.h"
#include "experiment/owedgains.h"
#include "experiment/verdict.h"
#include "model/family.h"
#include "model/loopparameters.h"
#include "model/unit.h"
#include "tuning/autotunerun.h"
#include "tuning/looppass.h"
#include "tuning/plateau.h"
#include "tuning/proof.h"
#include "tuning/proofcourse.h"
#include "tuning/rawstep.h"
#include "tuning/refinement.h"
#include "tuning/tunedesign.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace mb::tuning {
namespace {

constexpr int mostAgain = 2; ///< a unit that restarts answers soon
constexpr std::chrono::seconds againAfter(1);
constexpr double countedRest
    = 1.5; ///< s, until a velocity that is counted over edges is known to be 0, and the integral is at rest
constexpr double notableRest = 0.02;    ///< of the step
constexpr double quietCounts = 2.0;     ///< σ, of a position at rest
constexpr double clearOvershoot = 0.15; ///< more than predicted, that a wrong D may be the cause of

Message tellRest(Mode loop, const RestingError &rests)
{
    if (loop == Mode::Current)
        return say("its current stays %1 A behind while the motor speeds up", std::round(rests.error * 100.0) / 100.0);
    const double error = std::round(rests.error);
    switch (rests.below) {
    case RestingError::Below::Integral:
        return say("it may rest %1 short of its target, less does not move its integral", error);
    case RestingError::Below::Time:
        return say("it may rest %1 short of its target until its integral has overcome friction", error);
    case RestingError::Below::Allowed:
        return say("it may rest %1 short of its target, which its allowable error lets it", error);
    case RestingError::Below::Motor: break;
    }
    return say("it may rest %1 short of its target, less does not move its motor", error);
}

int stepsOf(const std::vector<Trial> &proof)
{
    return std::accumulate(proof.begin(), proof.end(), 0,
        [](int steps, const Trial &trial) { return steps + static_cast<int>(trial.holds.size()); });
}

} // namespace

TuneProof::TuneProof(AutotuneRun &run, const TuneDesign &design)
    : m_run(run)
    , m_design(design)
    , m_slot(run.device().family().capabilities.gainSlots > 1 ? 1 - run.plan().slot : run.plan().slot)
    , m_heat(run.report().motor ? run.report().motor->heat : 0.0)
    , m_mayStay(run.plan().keep && replacesUnknown(run.report()) && m_slot == run.plan().slot) // else they are put back
{
}

RestingError TuneProof::resting() const
{
    const TuneReport &report = m_run.report();
    const Mode loop = m_run.plan().loop;
    if (loop == Mode::Current)
        return {droopOf(report.proof, report.plant, report.proposed.made)};
    if (report.scale)
        return {deadband(report.plant, report.proposed.made)};
    return restingError(loop, report.predicted->shape, report.plant, report.proposed.made, hold());
}

/// Counts/s; 0: targets are steps.
double TuneProof::profileRate() const
{
    const auto &scale = m_run.report().scale;
    return scale ? scale->rate : 0.0;
}

double TuneProof::hold() const
{
    const TuneReport &report = m_run.report();
    return proofHold(m_run.plan().loop, report.proposed.made, *report.predicted);
}

/// As many as take the noise out of a current, of other loops two; or as there is time for, of what is left for each way, and room.
int TuneProof::repeats(double sign) const
{
    const TuneReport &report = m_run.report();
    const bool isCurrent = m_run.plan().loop == Mode::Current;
    const double room = m_run.left() / (report.proof.empty() ? 2.0 : 1.0);
    const double fit = (room - proofSeconds(hold(), 0)) / (proofSeconds(hold(), 1) - proofSeconds(hold(), 0));
    const int asked = isCurrent
        ? currentRepeats(report.plant.noise, report.step)
        : repeatsWithin(m_run.room(sign), m_run.plan().loop, report.plant, report.step, hold(), usualProofs);
    return std::clamp(static_cast<int>(fit), isCurrent ? currentRepeats(0.0, 1.0) : 1, asked);
}

double TuneProof::seconds() const
{
    const bool isCurrent = m_run.plan().loop == Mode::Current;
    return 2.0 * proofSeconds(hold(), isCurrent ? currentRepeats(m_run.report().plant.noise, m_run.report().step) : 1);
}

double TuneProof::leastSeconds() const
{
    return 2.0 * proofSeconds(hold(), m_run.plan().loop == Mode::Current ? currentRepeats(0.0, 1.0) : 1);
}

/// The proposal as changes of the slot that it is proven in, with everything else of the slot that it is for.
std::vector<ParameterChange> TuneProof::inProvingSlot() const
{
    const TunePlan &plan = m_run.plan();
    const auto &proposed = m_run.report().proposed.changes;
    if (m_slot == plan.slot)
        return proposed;
    const Family &family = m_run.device().family();
    const LoopGains &loop = *loopOf(family, plan.loop);
    std::vector<ParameterChange> changes;
    for (const std::string_view name : loop.names) {
        const std::string pattern = std::string(loop.prefix) + std::string(name);
        const auto from = findParameter(family.parameters, gainKey(family, pattern, plan.axis, plan.slot));
        const auto into = findParameter(family.parameters, gainKey(family, pattern, plan.axis, m_slot));
        if (!from || !into)
            continue;
        const auto found = std::ranges::find(proposed, *from, &ParameterChange::index);
        if (found != proposed.end())
            changes.push_back({*into, found->raw});
        else if (const auto &entry = m_run.device().parameters().entry(*from); entry.raw)
            changes.push_back({*into, *entry.raw});
    }
    return changes;
}

double TuneProof::target(double sign) const
{
    const bool counted = m_run.device().family().capabilities.zeroPosition; // each experiment from its own start
    return sign * m_run.report().step + (m_run.plan().loop == Mode::Position && !counted ? m_run.place() : 0.0);
}

ExperimentPlan TuneProof::planOf(double sign) const
{
    const Mode loop = m_run.plan().loop;
    ExperimentPlan plan;
    plan.mode = loop;
    plan.slot = m_slot;
    plan.repeat = repeats(sign);
    plan.seconds = hold();
    plan.rest = m_run.report().predicted->shape.windowCounts > 0.0 ? countedRest : 0.0;
    plan.noise = m_run.report().plant.noise;
    plan.gains = inProvingSlot();
    if (const double rate = profileRate(); rate > 0.0) {
        m_run.note(say("its own profile leads there at %1 counts/s", rate));
        leadByProfile(m_run, rate, plan);
    }
    plan.keep = m_mayStay ? Keep::Always : Keep::Never;
    plan.from = loop == Mode::Position ? std::optional<double>() : 0.0;
    plan.to = target(sign);
    const double step = sign * m_run.report().step;
    m_run.note(loop == Mode::Current ? say("proving: a step of %1 A", std::round(step * 100.0) / 100.0)
            : loop == Mode::Position ? say("proving: a step of %1 counts", std::round(step))
                                     : say("proving: a step of %1 counts/s", std::round(step)));
    return plan;
}

/// What the steps so far did worse than was predicted; empty: nothing.
Message TuneProof::shortcoming()
{
    TuneReport &report = m_run.report();
    report.measured = worseOf(report.proof);
    if (report.predicted->shape.windowCounts > 0.0)
        report.measured.settle = settledWidely(report.proof);
    if (m_run.plan().loop == Mode::Current && report.measured.sse)
        report.measured.sse = restOfCurrent(report.proof);
    Message wrong = judgeProof(report.measured, report.predicted->metrics, report.step, resting().error);
    if (wrong.empty() && m_run.plan().loop == Mode::Velocity)
        wrong = judgeRest(swingOf(report.proof.back()), *report.predicted, report.step);
    if (wrong.empty() && report.scale && report.scale->rate == 0.0)
        wrong = judgePlace(report.proof.back(), quietCounts);
    if (!wrong.empty() && report.proof.back().has(flag::limitSwitch))
        wrong = joined(wrong, say("a limit switch was met"));
    return wrong;
}

/// Whether its loop runs as often as what was designed counts on: the first step of a velocity tells.
Result<void> TuneProof::checkPass()
{
    TuneReport &report = m_run.report();
    const auto gate = passGate(m_run.device().family(), report.proof.back());
    if (!gate)
        return {};
    std::erase_if(report.gates, [&gate](const Gate &known) { return known.name == gate->name; });
    report.gates.push_back(*gate);
    if (!gate->passed)
        return fail(Fault::Refused, say("the model is not to be believed: %1", gate->detail), gate->remedy);
    return {};
}

/// Of a unit that does not tell which firmware it runs nobody knows for certain which way its D acts: the wrong way the first position
/// that it is given makes it swing.
Message TuneProof::withDerivative(Message why) const
{
    const TuneReport &report = m_run.report();
    const bool isUntold = !m_run.device().family().capabilities.versionOnWire && !report.scale;
    const bool isFirst = report.proof.size() == 1 && m_design.before().empty();
    if (!isUntold || !isFirst || m_run.plan().loop != Mode::Position || report.proposed.made.d == 0.0)
        return why;
    return joined(why, say("perhaps its D acts the other way round than in the firmware that is known"));
}

/// What is predicted to do more than it may needs no motion to be put back.
Result<void> TuneProof::checkPromise() const
{
    const TuneReport &report = m_run.report();
    const double overshoot = report.predicted->metrics.overshoot.value_or(0.0);
    const double most = proofLimits(report.predicted->metrics, report.step, 0.0).overshoot;
    if (overshoot <= most)
        return {};
    return fail(Fault::OutOfRange,
        say("these gains would overshoot by %1, and at most %2 are kept", percentText(overshoot), percentText(most)),
        say("take a larger response"));
}

Task<void> TuneProof::prove()
{
    TuneReport &report = m_run.report();
    co_await checkPromise();
    report.heat = m_heat;
    sumOver(*report.predicted, m_run.plan().loop, m_run.report().step, hold());
    for (const double sign : {1.0, -1.0}) {
        auto running = m_run.run(planOf(sign), sign > 0.0 ? leastSeconds() / 2.0 : 0.0);
        report.proof.push_back(co_await std::move(running));
        m_heat = heatAfter(
            {report.proposed.made, report.predicted->shape, {report.proof.back()}, 0.0, false, m_heat}, report.plant);
        if (report.stopReason == EndReason::Oscillation)
            report.evidence = withDerivative(report.evidence);
        if (m_run.isOver())
            co_return {};
        co_await checkPass();
        const Message wrong = shortcoming();
        if (!wrong.empty()) { // what fails one way needs no proof the other way
            report.result = TuneResult::RolledBack;
            const double beyond
                = report.measured.overshoot.value_or(0.0) - report.predicted->metrics.overshoot.value_or(0.0);
            report.evidence = joined(beyond > clearOvershoot ? withDerivative(wrong) : wrong, m_design.before());
            co_return {};
        }
        if (!m_design.isPromising()) { // what was proven before is better, and is kept
            report.result = TuneResult::RolledBack;
            co_return {};
        }
    }
    co_return {};
}

Task<void> TuneProof::write()
{
    TuneReport &report = m_run.report();
    Device &device = m_run.device();
    const std::vector<ParameterChange> &changes = report.proposed.changes;
    ExperimentJournal *const journal = m_run.around().journal;
    const bool owes = journal && !report.trials.empty() && !m_mayStay;
    std::vector<OwedValue> before;
    if (owes) {
        before = co_await readReplaced(device, changes);
        co_await journal->owe(report.trials.back(), unitKeyOf(device), before);
    }
    Result<void> written = m_run.user().mayGoOn();
    if (written) {
        written = co_await writeGains(device, changes).attempt();
    }
    if (written && owes)
        written = m_run.user().mayGoOn();
    if (!written && owes) {
        co_await takeBack(std::move(before), written.error());
    }
    if (!written)
        co_return fail(written.error());
    std::vector<std::string> keys;
    for (const ParameterChange &change : changes)
        keys.emplace_back(device.parameters().parameter(change.index).key);
    if (journal) {
        if (const auto released = co_await journal->release(unitKeyOf(device), std::move(keys)).attempt(); !released) {
            m_unreleased = say("the notebook may offer to put back what was there before: %1", released.error().detail);
            m_run.around().caution(m_unreleased);
        }
    }
    co_return {};
}

/// Half of the gains may be in force. Fails with the cause, and with what has become of those before.
Task<void> TuneProof::takeBack(std::vector<OwedValue> before, Error cause)
{
    TuneReport &report = m_run.report();
    report.result = TuneResult::RolledBack;
    m_run.note(say("what was proven could not be written: %1", cause.detail));
    Result<void> paid;
    for (int again = 0; again <= mostAgain && (again == 0 || !paid); ++again) {
        if (again > 0)
            co_await Sleep(m_run.device().clock(), againAfter);
        auto paying = payOwed(m_run.device(), *m_run.around().journal, {report.trials.back(), 0.0, before});
        paid = co_await std::move(paying).attempt();
    }
    if (paid) {
        cause.detail
            = say("what was proven could not be written: %1; what was there before is in force again", cause.detail);
    } else {
        report.notPutBack = paid.error().detail;
        cause.detail
            = say("what was proven could not be written: %1; what was there before was not put back: %2; it is "
                  "offered at the next connection",
                cause.detail, paid.error().detail);
    }
    co_return fail(cause);
}

Task<void> TuneProof::keep()
{
    TuneReport &report = m_run.report();
    co_await write();
    report.result = TuneResult::Kept;
    report.notPutBack = {};
    const Capabilities &can = m_run.device().family().capabilities;
    const ParameterStore &parameters = m_run.device().parameters();
    const bool areRead = std::ranges::none_of(report.proposed.changes, [&parameters](const ParameterChange &change) {
        return parameters.parameter(change.index).access == Access::WriteOnly;
    });
    const bool isAsItWas = std::ranges::all_of(report.proposed.rows, [&report](const ScaledGains::Row &row) {
        const auto before = std::ranges::find(report.before, row.key, &KnownGains::value_type::first);
        return before == report.before.end() || before->second == row.number;
    });
    report.evidence = m_design.isFormer() && isAsItWas
        ? say("the steps in both directions kept their limits; the gains are as they were")
        : areRead
        ? say("the steps in both directions kept their limits; the gains were written and read back")
        : say("the steps in both directions kept their limits; the gains were written, which this family cannot read "
              "back");
    constexpr int wanted = 2 * usualProofs;
    if (const int steps = stepsOf(report.proof); m_run.plan().loop != Mode::Current && steps < wanted)
        report.evidence = joined(report.evidence, say("they were proven by %1 steps instead of %2", steps, wanted));
    if (const Message story = m_design.story(); !story.empty())
        report.evidence = joined(report.evidence, story);
    if (const double rate = profileRate(); rate > 0.0)
        report.evidence = joined(report.evidence,
            say("the unit's own profile led at %1 counts/s, for a step would draw too much current", rate));
    if (m_mayStay)
        report.evidence
            = joined(report.evidence, say("what was there is not known, and these were not compared with it"));
    if (const RestingError rests = resting(); rests.error > notableRest * m_run.report().step)
        report.evidence = joined(report.evidence, tellRest(m_run.plan().loop, rests));
    if (std::ranges::any_of(report.proof, [](const Trial &trial) { return trial.has(flag::restartNeeded); }))
        report.evidence = joined(report.evidence, say("a part of them is in force after a restart only"));
    if (!m_unreleased.empty())
        report.evidence = joined(report.evidence, m_unreleased);
    if (can.storesAfter > std::chrono::seconds(0))
        report.evidence
            = joined(report.evidence, say("the unit stores them by itself within %1 s", can.storesAfter.count()));
    co_return {};
}

} // namespace mb::tuning
