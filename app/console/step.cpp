// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/assignments.h"
#include "app/console/experimentoptions.h"
#include "app/console/notebook.h"
#include "app/console/optionwords.h"
#include "app/console/samplestream.h"
#include "app/console/stage.h"
#include "app/console/target.h"
#include "app/console/trialtext.h"
#include "app/console/verb.h"
#include "async/progress.h"
#include "async/sleep.h"
#include "experiment/experiment.h"
#include "model/parametertransfer.h"
#include "settings/writing.h"
#include "storage/trialfile.h"

#include <memory>

namespace mb::console {
namespace {

using namespace tuning;

constexpr double longestTime = 3600.0;
constexpr int mostRepeats = 100;

struct StepArguments {
    std::string device;
    ExperimentOptions where;
    std::string mode;
    std::string to;
    std::string from;
    std::string profile;
    std::string seconds;
    std::string repeat;
    std::vector<std::string> gains;
    bool keep = false;
    bool samples = false;
    std::string save;
    bool yes = false;
};

struct StepPlan {
    Target target;
    ExperimentPlan experiment;
    bool samples = false;
    std::string save;
    bool yes = false; ///< what is owed to the unit is put back first
};

Result<std::optional<double>> optional(std::string_view name, const std::string &text, double low, double high)
{
    if (text.empty())
        return std::optional<double>();
    MB_TRY(const auto number, parseNumber(name, text, low, high));
    return std::optional<double>(number);
}

Result<Mode> parseLoop(const Family &family, const std::string &text)
{
    std::vector<std::string_view> known;
    for (const LoopGains &loop : family.trials->loops)
        known.push_back(toString(loop.mode));
    if (family.trials->nudge == 0.0)
        known.push_back(toString(Mode::Duty));
    std::string list;
    for (const std::string_view mode : known) {
        if (mode == text)
            return *modeFromString(text);
        list += (list.empty() ? "" : ", ") + std::string(mode);
    }
    return fail(Fault::Usage, say("%1 has no loop '%2' that can be tried", family.key, text),
        suggestion(text, known, "it has " + list));
}

Result<Profile> parseProfile(const std::string &text)
{
    if (const auto profile = profileFromString(text.empty() ? "step" : text))
        return *profile;
    return fail(Fault::Usage, say("unknown profile '%1'", text),
        suggestion(text, profileWords(), "there are step, square, ramp, sine, chirp and prbs"));
}

Result<void> parseNumbers(const Family &family, const StepArguments &a, ExperimentPlan &plan)
{
    const auto to = parseModeNumber("--to", a.to, plan.mode, -anyNumber, anyNumber);
    const auto from = a.from.empty() ? Result<double>(0.0) // not taken
                                     : parseModeNumber("--from", a.from, plan.mode, -anyNumber, anyNumber);
    const auto seconds = optional("--time", a.seconds, 0.001, longestTime);
    const auto repeat = a.repeat.empty() ? Result<int>(1) : parseInteger("--repeat", a.repeat, 1, mostRepeats);
    const auto where = a.where.parse(family);
    if (!from)
        return fail(from.error());
    if (!seconds)
        return fail(seconds.error());
    if (!repeat)
        return fail(repeat.error());
    if (!where)
        return fail(where.error());
    if (!to)
        return fail(to.error());
    plan.to = *to;
    if (!a.from.empty())
        plan.from = *from;
    plan.seconds = *seconds;
    plan.limits = where->limits;
    plan.repeat = *repeat;
    plan.axis = where->axis;
    plan.slot = where->slot;
    return {};
}

/// Everything that can be wrong before a device is asked.
Result<StepPlan> check(const Console &console, const StepArguments &a)
{
    MB_TRY(auto target, parseTarget(console, a.device));
    const Family &family = *target.family;
    if (!family.trials)
        return fail(
            Fault::Unsupported, say("%1 has no loop that can be tried", family.title), say("leave it to 'drive'"));
    StepPlan plan{std::move(target), {}, a.samples, a.save, a.yes};
    MB_TRY_VOID(checkSave(a.save));
    if (a.keep && a.gains.empty())
        return fail(
            Fault::Usage, say("--keep leaves what --set has written"), say("add --set KEY=VALUE, or leave it out"));
    MB_TRY(const auto mode, parseLoop(family, a.mode));
    MB_TRY(const auto profile, parseProfile(a.profile));
    plan.experiment.mode = mode;
    plan.experiment.profile = profile;
    plan.experiment.keep = a.keep ? Keep::Always : Keep::Never;
    MB_TRY_VOID(parseNumbers(family, a, plan.experiment));
    MB_TRY(auto gains, parseAssignments(family, a.gains));
    plan.experiment.gains = std::move(gains);
    MB_TRY_VOID(checkPlan(family, plan.experiment));
    return plan;
}

Task<Trial> experiment(Console &console, Session &session, Device &device, const StepPlan &plan, Notebook &notebook)
{
    Experimenting experimenting(console, session, device, notebook, plan.experiment.axis);
    auto running = runExperiment(device, experimenting.stream(), plan.experiment, experimenting.surroundings());
    co_return co_await std::move(running).attempt();
}

Result<int> verdictOf(const Trial &trial)
{
    if (trial.reason == EndReason::Link)
        return fail(Fault::LinkLost, say("the experiment ended because the link was lost: %1", trial.detail),
            trial.stopped ? say("the motor was seen stopped; check the cable")
                          : say("see that the motor stands before anything else"));
    if (!trial.stopped)
        return fail(Fault::Unsafe, say("the stop was not confirmed by %1", trial.device),
            say("cut its power if the motor still turns"));
    const bool isEnded = trial.reason == EndReason::Done || trial.reason == EndReason::Interrupted;
    if (isEnded && !trial.notPutBack.empty())
        return fail(Fault::Refused, say("the gains were not put back: %1", trial.notPutBack),
            say("run it again with --yes, which puts them back first"));
    if (isEnded)
        return exitDone;
    if (trial.reason == EndReason::None)
        return fail(Fault::Refused, trial.detail);
    return fail(Fault::Unsafe, say("stopped by the guard '%1': %2", toString(trial.reason), trial.detail),
        say("remove the cause before it is run again"));
}

Task<int> perform(Console &console, Session &session, Device &device, StepPlan plan, Notebook &notebook)
{
    co_await notebook.settleOwed(device, plan.yes);
    Result<Trial> trial;
    settings::Numbers before;
    if (notebook.settings()) {
        before = co_await settings::numbersBefore(device, plan.experiment.gains);
    }
    {
        std::optional<SampleStream> samples;
        if (plan.samples)
            samples.emplace(console, device, Watched{.channels = {}, .states = {}, .driven = true});
        trial = co_await experiment(console, session, device, plan, notebook).attempt();
    }
    co_await notebook.keepReplaced(device, before, settings::Origin::Console);
    if (!trial && trial.error().fault == Fault::NotKept)
        co_return fail(putsNothingBack(trial.error()));
    if (!trial)
        co_return fail(trial.error());
    printTrial(console, *trial, trial->number);
    Result<void> saved;
    if (!plan.save.empty())
        saved = saveTrial(plan.save, *trial, trial->number);
    co_return afterSaving(console, verdictOf(*trial), saved);
}

Task<int> step(Console &console, StepArguments arguments)
{
    const auto plan = co_await check(console, arguments);
    Notebook notebook(console);
    const bool owes = !plan.experiment.gains.empty() && plan.experiment.keep != Keep::Always;
    if (notebook.trouble() && owes)
        co_return fail(putsNothingBack(*notebook.trouble()));
    auto performing = performOn(console, plan.target,
        [&](Session &session, Device &device) { return perform(console, session, device, plan, notebook); });
    co_return co_await std::move(performing).attempt();
}

} // namespace

Job declareStep(CLI::App &arguments)
{
    const auto a = std::make_shared<StepArguments>();
    arguments.add_option("device", a->device, "LINK/FAMILY:ADDRESS")->required();
    arguments.add_option("--mode", a->mode, "velocity, position, current, duty, by family")->required();
    arguments.add_option("--to", a->to, "Y, in the unit of the mode")->required();
    arguments.add_option("--from", a->from, "X; the present position, else 0, otherwise");
    arguments.add_option("--profile", a->profile, "step, square, ramp, sine, chirp or prbs; step otherwise");
    arguments.add_option("--time", a->seconds, "Seconds of the profile; a step's hold ends once settled otherwise");
    arguments.add_option("--repeat", a->repeat, "How often; each with its samples a little later");
    arguments.add_option("--set", a->gains, "KEY=VALUE in force meanwhile; may be repeated")->allow_extra_args(false);
    arguments.add_flag("--keep", a->keep, "Leave what --set has written");
    a->where.declare(arguments, "Gain set, 0…");
    arguments.add_flag("--samples", a->samples, "Print the samples as watch does, before the result");
    arguments.add_flag("--yes", a->yes, "Put back first, without asking, what an earlier experiment could not");
    arguments.add_option("--save", a->save, "Keep result and samples in a file: .csv the samples alone");
    return [a](Console &console) { return step(console, *a); };
}

} // namespace mb::console
