// SPDX-License-Identifier: GPL-3.0-or-later
// What steps of a position loop with raw gains tell before anything is fitted.
#include "tuning/twopointfit.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mb::tuning {
namespace {

/// From 100 to 300 counts at 1 s, and back at 2 s; at once, and short of both ends by so many counts.
Trial steppedTrial(double missing = 0.0)
{
    Trial trial;
    trial.mode = Mode::Position;
    trial.stimulus.from = 100.0;
    trial.stimulus.to = 300.0;
    trial.holds = {{1.0, 1.9}};
    trial.returns = {{2.0, 2.9}};
    Signal position{"ch1.position", "counts", {}};
    for (int i = 0; i < 300; ++i) {
        const double t = 0.01 * i + 0.005;
        position.trace.add(t, t > 1.0 && t < 2.0 ? 300.0 - missing : 100.0 + missing);
    }
    trial.signals = {position};
    return trial;
}

TEST(LoopRuns, AreTheWaysToTheTargetAndBackFromWhereItStood)
{
    const auto runs = runsOf(steppedTrial(10.0), 50.0, 700.0, 400.0);
    ASSERT_EQ(runs.size(), 2U);
    EXPECT_DOUBLE_EQ(runs[0].step, 190.0); // from 110
    EXPECT_DOUBLE_EQ(runs[0].from, -10.0);
    EXPECT_DOUBLE_EQ(runs[0].way.y.back(), 180.0);
    EXPECT_NEAR(runs[0].way.t.front(), 0.005, 1e-9);
    EXPECT_NEAR(runs[0].way.t.back(), 0.895, 1e-9);
    EXPECT_DOUBLE_EQ(runs[1].step, -190.0);
    EXPECT_DOUBLE_EQ(runs[1].from, 10.0);
    EXPECT_DOUBLE_EQ(runs[1].way.y.back(), -180.0);
    for (const LoopRun &run : runs) {
        EXPECT_EQ(run.p, 50.0);
        EXPECT_EQ(run.d, 700.0);
        EXPECT_EQ(run.rate, 400.0);
        EXPECT_DOUBLE_EQ(run.rise(), 0.5) << "from 100 to 300";
    }
    EXPECT_DOUBLE_EQ(leftOf(runs[0]), 10.0 * 50.0);
    EXPECT_DOUBLE_EQ(leftOf(runs[1]), -10.0 * 50.0);
}

TEST(LoopRuns, AreNoneOfWhatDidNotMoveOrWasNotSeen)
{
    const auto countOf = [](const Trial &trial) { return runsOf(trial, 1.0, 1.0).size(); };
    EXPECT_EQ(countOf(steppedTrial(98.5)), 2U) << "three counts";
    EXPECT_EQ(countOf(steppedTrial(98.6)), 0U);
    Trial silent = steppedTrial();
    silent.signals.clear();
    EXPECT_EQ(countOf(silent), 0U);
    Trial begun = steppedTrial(); // nothing of the 0.1 s before tells where it stood
    begun.signals.front().trace = begun.signals.front().trace.part(1.0, 3.0);
    EXPECT_EQ(countOf(begun), 1U);
    Trial few = steppedTrial();
    few.holds.front().to = 1.08; // eight samples
    EXPECT_EQ(countOf(few), 2U);
    few.holds.front().to = 1.07;
    EXPECT_EQ(countOf(few), 1U);
    Trial stood = steppedTrial(); // where it stood is less than three tenths of a step from its target
    for (double &y : stood.signals.front().trace.y)
        y = y < 200.0 ? 241.0 : 300.0;
    EXPECT_EQ(countOf(stood), 1U) << "only the way back";
    for (double &y : stood.signals.front().trace.y)
        y = y < 270.0 ? 239.0 : 300.0;
    EXPECT_EQ(countOf(stood), 2U);
}

LoopRun straightRun(double step, double rate, double from = 0.0)
{
    LoopRun run{10.0, 0.0, step, {}, rate, from};
    for (int i = 0; i < 100; ++i)
        run.way.add(0.01 * i, step * std::min(0.01 * i / 0.5, 1.0));
    return run;
}

TEST(LoopRuns, PassTheMiddleOfTheirWayBetweenSamples)
{
    EXPECT_NEAR(halfWay(straightRun(100.0, 0.0)), 0.25, 1e-9);
    EXPECT_NEAR(halfWay(straightRun(-73.0, 0.0)), 0.25, 1e-9);
    EXPECT_NEAR(halfWay(straightRun(100.0, 500.0)), 0.25 - 0.1, 1e-9) << "after its set-point did";
    EXPECT_NEAR(halfWay(straightRun(100.0, 500.0, -100.0)), 0.25 - 0.2, 1e-9);
    LoopRun never = straightRun(100.0, 0.0);
    for (double &y : never.way.y)
        y = std::min(y, 49.0);
    EXPECT_NEAR(halfWay(never), 0.99, 1e-9);
}

TEST(LoopRuns, AWaitBehindALostAnswerIsALongWayToTheFirstSample)
{
    LoopRun run = straightRun(100.0, 0.0);
    EXPECT_FALSE(run.hasWaited());
    for (double &t : run.way.t)
        t += 0.0185;
    EXPECT_FALSE(run.hasWaited());
    for (double &t : run.way.t)
        t += 0.001;
    EXPECT_TRUE(run.hasWaited());
    EXPECT_FALSE(LoopRun().hasWaited());
}

TEST(LoopRuns, AStepOfSecondOrderIsFoundOfItsSamples)
{
    for (const double zeta : {0.4, 1.0, 1.8}) {
        const double omega = 20.0;
        const double drag = 2.0 * zeta * omega;
        LoopRun run{10.0, 10.0, 200.0, {}};
        for (int i = -5; i < 100; ++i)
            run.way.add(0.01 * i, 0.97 * 200.0 * stepOfSecondOrder(drag, omega * omega, 0.01 * i - 0.005));
        const auto fit = fitStep(run);
        ASSERT_TRUE(fit);
        EXPECT_NEAR(fit->omega, omega, 0.02 * omega);
        EXPECT_NEAR(fit->zeta, zeta, 0.02 * zeta);
        EXPECT_NEAR(fit->end, 0.97, 0.002);
        EXPECT_LT(fit->residual, 1e-3);
    }
    LoopRun few{10.0, 10.0, 200.0, {}};
    for (int i = 0; i < 7; ++i)
        few.way.add(0.01 * i, 10.0 * i);
    EXPECT_FALSE(fitStep(few));
    few.way.add(0.07, 70.0);
    EXPECT_TRUE(fitStep(few));
    few.step = 0.0;
    EXPECT_FALSE(fitStep(few));
}

TEST(LoopRuns, ADampedStepIsThatOfItsTwoLags)
{
    // (s + 5)(s + 40): 1 − (40·e^(−5t) − 5·e^(−40t))/35
    for (const double t : {0.01, 0.1, 0.5})
        EXPECT_NEAR(stepOfSecondOrder(45.0, 200.0, t),
            1.0 - (40.0 * std::exp(-5.0 * t) - 5.0 * std::exp(-40.0 * t)) / 35.0, 1e-9);
}

TEST(LoopRuns, ARampIsTheMeanOfItsSteps)
{
    // after a long time a ramp is at its end; its derivative's part adds `lead` of its speed while it lasts
    EXPECT_NEAR(rampOfSecondOrder(40.0, 400.0, 0.1, 5.0, 0.4), 1.0, 1e-9);
    EXPECT_EQ(rampOfSecondOrder(40.0, 400.0, 0.1, 0.2, 0.0), stepOfSecondOrder(40.0, 400.0, 0.2));
    double mean = 0.0;
    for (int i = 0; i < 10'000; ++i)
        mean += stepOfSecondOrder(40.0, 400.0, 0.3 - 0.2 * (i + 0.5) / 10'000) / 10'000;
    EXPECT_NEAR(rampOfSecondOrder(40.0, 400.0, 0.0, 0.3, 0.2), mean, 1e-3);
    const double led = stepOfSecondOrder(40.0, 400.0, 0.3) - stepOfSecondOrder(40.0, 400.0, 0.1);
    EXPECT_NEAR(rampOfSecondOrder(40.0, 400.0, 0.06, 0.3, 0.2), mean + 0.06 * led / 0.2, 1e-3);
}

TEST(LoopRuns, ADelayIsWithinWhatALinkTakes)
{
    EXPECT_EQ(delayOf(-3.0), 0.0);
    EXPECT_DOUBLE_EQ(delayOf(2.5), 0.025);
    EXPECT_DOUBLE_EQ(delayOf(100.0), 0.08);
}

} // namespace
} // namespace mb::tuning
