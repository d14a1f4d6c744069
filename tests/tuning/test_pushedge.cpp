// SPDX-License-Identifier: GPL-3.0-or-later
// When a push began whose duty does not come at once.
#include "tuning/pushedge.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace mb::tuning {
namespace {

constexpr double edgeStep = 0.02; ///< s between set-points
constexpr double target = 0.4;
constexpr int steps = 5; ///< that lead there, the first with the order
/// The duty held from step to step misses (1 + 2 + 3 + 4)/5 of one of them.
constexpr double exact = 2.0 * edgeStep;

/// `after`: s from a set-point to the sample that shows it; `late`: samples in which the output stays where it was.
Trial ledPush(double after, int late = 0)
{
    Trial trial;
    trial.stimulus.to = target;
    Signal told{"setpoint", "", {}};
    Signal duty{"duty", "", {}};
    duty.trace.add(after - edgeStep, 0.0);
    for (int i = 0; i < 20; ++i) {
        if (i < steps)
            told.trace.add(i * edgeStep, target * (i + 1) / steps);
        const int shown = i < 2 ? i + 1 : std::max(2, i + 1 - late);
        duty.trace.add(i * edgeStep + after, target * std::min(shown, steps) / steps);
    }
    trial.signals = {told, duty};
    return trial;
}

TEST(PushEdge, OfADutyThatTheProgramLeadsInStepsIsExactHoweverItIsSampled)
{
    for (const double after : {0.001, 0.005, 0.01, 0.019})
        EXPECT_NEAR(edgeOf(ledPush(after), 0.0, 0.0).at, exact, 1e-9) << after;
}

TEST(PushEdge, CountsWhatFrictionTakesOfEachStep)
{
    const double friction = target / steps; // the first step moves nothing, then a quarter, a half, three quarters
    EXPECT_NEAR(edgeOf(ledPush(0.001), 0.0, friction).at, (1.0 + 0.75 + 0.5 + 0.25) * edgeStep, 1e-9);
}

TEST(PushEdge, IsLaterWhereTheOutputDidNotFollowItsSteps)
{
    const Edge broken = edgeOf(ledPush(0.001, 4), 0.0, 0.0);
    EXPECT_NEAR(broken.whole, (steps - 1 + 4) * edgeStep, 1e-9);
    EXPECT_GT(broken.at, exact + 2.0 * edgeStep);
}

TEST(PushEdge, TellsTheStepsOfADutyThatTheProgramLeads)
{
    const Edge edge = edgeOf(ledPush(0.001), 0.0, 0.0);
    ASSERT_EQ(edge.steps.size(), static_cast<std::size_t>(steps));
    double at = -exact;
    for (const DutyStep &step : edge.steps) {
        EXPECT_NEAR(step.at, at, 1e-9);
        EXPECT_NEAR(step.share, 1.0 / steps, 1e-9);
        at += edgeStep;
    }
}

TEST(PushEdge, AWeakPushThatIsThereInTwoStepsHasBoth)
{
    Trial trial = ledPush(0.001);
    trial.stimulus.to = 2.0 * target / steps;
    for (Signal &signal : trial.signals) {
        for (double &y : signal.trace.y)
            y = std::min(y, trial.stimulus.to);
    }
    const Edge edge = edgeOf(trial, 0.0, 0.0);
    EXPECT_EQ(edge.steps.size(), 2U);
    EXPECT_NEAR(edge.at, 0.5 * edgeStep, 1e-9);
}

TEST(PushEdge, AnOrderWhoseFrameWasLostCameWithTheNext)
{
    Trial trial = ledPush(0.001);
    Trace &duty = trial.signals.back().trace;
    duty.y[3] = duty.y[2]; // of the third order nothing is seen
    EXPECT_NEAR(edgeOf(trial, 0.0, 0.0).at, exact + edgeStep / steps, 1e-9);
}

TEST(PushEdge, AnOrderOfWhichTheAnswersWereLostCameInTime)
{
    Trial trial = ledPush(0.001);
    Trace seen;
    const Trace &duty = trial.signals.back().trace;
    for (std::size_t i = 0; i < duty.size(); ++i) {
        if (i < 5 || i > 9)
            seen.add(duty.t[i], duty.y[i]);
    }
    trial.signals.back().trace = seen;
    EXPECT_NEAR(edgeOf(trial, 0.0, 0.0).at, exact, 1e-9);
}

TEST(PushEdge, OfADriveThatRampsByItselfIsThatOfItsSamples)
{
    Trial trial = ledPush(0.001);
    Trace at;
    at.add(0.0, target);
    trial.signals.front().trace = at; // the set-point was there at once
    // straight lines from sample to sample: what they miss of the whole, times their seconds
    const double missing = 0.9 * 0.001 + (0.7 + 0.5 + 0.3 + 0.1) * edgeStep;
    EXPECT_NEAR(edgeOf(trial, 0.0, 0.0).at, missing, 1e-9);
}

TEST(PushEdge, WhatComesMoreThanHalfASecondAfterTheOrderIsNotItsEdge)
{
    for (const double late : {0.4, 0.6}) {
        Trial trial = ledPush(0.001);
        Trace order;
        order.add(0.0, target);
        Trace duty;
        for (int i = -5; i < 50; ++i)
            duty.add(i * edgeStep, i * edgeStep > late ? target : 0.0);
        trial.signals.front().trace = order;
        trial.signals.back().trace = duty;
        const Edge edge = edgeOf(trial, 0.0, 0.0);
        EXPECT_NEAR(edge.at, late < 0.5 ? late : 0.0, edgeStep) << late;
        EXPECT_EQ(edge.at > 0.0, late < 0.5) << late;
    }
}

TEST(PushRelease, OfADutyThatIsLedDownInStepsIsExactHoweverItIsSampled)
{
    for (const double after : {0.001, 0.005, 0.01, 0.019}) {
        Trial trial = ledPush(after);
        for (Signal &signal : trial.signals) {
            for (double &y : signal.trace.y)
                y = target - y;
        }
        EXPECT_NEAR(releaseOf(trial, 0.0), exact, 1e-9) << after;
    }
}

TEST(PushEdge, IsTheOrderWhereNoDutyIsTold)
{
    Trial trial;
    trial.stimulus.to = target;
    EXPECT_EQ(edgeOf(trial, 0.25, 0.0).at, 0.25);
}

} // namespace
} // namespace mb::tuning
