// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/rawstep.h"

#include "experiment/envelope.h"
#include "model/family.h"
#include "model/loopparameters.h"
#include "tuning/autotunerun.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mb::tuning {
namespace {

constexpr double leastGone = 3.0;     ///< counts
constexpr double passesOfStart = 2.0; ///< until the profile is as fast as it will be

} // namespace

ExperimentPlan rawStep(const AutotuneRun &run, RawGains gains, double counts, double seconds)
{
    const Family &family = run.device().family();
    ExperimentPlan plan;
    plan.mode = Mode::Position;
    plan.slot = run.plan().slot;
    plan.to = counts;
    plan.seconds = seconds;
    for (const auto &[role, value] : {std::pair(Role::Proportional, gains.p), std::pair(Role::Integral, 0.0),
             std::pair(Role::Derivative, gains.d)}) {
        if (const auto index = parameterOf(family, Mode::Position, run.plan().axis, run.plan().slot, role))
            plan.gains.push_back({*index, static_cast<std::int64_t>(value)});
    }
    plan.intent
        = say("a step of %1 counts with P %2, D %3", std::round(counts), std::round(gains.p), std::round(gains.d));
    return plan;
}

void leadByProfile(const AutotuneRun &run, double rate, ExperimentPlan &plan)
{
    if (rate <= 0.0)
        return;
    const Family &family = run.device().family();
    const RawLoop &raw = family.trials->raw;
    plan.profiled = true;
    for (const auto &[key, value] :
        {std::pair(raw.profileRate, rate), std::pair(raw.profileAcceleration, rate / (passesOfStart * raw.cycle))}) {
        if (const auto index = findParameter(family.parameters, key))
            plan.gains.push_back({*index, std::llround(value)});
    }
}

bool hasGone(const AutotuneRun &run)
{
    const auto position = axisChannel(run.device(), "position", run.plan().axis);
    const auto last = position ? run.device().telemetry()->latest(*position) : std::nullopt;
    return last && std::abs(last->value) >= leastGone;
}

DrawnCurrent::DrawnCurrent(const AutotuneRun &run)
    : m_channel(axisChannel(run.device(), "current", run.plan().axis))
    , m_subscription(run.device().telemetry()->samples().add([this, &stream = run.stream()](const Sample &sample) {
        if (!m_channel || sample.channel != *m_channel || !stream.isRunning())
            return;
        m_last = std::abs(sample.value);
        m_most = std::max(m_most, m_last);
    }))
{
}

} // namespace mb::tuning
