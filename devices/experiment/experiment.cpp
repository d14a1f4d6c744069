// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiment/experiment.h"

#include "experiment/envelope.h"
#include "experiment/experimentrun.h"
#include "experiment/gains.h"
#include "experiment/seconds.h"
#include "model/family.h"
#include "model/loopparameters.h"

namespace mb::tuning {

Result<void> checkPlan(const Family &family, const ExperimentPlan &plan)
{
    if (!family.trials)
        return fail(Fault::Unsupported, say("%1 has no loop that can be tried", family.title));
    if (plan.mode != Mode::Duty && !loopOf(family, plan.mode)) {
        std::string list = "duty";
        for (const LoopGains &loop : family.trials->loops)
            list += ", " + std::string(toString(loop.mode));
        return fail(Fault::OutOfRange, say("%1 has no loop '%2' that can be tried", family.key, toString(plan.mode)),
            say("it has %1", list));
    }
    if (plan.mode == Mode::Duty && family.trials->nudge > 0.0)
        return fail(Fault::OutOfRange, say("%1 has no duty command", family.key), say("try its position loop"));
    const Capabilities &can = family.capabilities;
    if (plan.axis < 1 || plan.axis > can.axes || plan.slot < 0 || plan.slot >= can.gainSlots)
        return fail(Fault::OutOfRange, say("%1 has %2 axes and %3 sets of gains", family.key, can.axes, can.gainSlots),
            say("take one of them"));
    if (plan.repeat < 1)
        return fail(Fault::OutOfRange, say("an experiment is run once at least"));
    const double beat = inSeconds(family.capabilities.commandPeriod);
    MB_TRY_VOID(Stimulus::make(plan.profile, plan.from.value_or(0.0), plan.to, plan.seconds, beat));
    for (const ParameterChange &change : plan.gains) {
        MB_TRY_VOID(checkTried(family, change.index));
    }
    return {};
}

Task<Trial> runExperiment(
    Device &device, SetPointStream &stream, ExperimentPlan plan, ExperimentSurroundings surroundings)
{
    co_await checkPlan(device.family(), plan);
    ExperimentRun run(device, stream, std::move(plan), std::move(surroundings));
    co_await run.prepare();
    const Result<void> performed = co_await run.perform().attempt();
    std::optional<Error> error;
    if (!performed)
        error = performed.error();
    co_await run.conclude(error);
    Trial trial = run.takeTrial();
    if (!error || run.hasResult())
        co_return trial;
    if (!trial.notPutBack.empty())
        error->detail = joined(error->detail, say("the gains were not put back: %1", trial.notPutBack));
    co_return fail(*error);
}

} // namespace mb::tuning
