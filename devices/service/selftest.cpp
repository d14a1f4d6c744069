// SPDX-License-Identifier: GPL-3.0-or-later
#include "service/selftest.h"

#include "experiment/guards.h"
#include "service/figuretext.h"
#include "service/motorfigures.h"

#include <algorithm>

namespace mb::service {
namespace {

using tuning::Trial;

Message limitsText(const TestValue &value)
{
    if (!value.low)
        return say("limit %1", figureNumber(value.key, value.high.value_or(0.0)));
    return say(
        "limits %1 … %2", figureNumber(value.key, *value.low), figureNumber(value.key, value.high.value_or(0.0)));
}

/// What may be done about a value that is out of its limits.
Message remedyOf(std::string_view key)
{
    if (key == figure::encoder)
        return say("look at the plug and the polarity of encoder and motor, then test again");
    if (key == figure::resistance)
        return say("look at brushes, plugs and leads, then test again");
    if (key == figure::friction)
        return say("free the shaft and see that no brake is on, then test again");
    if (key == figure::gain)
        return say("see that this is the motor and the encoder of the recipe, then test again");
    return say("see that motor and load are those of the recipe, then test again");
}

/// Why a trial ended that should have ended by itself.
Error failureOf(const Trial &trial)
{
    if (!trial.stopped)
        return {Fault::Unsafe, say("the stop of the self-test was not confirmed: %1", trial.detail),
            say("cut the power if the motor still turns")};
    if (trial.reason == tuning::EndReason::Interrupted)
        return {Fault::Unsafe, say("the self-test was stopped by hand"), say("test again when it is safe")};
    if (trial.reason == tuning::EndReason::Link)
        return {Fault::LinkLost, say("the unit was not heard during the self-test: %1", trial.detail),
            say("look at the cable and test again")};
    if (trial.reason == tuning::EndReason::None)
        return {Fault::Refused, say("the self-test could not go on: %1", trial.detail)};
    return {Fault::Unsafe, say("the self-test was ended by the guard '%1': %2", toString(trial.reason), trial.detail),
        say("remove the cause, then test again")};
}

void endBy(TestFinding &finding, const Trial &trial)
{
    finding.failure = failureOf(trial);
    finding.ending = trial.stopped ? Ending::None : Ending::StopUnconfirmed;
}

std::optional<double> figureOf(const MotorFigures &figures, std::string_view key)
{
    if (key == figure::resistance)
        return figures.resistance;
    if (key == figure::friction)
        return figures.friction;
    if (key == figure::gain)
        return figures.gain;
    return figures.encoder ? 1.0 : 0.0;
}

/// What cannot be told of a response that was still on its way.
bool isOfItsEnd(std::string_view key)
{
    return key == "rise" || key == "settle" || key == "overshoot";
}

void evaluate(TestFinding &finding, const SelfTest &test, const Trial &trial, const MotorFigures &figures)
{
    const Message shortfall = tuning::shortfallOf(trial.metrics);
    for (const Acceptance &limit : test.accept) {
        finding.values.push_back(judged(
            limit, isFigure(limit.key) ? figureOf(figures, limit.key) : tuning::metricOf(trial.metrics, limit.key)));
        const TestValue &value = finding.values.back();
        if (value.passed || finding.failure)
            continue;
        const bool isShort = !value.value && isOfItsEnd(value.key) && !shortfall.empty();
        const Message what = isShort       ? shortfall
            : value.key == figure::encoder ? say("the encoder does not count both ways")
            : value.value
            ? say("%1 is %2, %3", figureName(value.key), figureNumber(value.key, *value.value), limitsText(value))
            : say("%1 could not be measured", figureName(value.key));
        finding.failure = Error{Fault::BadCheck, what,
            isShort
                ? say("see that motor and load are those of the recipe and that its time is enough, then test again")
                : remedyOf(value.key)};
    }
}

Task<Trial> step(
    Device &device, SetPointStream &stream, const SelfTest &test, tuning::ExperimentSurroundings surroundings)
{
    tuning::ExperimentPlan plan = planOf(test);
    plan.limits = test.limits;
    co_return co_await tuning::runExperiment(device, stream, std::move(plan), std::move(surroundings)).attempt();
}

} // namespace

TestValue judged(const Acceptance &limit, std::optional<double> value)
{
    TestValue out{limit.key, value, limit.low, limit.high};
    if (limit.key == figure::encoder)
        out.low = 1.0;
    out.passed = value && *value <= limit.high && (!out.low || *value >= *out.low);
    return out;
}

Task<TestFinding> runSelfTest(
    Device &device, SetPointStream &stream, SelfTest test, tuning::ExperimentSurroundings surroundings)
{
    TestFinding finding;
    MotorFigures figures;
    const auto wanted = [](const Acceptance &limit) { return isFigure(limit.key); };
    const bool identifies = std::ranges::any_of(test.accept, wanted);
    if (identifies) {
        figures = co_await measureMotor(device, stream, test.axis, test.slot, test.limits, surroundings);
        if (figures.ended) {
            endBy(finding, *figures.ended);
            co_return finding;
        }
    }
    const Trial trial = co_await step(device, stream, test, surroundings);
    finding.trial = trial.number;
    if (!trial.mayGoOn()) {
        endBy(finding, trial);
        co_return finding;
    }
    evaluate(finding, test, trial, figures);
    co_return finding;
}

} // namespace mb::service
