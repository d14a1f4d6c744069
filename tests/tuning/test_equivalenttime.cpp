// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiment/equivalenttime.h"
#include "experiment/metrics.h"
#include "experiment/trial.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace mb::tuning {
namespace {

/// Ten seconds of a line that rises by one a second above `offset`, sampled each 0.1 s from `first` on.
Trace rising(double first, double offset)
{
    Trace trace;
    for (int i = 0; i < 100; ++i)
        trace.add(first + 0.1 * i, first + 0.1 * i + offset);
    return trace;
}

double roughest(const Trace &trace)
{
    double most = 0.0;
    for (std::size_t i = 1; i < trace.size(); ++i)
        most = std::max(most, std::abs(trace.y[i] - trace.y[i - 1]));
    return most;
}

TEST(EquivalentTime, TheMeanOfTwoRunsThatDifferHasTheSamplesOfBothAndNoJumpsBetweenThem)
{
    const std::vector<Trace> runs{rising(0.0, 0.0), rising(0.05, 1.0)};
    const Trace mean = averaged(runs);
    ASSERT_EQ(mean.size(), 200U);
    EXPECT_GT(roughest(merged(runs)), 0.9);
    EXPECT_LT(roughest(mean), 0.11);
    for (std::size_t i = 2; i < mean.size() - 2; ++i)
        EXPECT_NEAR(mean.y[i], mean.t[i] + 0.5, 1e-9) << mean.t[i];
}

TEST(EquivalentTime, TheMeanOfOneRunIsThatRunAndSilentRunsDoNotCount)
{
    const Trace one = rising(0.0, 3.0);
    EXPECT_EQ(averaged({one}), one);
    EXPECT_EQ(averaged({{}, one, {}}), one);
    EXPECT_TRUE(averaged({}).isEmpty());
    EXPECT_TRUE(averaged({{}, {}}).isEmpty());
}

TEST(EquivalentTime, ATrialThatWasRunTwiceIsDrawnAsTheMeanOfItsHolds)
{
    Trial trial;
    trial.stimulus.profile = Profile::Step;
    trial.stimulus.to = 10.0;
    trial.mode = Mode::Velocity;
    trial.repeat = 2;
    trial.holds = {{0.0, 1.0}, {2.0, 3.0}};
    Signal signal;
    signal.channel = "ch1.velocity";
    for (int i = 0; i < 300; ++i)
        signal.trace.add(0.01 * i, i < 150 ? 9.0 : 11.0);
    trial.signals = {signal};
    ASSERT_FALSE(trial.stimulus.edges().empty());
    const Trace drawn = trial.folded("velocity").part(0.05, 0.95);
    ASSERT_GT(drawn.size(), 100U);
    for (const double y : drawn.y)
        EXPECT_DOUBLE_EQ(y, 10.0);
}

TEST(EquivalentTime, DitheredRepeatsShowAStepFinerThanItsSamples)
{
    // a step of 8 ms lag seen every 20 ms: eight runs together see it every 2.5 ms
    constexpr double spacing = 0.020;
    std::vector<Trace> runs;
    for (int run = 0; run < 8; ++run) {
        const double delay = ditherOf(run, 8, spacing);
        Trace trace;
        for (int i = -10; i < 50; ++i) {
            const double t = i * spacing - delay;
            trace.add(t, t > 0.0 ? 1.0 - std::exp(-t / 0.008) : 0.0);
        }
        runs.push_back(trace);
    }
    const Trace all = merged(runs);
    ASSERT_EQ(all.size(), 480U);
    EXPECT_TRUE(std::is_sorted(all.t.begin(), all.t.end()));
    EXPECT_NEAR(samplePeriod(all), 0.0025, 1e-9);
    const double truth = 0.008 * std::log(9.0);
    const double alone = readResponse(runs.front(), 1.0, 0.0).metrics.rise.value_or(0.0);
    const double together = readResponse(all, 1.0, 0.0, 8).metrics.rise.value_or(0.0);
    EXPECT_GT(std::abs(alone - truth), 4.0 * std::abs(together - truth));
    EXPECT_NEAR(together, truth, 0.001);
}

} // namespace
} // namespace mb::tuning
