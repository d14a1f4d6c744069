// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/scalecalibration.h"

#include "async/progress.h"
#include "experiment/announcement.h"
#include "experiment/direction.h"
#include "experiment/envelope.h"
#include "experiment/trialrecorder.h"
#include "model/family.h"
#include "tuning/autotunerun.h"

#include <algorithm>
#include <cmath>

namespace mb::tuning {
namespace {

constexpr std::string_view scaleKeyOfExperiments = "gain-scales";
constexpr Duration longestSearch = std::chrono::seconds(240);
constexpr Duration sampleTime = std::chrono::milliseconds(10);

GuardPlan guardsOf(const AutotuneRun &run)
{
    const TrialTraits &traits = *run.device().family().trials;
    GuardPlan plan;
    plan.envelope = run.envelope();
    plan.origin = run.place();
    plan.hottest = traits.hottest;
    plan.lowestBus = traits.lowestBus;
    plan.highestBus = traits.highestBus;
    plan.telemetry = sampleTime;
    plan.command = run.device().family().capabilities.commandPeriod;
    plan.longest = longestSearch;
    return plan;
}

/// Its are the first loops that a run of the program closes: which way the motor counts is seen before.
Task<void> search(AutotuneRun &run, const Experiment &experiment, const ExperimentOptions &options,
    TrialRecorder &recorder, std::optional<Trip> &trip)
{
    Device &device = run.device();
    DirectionBook *const known = run.around().directions;
    if (known && !known->find(device.selector(), options.axis)) {
        GuardPlan guards = guardsOf(run);
        guards.envelope.duty = options.power;
        auto checking = checkDirection(device, run.stream(), recorder, options.axis, guards, trip);
        known->add(device.selector(), options.axis, co_await std::move(checking));
    }
    recorder.guard(guardsOf(run));
    const auto note = [&run](const Message &text) { run.note(text); };
    ProgressLines progress(note, note);
    co_await experiment.run(device, run.stream(), options, progress);
    co_return {};
}

} // namespace

const Experiment *scaleExperimentOf(const Family &family)
{
    const auto found = std::ranges::find_if(
        family.experiments, [](const Experiment &known) { return known.key == scaleKeyOfExperiments && known.run; });
    return found == family.experiments.end() ? nullptr : &*found;
}

Task<void> findScales(AutotuneRun &run)
{
    Device &device = run.device();
    const Experiment &experiment = *scaleExperimentOf(device.family());
    co_await device.mayMove();
    run.lookWhere();
    co_await run.readEnvelope();
    ExperimentOptions options;
    options.axis = run.plan().axis;
    options.power = std::min(experiment.power, run.envelope().duty.value_or(experiment.power));
    run.note(say("the scale of its gains is not known yet, and is found first: one to two minutes, with %1 % of its "
                 "power at most",
        std::round(100.0 * options.power)));
    Extent extent = extentOf(run.envelope());
    extent.duty = options.power;
    run.note(textOf(extent));
    TrialRecorder recorder(device, run.stream(), Mode::Velocity, options.axis);
    co_await run.keepBefore();
    run.setMoved();
    std::optional<Trip> trip;
    const Result<void> found = co_await search(run, experiment, options, recorder, trip).attempt();
    recorder.unguard();
    auto stopping = confirmStop(device);
    run.report().stopped = co_await std::move(stopping);
    run.lookWhere();
    trip = trip ? trip : recorder.trip();
    if (trip)
        run.end(trip->guard, trip->detail);
    else if (run.user().isRequested())
        run.end(EndReason::Interrupted, say("the user stopped it"));
    else if (!found && found.error().fault == Fault::LinkLost)
        run.end(EndReason::Link, found.error().detail);
    else if (!found)
        co_return fail(found.error());
    co_return {};
}

} // namespace mb::tuning
