// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/autotune.h"

#include "experiment/figures.h"
#include "experiment/gains.h"
#include "experiment/seconds.h"
#include "experiment/verdict.h"
#include "model/family.h"
#include "model/loopparameters.h"
#include "model/unit.h"
#include "tuning/autotunerun.h"
#include "tuning/currentidentification.h"
#include "tuning/gainscale.h"
#include "tuning/proof.h"
#include "tuning/pushidentification.h"
#include "tuning/scalecalibration.h"
#include "tuning/tunedesign.h"
#include "tuning/tuneproof.h"
#include "tuning/twopointidentification.h"

#include <algorithm>
#include <memory>

namespace mb::tuning {
namespace {

constexpr double allowedOvershoot = 0.05; ///< of where a loop comes to rest

/// The way that fits a loop of a family: pushes of duty; steps with gains tried against each other where it has no duty command;
/// short pushes that tell its resistance for a current loop.
/// nullptr where there is none.
std::unique_ptr<MotorIdentification> identificationOf(const Family &family, Mode loop)
{
    if (!family.trials)
        return nullptr;
    if (family.trials->raw.cycle > 0.0 && loop == Mode::Position)
        return std::make_unique<TwoPointIdentification>();
    if (family.trials->nudge > 0.0 || !loopUnits(family, loop))
        return nullptr;
    if (loop == Mode::Current)
        return std::make_unique<CurrentIdentification>();
    return std::make_unique<PushIdentification>();
}

/// A model: from the plan, or found out.
Task<void> model(AutotuneRun &run, const TunePlan &plan)
{
    if (plan.known) {
        co_await run.recall();
        co_return {};
    }
    const auto identification = identificationOf(run.device().family(), plan.loop);
    co_await identification->identify(run);
    co_return {};
}

/// The proposal that was asked for; where it does not hold, what it is reconsidered to.
Task<void> proveAny(AutotuneRun &run, TuneDesign &design, TuneProof &proof)
{
    for (bool again = true; again;) {
        co_await proof.prove();
        again = !run.isOver() && run.report().result == TuneResult::RolledBack;
        if (again && run.left() < proof.leastSeconds()) {
            run.report().evidence = joined(run.report().evidence, say("no time was left to prove others"));
            again = false;
        }
        if (again) {
            again = co_await design.reconsider();
        }
    }
    co_return {};
}

/// A unit that is not heard while nothing moves is lost like one that falls silent in a push.
bool isLost(const Device &device, const Error &error)
{
    return error.fault == Fault::LinkLost || device.link().state() != LinkState::Open
        || (error.fault == Fault::Timeout && !device.liveness().heard);
}

/// What came between two experiments, and ends one where it comes in it; empty: nothing did.
EndReason endBetween(Device &device, const Error &error)
{
    if (error.fault != Fault::Unsafe)
        return EndReason::None;
    return device.liveness().foreignMaster ? EndReason::ForeignMaster
        : device.liveness().restarted      ? EndReason::DeviceRestarted
        : device.guard().possible()        ? EndReason::None
                                           : EndReason::Unguarded;
}

/// Why what was proven before is kept all the same; nothing where it is not: a user or a unit that is lost ends every tuning, and nothing
/// is written where the motor may still turn, or where something else than before is in force.
std::optional<Message> givenUp(const AutotuneRun &run, const Result<void> &proved)
{
    const TuneReport &report = run.report();
    Device &device = run.device();
    const bool isHeard = device.liveness().heard && device.link().state() == LinkState::Open;
    if (run.user().isRequested() || !isHeard || !report.stopped || !report.notPutBack.empty())
        return std::nullopt;
    if (!proved)
        return isLost(device, proved.error()) || endBetween(device, proved.error()) != EndReason::None
            ? std::nullopt
            : std::optional(proved.error().detail);
    const bool isGuard = report.stopReason >= EndReason::Travel && report.stopReason <= EndReason::Link;
    return isGuard ? std::optional(report.evidence) : std::nullopt;
}

/// Of other gains than these it says nothing.
bool isOfTheseGains(EndReason reason)
{
    return reason == EndReason::None || reason == EndReason::Oscillation || reason == EndReason::Link;
}

/// Beside what was proven before; the better of the two is left. False where nothing is to be tried after it.
Task<bool> proveBeside(AutotuneRun &run, TuneDesign &design, TuneProof &proof)
{
    auto proving = proof.prove();
    Result<void> proved = co_await std::move(proving).attempt();
    const bool isCut = !proved || run.isOver();
    const auto why = isCut ? givenUp(run, proved) : std::nullopt;
    if (isCut && !why) {
        co_await std::move(proved);
        co_return false;
    }
    const bool goesOn = isOfTheseGains(run.report().stopReason);
    if (why) {
        run.note(say("these are given up: %1", *why));
        run.forgive();
        run.report().result = TuneResult::RolledBack;
        design.giveUp(*why);
    }
    design.takeTheBetter();
    co_return goesOn;
}

/// What was there before is not given up for something worse; and what was proven tells enough for something better. Where there is time.
Task<void> sharpen(AutotuneRun &run, TuneDesign &design, TuneProof &proof)
{
    bool goesOn = true;
    if (design.recallFormer(proof.seconds()))
        goesOn = co_await proveBeside(run, design, proof);
    while (goesOn) {
        goesOn = co_await design.sharpen(proof.seconds());
        if (goesOn)
            goesOn = co_await proveBeside(run, design, proof);
    }
    co_return {};
}

/// The search for scales writes the gains of every loop of its axis.
Result<void> checkAllPutBack(const Device &device, const TunePlan &plan, bool searches)
{
    for (const Mode mode : {plan.loop, Mode::Velocity, Mode::Position}) {
        if (mode != plan.loop && !searches)
            continue;
        MB_TRY_VOID(checkPutBack(device, mode, plan.axis, plan.slot));
    }
    return {};
}

/// Ends with what the report says; an error is why the motor was refused.
Task<void> perform(AutotuneRun &run, const TunePlan &plan)
{
    const bool searches = !checkScales(run.device(), plan.loop);
    if ((searches || !plan.propose) && !plan.keep)
        co_await checkAllPutBack(run.device(), plan, searches);
    if (searches) {
        co_await findScales(run);
        run.beginClock();
    }
    if (run.isOver())
        co_return {};
    co_await model(run, plan);
    if (run.isOver())
        co_return {};
    auto reading = readGains(run.device(), plan.loop, plan.axis, plan.slot);
    run.report().before = co_await std::move(reading);
    TuneDesign design(run);
    co_await design.propose();
    if (plan.propose) {
        if (auto may = run.user().mayGoOn(); !may) {
            run.report().proposed = {};
            co_return fail(may.error());
        }
        run.report().result = TuneResult::Proposed;
        run.report().evidence = say("what these gains do is predicted, and not proven on the motor");
        co_return {};
    }
    TuneProof proof(run, design);
    co_await proveAny(run, design, proof);
    if (run.isOver() || run.report().result == TuneResult::RolledBack)
        co_return {};
    co_await sharpen(run, design, proof);
    if (run.isOver())
        co_return {};
    co_await proof.keep();
    co_return {};
}

/// What a gain makes is found out with others in force.
bool triesGains(const Family &family, const TunePlan &plan)
{
    return family.trials && family.trials->raw.cycle > 0.0 && !plan.known;
}

/// Those that it has, as a remedy.
Message loopsOf(const Family &family)
{
    std::string list;
    for (const LoopGains &loop : family.trials->loops)
        list += (list.empty() ? "" : ", ") + std::string(toString(loop.mode));
    return say("it has %1", list);
}

/// A loop of P alone that is much slower than the current meets its own last output each time it looks: the first pass makes P times
/// the gain of what was asked for, and it comes to rest at that over one more than that.
Error holdsTooLittle(const Family &family)
{
    const double holds = allowedOvershoot / (1.0 + allowedOvershoot);
    return {Fault::Unsupported,
        say("P alone, in a loop that looks at the current every %1, holds %2 of what is asked for when it overshoots "
            "by %3",
            millisecondsText(family.loop->cycle), percentText(holds), percentText(allowedOvershoot)),
        say("drive it by duty, or try its I with 'motorbenchctl step': not every build of the firmware runs it")};
}

} // namespace

namespace {

/// Of a tuning that has moved its motor, or that the user has stopped before.
void takeError(AutotuneRun &run, const Error &error)
{
    TuneReport &report = run.report();
    report.result = report.result == TuneResult::RolledBack ? report.result : TuneResult::Refused;
    report.evidence = error.message();
    if (run.isOver())
        return;
    if (isLost(run.device(), error)) {
        run.end(EndReason::Link, error.message());
    } else if (run.user().isRequested()) {
        run.end(EndReason::Interrupted, error.message());
    } else if (const EndReason reason = endBetween(run.device(), error); reason != EndReason::None) {
        run.end(reason, error.message());
        report.stopped = run.device().isSeenStopped();
    } else if (!report.stopped) {
        run.end(EndReason::Unconfirmed, error.message());
    }
}

/// D of a position answers each set-point with whatever it makes of its size: where nothing of the unit bounds it, no model tells how much.
Result<void> checkDuty(const Family &family, const TunePlan &plan)
{
    const double duty = plan.limits.duty.value_or(1.0);
    const bool isBounded = hasOutputLimits(family)
        || std::ranges::any_of(
            family.trials->limits, [](const DeviceLimit &limit) { return limit.bounds == DeviceLimit::Bounds::Duty; });
    if (plan.loop != Mode::Position || plan.propose || !family.loop || isBounded || duty >= 1.0)
        return {};
    return fail(Fault::OutOfRange,
        say("nothing of its own keeps a position loop of %1 to %2 duty", family.title, percentText(duty)),
        say("allow all of it within little travel, or tune it by hand with 'motorbenchctl step'"));
}

} // namespace

Result<void> checkTuning(const Family &family, const TunePlan &plan)
{
    if (!loopOf(family, plan.loop))
        return fail(Fault::OutOfRange, say("%1 has no loop '%2' that can be tuned", family.key, toString(plan.loop)),
            loopsOf(family));
    if (plan.loop == Mode::Current && loopOf(family, plan.loop)->proportional)
        return fail(holdsTooLittle(family));
    if (!identificationOf(family, plan.loop))
        return fail(Fault::Unsupported, say("what a gain of %1 means in this loop is not known", family.title),
            say("tune it by hand with 'motorbenchctl step'"));
    if (plan.known && family.trials->raw.cycle > 0.0 && !plan.scale)
        return fail(
            Fault::OutOfRange, say("what the gains of this loop make is not known any more"), say("identify it anew"));
    MB_TRY_VOID(checkDuty(family, plan));
    ExperimentPlan steps;
    steps.mode = family.trials->nudge > 0.0 ? plan.loop : Mode::Duty;
    steps.to = 1.0;
    steps.axis = plan.axis;
    steps.slot = plan.slot;
    return checkPlan(family, steps);
}

bool writesGains(const Device &device, const TunePlan &plan)
{
    return !plan.propose || triesGains(device.family(), plan) || !checkScales(device, plan.loop);
}

bool owesGains(const Device &device, const TunePlan &plan)
{
    const bool stays = plan.keep && device.family().capabilities.gainSlots == 1
        && !checkPutBack(device, plan.loop, plan.axis, plan.slot);
    return triesGains(device.family(), plan) || (!plan.propose && !stays);
}

Task<TuneReport> autotune(Device &device, SetPointStream &stream, TunePlan plan, ExperimentSurroundings surroundings)
{
    co_await checkTuning(device.family(), plan);
    if (auto known = checkScales(device, plan.loop); !known && !scaleExperimentOf(device.family()))
        co_return fail(known.error());
    if (!surroundings.journal && owesGains(device, plan))
        co_return fail(Fault::OutOfRange, say("nothing could put the gains back after a crash"),
            say("name a notebook that can be written"));
    const Instant begin = device.clock().now();
    AutotuneRun run(device, stream, plan, surroundings);
    const Result<void> performed = co_await perform(run, plan).attempt();
    TuneReport &report = run.report();
    if (!performed) {
        if (!run.hasMoved() && !run.user().isRequested())
            co_return fail(performed.error());
        takeError(run, performed.error());
    }
    if (run.isOver())
        report.result = TuneResult::Stopped;
    if (!report.notPutBack.empty() && replacesUnknown(report))
        report.evidence = joined(report.evidence, report.notPutBack);
    report.seconds = inSeconds(device.clock().now() - begin);
    report.unit = unitKeyOf(device);
    report.firmware = device.identity().firmware;
    if (surroundings.journal) {
        if (const auto kept = co_await surroundings.journal->keepTuning(report).attempt(); !kept)
            surroundings.caution(say("the tuning is not in the notebook: %1", kept.error().message()));
    }
    co_return std::move(report);
}

} // namespace mb::tuning
