// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/experimentoptions.h"
#include "app/console/notebook.h"
#include "app/console/optionwords.h"
#include "app/console/progressline.h"
#include "app/console/stage.h"
#include "app/console/target.h"
#include "app/console/tunetext.h"
#include "app/console/tuneverdict.h"
#include "app/console/verb.h"
#include "async/sleep.h"
#include "settings/writing.h"
#include "tuning/autotune.h"
#include "tuning/proposals.h"

#include <algorithm>
#include <memory>

namespace mb::console {
namespace {

using namespace tuning;

constexpr double leastMs = 1.1;

struct TuneArguments {
    std::string device;
    ExperimentOptions where;
    std::string loop;
    std::string aim;
    std::string response;
    std::string damping;
    std::string save;
    bool propose = false;
    bool store = false;
    bool keep = false;
    bool yes = false;
};

struct TuneOrder {
    Target target;
    TunePlan tuning;
    std::string save;
    bool store = false;
    bool yes = false;
};

Result<void> parseLoop(const Family &family, const std::string &text, TunePlan &plan)
{
    const auto known = tunableLoops();
    if (std::ranges::find(known, text) == known.end())
        return fail(Fault::Usage, say("unknown loop '%1'", text),
            suggestion(text, known, "there are velocity, position and current"));
    plan.loop = *modeFromString(text);
    if (!family.trials)
        return fail(Fault::Unsupported, say("%1 has no loop that can be tuned", family.title));
    return {};
}

Result<void> parseAim(const TuneArguments &a, TunePlan &plan)
{
    const auto aim = aimFromString(a.aim.empty() ? "normal" : a.aim);
    if (!aim)
        return fail(Fault::Usage, say("unknown aim '%1'", a.aim),
            suggestion(a.aim, aimWords(), "there are calm, normal and brisk"));
    plan.aim = *aim;
    if (a.response.empty() != a.damping.empty())
        return fail(Fault::Usage, say("--response and --damping belong together"), say("give both, or an --aim"));
    if (!a.aim.empty() && !a.response.empty())
        return fail(Fault::Usage, say("--aim and --response exclude each other"), say("give one of them"));
    if (a.response.empty())
        return {};
    MB_TRY(const auto response, parseNumber("--response", a.response, 1e-4, 100.0));
    MB_TRY(const auto ms, parseNumber("--damping", a.damping, leastMs, largestMs));
    plan.response = response;
    plan.ms = ms;
    return {};
}

/// Everything that can be wrong before a device is asked.
Result<TuneOrder> check(const Console &console, const TuneArguments &a)
{
    MB_TRY(auto target, parseTarget(console, a.device));
    const Family &family = *target.family;
    TuneOrder plan{std::move(target), {}, a.save, a.store, a.yes};
    MB_TRY_VOID(checkSave(a.save));
    plan.tuning.propose = a.propose;
    plan.tuning.keep = a.keep;
    if (a.propose && (a.store || a.keep))
        return fail(
            Fault::Usage, say("--propose writes nothing, so nothing is stored or kept"), say("leave one of them out"));
    MB_TRY_VOID(parseLoop(family, a.loop, plan.tuning));
    MB_TRY_VOID(parseAim(a, plan.tuning));
    MB_TRY(const auto where, a.where.parse(family));
    plan.tuning.axis = where.axis;
    plan.tuning.slot = where.slot;
    plan.tuning.limits = where.limits;
    MB_TRY_VOID(checkTuning(family, plan.tuning));
    return plan;
}

Task<TuneReport> tuneOn(Console &console, Session &session, Device &device, const TuneOrder &plan, Notebook &notebook)
{
    Experimenting experimenting(console, session, device, notebook, plan.tuning.axis);
    ExperimentSurroundings surroundings = experimenting.surroundings();
    if (writesGains(device, plan.tuning))
        surroundings.before = [&] { return notebook.keepBefore(device, settings::Occasion::Tuning); };
    co_return co_await autotune(device, experimenting.stream(), plan.tuning, std::move(surroundings)).attempt();
}

/// Waits until the unit has it for good; what it says about that is added to the evidence. Why that is not proved, else.
Task<std::optional<Error>> storeGains(Console &console, Device &device, TuneReport &report, settings::SettingsLog *log)
{
    ProgressLine progress(console);
    const Result<bool> proven = co_await settings::storeKept(device, settings::Origin::Tuning, log, progress).attempt();
    if (!proven) {
        const Error why = proven.error().about(say("the values are in force but not proved to be stored"));
        report.evidence = joined(report.evidence, why.detail);
        co_return why;
    }
    report.evidence = joined(report.evidence,
        *proven ? say("the unit has stored them") : say("the unit cannot tell whether it has stored them"));
    co_return std::nullopt;
}

Task<int> perform(Console &console, Session &session, Device &device, TuneOrder plan, Notebook &notebook)
{
    if (notebook.trouble() && owesGains(device, plan.tuning))
        co_return fail(putsNothingBack(*notebook.trouble()));
    co_await notebook.settleOwed(device, plan.yes);
    Result<TuneReport> report = co_await tuneOn(console, session, device, plan, notebook).attempt();
    if (!report)
        co_return fail(report.error());
    if (report->result == TuneResult::Kept || !report->notPutBack.empty())
        co_await notebook.keepReplaced(device, report->before, settings::Origin::Tuning);
    Result<int> verdict = verdictOfTuning(*report);
    if (plan.store && report->result == TuneResult::Kept) {
        auto storing = storeGains(console, device, *report, notebook.settings());
        if (const std::optional<Error> unproved = co_await std::move(storing); unproved && verdict)
            verdict = fail(*unproved);
    }
    printTuning(console, *report);
    Result<void> saved;
    if (!plan.save.empty())
        saved = saveTuning(plan.save, *report);
    co_return afterSaving(console, std::move(verdict), saved);
}

Task<int> tune(Console &console, TuneArguments arguments)
{
    const auto plan = co_await check(console, arguments);
    Notebook notebook(console);
    auto performing = performOn(console, plan.target,
        [&](Session &session, Device &device) { return perform(console, session, device, plan, notebook); });
    co_return co_await std::move(performing).attempt();
}

} // namespace

Job declareTune(CLI::App &arguments)
{
    const auto a = std::make_shared<TuneArguments>();
    arguments.add_option("device", a->device, "LINK/FAMILY:ADDRESS")->required();
    arguments.add_option("--loop", a->loop, "velocity, position or current, by family")->required();
    arguments.add_option("--aim", a->aim, "calm, normal or brisk; normal otherwise");
    arguments.add_option("--response", a->response, "Seconds of the closed loop, instead of an aim");
    arguments.add_option("--damping", a->damping, "Largest sensitivity Ms, with --response");
    a->where.declare(arguments, "Gain set the result belongs to, 0…");
    arguments.add_flag("--propose", a->propose, "End before a gain is written");
    arguments.add_flag("--store", a->store, "Wait until the unit has stored what is kept");
    arguments.add_flag("--keep", a->keep, "Also where nobody knows what it replaces");
    arguments.add_flag("--yes", a->yes, "Put back first, without asking, what an earlier experiment could not");
    arguments.add_option("--save", a->save, "Keep the result in a JSON file");
    return [a](Console &console) { return tune(console, *a); };
}

} // namespace mb::console
