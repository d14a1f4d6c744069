// SPDX-License-Identifier: GPL-3.0-or-later
#include "service/motorfigures.h"

#include "experiment/envelope.h"
#include "model/family.h"
#include "tuning/currentidentification.h"
#include "tuning/identification.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mb::service {
namespace {

using tuning::Trial;

constexpr double firstDuty = 0.15;
constexpr double firstSeconds = 0.4;
constexpr double strongest = 0.4; ///< duty
constexpr double nearlyFull = 0.96;
constexpr double weaker = 0.6; ///< of the stronger pushes
constexpr double taus = 4.0;   ///< that a push lasts
constexpr double samples = 14.0;
constexpr double longest = 1.0; ///< s
constexpr double usable = 0.75; ///< of a limit
constexpr double reserve = 1.3; ///< friction takes a smaller share of a stronger push

struct Pushing {
    Device &device;
    SetPointStream &stream;
    int axis = 1;
    int slot = 0;
    Envelope limits;
    Envelope bounds; ///< by these, and by what the device allows itself
    tuning::ExperimentSurroundings surroundings;
    std::vector<Trial> trials;
};

Task<Trial> push(Pushing &pushing, double duty, double seconds)
{
    tuning::ExperimentPlan plan;
    plan.mode = Mode::Duty;
    plan.axis = pushing.axis;
    plan.slot = pushing.slot;
    plan.to = duty;
    plan.seconds = seconds;
    plan.limits = pushing.limits;
    if (const double rate = pushing.device.family().trials->currentRate; rate > 0.0)
        plan.rate = rate;
    co_return co_await tuning::runExperiment(pushing.device, pushing.stream, plan, pushing.surroundings).attempt();
}

/// How strong and how long the pushes are, after what the first has shown.
std::pair<double, double> measureOut(const Pushing &pushing, const std::vector<tuning::PushRecord> &seen)
{
    double duty = std::min(strongest, nearlyFull * pushing.bounds.duty.value_or(1.0));
    const auto fit = tuning::fitPushes(seen);
    if (!fit)
        return {duty, longest};
    const double gain = reserve * std::abs(fit->speeds.front() / seen.front().duty);
    if (pushing.bounds.speed)
        duty = std::min(duty, usable * *pushing.bounds.speed / gain);
    const double period = std::max(tuning::samplePeriod(seen.front().position), 1e-3);
    double seconds = std::clamp(taus * fit->tau, samples * period, longest);
    if (pushing.bounds.travel)
        seconds = std::min(seconds, usable * *pushing.bounds.travel / (1.25 * gain * duty));
    return {duty, std::max(seconds, 0.1)};
}

/// There and back, so that it stands about where it stood; whether the next may begin.
Task<bool> pushBothWays(Pushing &pushing, double duty, double seconds)
{
    for (const double each : {duty, -duty}) {
        auto next = push(pushing, each, seconds);
        pushing.trials.push_back(co_await std::move(next));
        if (!pushing.trials.back().mayGoOn())
            co_return false;
    }
    co_return true;
}

bool wentWith(const Trial &trial)
{
    const tuning::Signal *const position = trial.signal("position");
    if (!position || position->trace.isEmpty() || trial.holds.empty())
        return false;
    const tuning::Trace way = position->trace.part(trial.holds.front().from, trial.holds.front().to);
    return way.size() > 1 && (way.y.back() - way.y.front()) * trial.stimulus.to > 0.0
        && std::abs(way.y.back() - way.y.front()) >= 10.0;
}

void conclude(const std::vector<Trial> &trials, MotorFigures &figures)
{
    figures.encoder = std::ranges::all_of(trials, wentWith);
    const auto found = tuning::identify(trials);
    if (found) {
        const double volts = found->supply > 0.0 ? found->supply : 1.0;
        figures.friction = found->line.friction * volts;
        figures.gain = found->line.gain / volts;
    }
    const auto ohm = tuning::fitOhm(trials);
    if (ohm && ohm->supply > 0.0)
        figures.resistance = ohm->supply / ohm->gain;
}

} // namespace

Task<MotorFigures> measureMotor(Device &device, SetPointStream &stream, int axis, int slot, Envelope limits,
    tuning::ExperimentSurroundings surroundings)
{
    const auto position = tuning::axisChannel(device, "position", axis);
    const auto here = position ? device.telemetry()->latest(*position) : std::nullopt;
    auto reading = tuning::readOwnLimits(device, axis, slot, here ? here->value : 0.0);
    const Envelope own = co_await std::move(reading);
    const auto facts = tuning::factsOf(device, axis);
    const Envelope bounds = co_await tuning::resolve(device.family(), facts, Mode::Duty, limits, own);
    Pushing pushing{device, stream, axis, slot, limits, bounds, std::move(surroundings), {}};
    MotorFigures figures;
    bool goesOn = co_await pushBothWays(pushing, std::min(firstDuty, bounds.duty.value_or(1.0)), firstSeconds);
    if (goesOn) {
        const auto probes = std::exchange(pushing.trials, {});
        const auto [duty, seconds] = measureOut(pushing, tuning::pushesOf(probes.front()));
        goesOn = co_await pushBothWays(pushing, duty, seconds);
        if (goesOn)
            goesOn = co_await pushBothWays(pushing, weaker * duty, seconds);
    }
    if (goesOn)
        conclude(pushing.trials, figures);
    else
        figures.ended = std::move(pushing.trials.back());
    co_return figures;
}

} // namespace mb::service
