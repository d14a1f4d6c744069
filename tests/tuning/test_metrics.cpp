// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiment/effort.h"
#include "experiment/equivalenttime.h"
#include "experiment/metrics.h"
#include "tests/tuning/responses.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <vector>

namespace mb::tuning {
namespace {

struct System {
    double damping;
    double frequency;
};

/// What the exact response of a system has, from samples every 10 µs.
struct TrueMetrics {
    explicit TrueMetrics(System system)
    {
        constexpr double step = 1e-5;
        double peak = 0.0;
        for (int i = 0; i <= 300'000; ++i)
            y.push_back(test::secondOrder(system.damping, system.frequency, i * step));
        const auto reach = [this](double level) {
            return step * static_cast<double>(std::find_if(y.begin(), y.end(), [level](double v) {
                return v >= level;
            }) - y.begin());
        };
        rise = reach(0.9) - reach(0.1);
        for (const double value : y)
            peak = std::max(peak, value);
        overshoot = peak - 1.0;
    }
    [[nodiscard]] double settle(double band) const
    {
        for (std::size_t i = y.size(); i > 0; --i) {
            if (std::abs(y[i - 1] - 1.0) > band)
                return static_cast<double>(i - 1) * 1e-5;
        }
        return 0.0;
    }
    std::vector<double> y;
    double rise = 0.0;
    double overshoot = 0.0;
};

double percentile95(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    const double at = 0.95 * static_cast<double>(values.size() - 1);
    const auto low = static_cast<std::size_t>(at);
    const std::size_t high = std::min(low + 1, values.size() - 1);
    return values[low] + (at - static_cast<double>(low)) * (values[high] - values[low]);
}

Trace goldenStep(System system)
{
    std::mt19937_64 random(1);
    return test::sampledStep(system.damping, system.frequency, 0.001, 0.0, 0.0, random);
}

struct Golden {
    System system;
    double rise;      ///< ms
    double overshoot; ///< %
    double settle;    ///< ms
    double iae;
};

class GoldenStep : public testing::TestWithParam<Golden> { };

TEST_P(GoldenStep, IsReadToTheLastDigit)
{
    const Golden &golden = GetParam();
    const Response response = readResponse(goldenStep(golden.system), 1.0, 0.0);
    ASSERT_TRUE(response.moved);
    EXPECT_NEAR(response.metrics.rise.value_or(0.0) * 1e3, golden.rise, 0.15);
    EXPECT_NEAR(response.metrics.overshoot.value_or(-1.0) * 100.0, golden.overshoot, 0.015);
    EXPECT_NEAR(response.metrics.settle.value_or(0.0) * 1e3, golden.settle, 1.5);
    EXPECT_NEAR(response.metrics.iae.value_or(0.0), golden.iae, 0.00015);
    EXPECT_NEAR(response.metrics.sse.value_or(1.0), 0.0, 1e-5);
    EXPECT_LT(response.metrics.noise.value_or(1.0), 1e-3);
    EXPECT_FALSE(response.widened);
}

// Analytic second-order steps.
INSTANTIATE_TEST_SUITE_P(Analytic, GoldenStep,
    testing::Values(Golden{{0.5, 15.0}, 109.2, 16.30, 538.0, 0.1142}, Golden{{0.7, 15.0}, 141.7, 4.60, 399.0, 0.1073},
        Golden{{1.0, 20.0}, 167.9, 0.0, 292.0, 0.1000}));

/// The way of a first-order lag of 0.2 s, for so long.
Trace laggingFor(double seconds, double noise = 0.0)
{
    std::mt19937_64 random(1);
    std::normal_distribution<double> error(0.0, 1.0);
    Trace trace;
    for (double t = -0.1; t < seconds; t += 0.002)
        trace.add(t, 1.0 - std::exp(-std::max(t, 0.0) / 0.2) + noise * error(random));
    return trace;
}

TEST(Metrics, OfAResponseThatIsStillOnItsWayTellNoEnd)
{
    for (const double noise : {0.0, 0.005}) {
        for (const double seconds : {0.15, 0.3, 0.5}) {
            const Response cut = readResponse(laggingFor(seconds, noise), 1.0, 0.0);
            EXPECT_TRUE(cut.moved);
            EXPECT_FALSE(cut.metrics.overshoot) << seconds << ": " << *cut.metrics.overshoot;
            EXPECT_FALSE(cut.metrics.rise) << seconds;
            EXPECT_FALSE(cut.metrics.settle) << seconds;
            EXPECT_NEAR(cut.metrics.sse.value_or(0.0), std::exp(-0.875 * seconds / 0.2), 0.02);
        }
        const Response whole = readResponse(laggingFor(2.0, noise), 1.0, 0.0);
        EXPECT_NEAR(whole.metrics.overshoot.value_or(1.0), 0.0, 0.01);
        EXPECT_TRUE(whole.metrics.rise);
    }
}

TEST(Metrics, OfALoopThatSwingsTellHowFarWhereverItsHoldEnds)
{
    for (const double seconds : {0.31, 0.42, 0.5, 0.63, 0.77}) {
        Trace trace;
        for (double t = -0.1; t < seconds; t += 0.002)
            trace.add(t, 1.0 - std::cos(15.0 * std::max(t, 0.0)));
        EXPECT_GT(readResponse(trace, 1.0, 0.0).metrics.overshoot.value_or(0.0), 0.1) << seconds;
    }
}

struct Accuracy {
    double noise;
    double rise;       ///< share of the true one
    double overshoot;  ///< share of the step
    double settle;     ///< s at 5 and 10 ms
    double settleSlow; ///< s at 20 ms
};

/// How wrong rise (share), overshoot (of the step) and settling (s) were in each trial.
struct Errors {
    std::vector<double> rise;
    std::vector<double> overshoot;
    std::vector<double> settle;
};

void addTrials(Errors &errors, System system, double period, double noise, std::mt19937_64 &random)
{
    const TrueMetrics truth(system);
    for (int trial = 0; trial < 60; ++trial) {
        const double phase = std::uniform_real_distribution<double>(0.0, period)(random);
        const Trace trace = test::sampledStep(system.damping, system.frequency, period, phase, noise, random);
        const Response response = readResponse(trace, 1.0, 0.0);
        errors.rise.push_back(std::abs(response.metrics.rise.value_or(0.0) - truth.rise) / truth.rise);
        errors.overshoot.push_back(std::abs(response.metrics.overshoot.value_or(-1.0) - truth.overshoot));
        if (response.metrics.settle)
            errors.settle.push_back(std::abs(*response.metrics.settle - truth.settle(response.band)));
    }
}

TEST(StepMetrics, AreAsAccurateOverSixtyNoisyTrialsOfEachSystemAsPromised)
{
    constexpr Accuracy promised[] = {
        {0.0, 0.013, 0.001, 0.0, 0.0},
        {0.005, 0.03, 0.014, 0.040, 0.040},
        {0.01, 0.06, 0.023, 0.075, 0.200},
    };
    std::mt19937_64 random(1);
    std::printf("Ts ms  noise %%   95th percentile: rise %%   overshoot pt   settle ms\n");
    for (const double period : {0.005, 0.010, 0.020}) {
        for (const Accuracy &limit : promised) {
            Errors errors;
            for (const System system : {System{0.5, 15.0}, System{0.7, 15.0}, System{1.0, 20.0}})
                addTrials(errors, system, period, limit.noise, random);
            const double rise = percentile95(errors.rise);
            const double overshoot = percentile95(errors.overshoot);
            const double settle = percentile95(errors.settle);
            std::printf("%5.0f %8.1f %25.2f %14.2f %11.0f\n", period * 1e3, limit.noise * 100.0, rise * 100.0,
                overshoot * 100.0, settle * 1e3);
            EXPECT_LE(rise, limit.rise) << period << ' ' << limit.noise;
            EXPECT_LE(overshoot, limit.overshoot) << period << ' ' << limit.noise;
            EXPECT_LE(settle, std::max(period < 0.02 ? limit.settle : limit.settleSlow, period));
            EXPECT_GE(errors.settle.size(), 175U) << "hardly ever is nothing told";
        }
    }
}

TEST(StepMetrics, SettlingInTwoPercentOfNoiseIsNotGuessedFromOneRunButReadFromFour)
{
    std::mt19937_64 random(7);
    std::vector<Trace> runs;
    for (int i = 0; i < 4; ++i)
        runs.push_back(test::sampledStep(0.7, 15.0, 0.010, 0.0025 * i, 0.02, random));
    const Response one = readResponse(runs.front(), 1.0, 0.0);
    EXPECT_FALSE(one.metrics.settle);
    EXPECT_TRUE(one.metrics.rise);
    const Response four = readResponse(merged(runs), 1.0, 0.0, 4);
    ASSERT_TRUE(four.metrics.settle);
    EXPECT_NEAR(*four.metrics.settle, TrueMetrics({0.7, 15.0}).settle(four.band), 0.1);
}

/// A step of seven levels of its reading, in noise of two of them, held for 80 ms and seen every millisecond.
Trace coarseStep(System system, double delay, std::mt19937_64 &random)
{
    constexpr double level = 1.0 / 7.0;
    std::normal_distribution<double> error(0.0, 2.0 * level);
    Trace trace;
    for (int i = -250; i < 80; ++i) {
        const double t = 1e-3 * i + delay;
        const double y = test::secondOrder(system.damping, system.frequency, t) + error(random);
        trace.add(t, level * std::round(y / level));
    }
    return trace;
}

TEST(StepMetrics, TheMeanOfManyStepsTellsOvershootInNoiseOfAQuarterOfAStep)
{
    std::mt19937_64 random(11);
    const auto overshoots = [&random](System system, int repeats) {
        std::vector<double> seen;
        for (int trial = 0; trial < 40; ++trial) {
            std::vector<Trace> runs;
            for (int i = 0; i < repeats; ++i)
                runs.push_back(coarseStep(system, ditherOf(i, repeats, 1e-3), random));
            seen.push_back(readResponse(merged(runs), 1.0, 0.0, repeats).metrics.overshoot.value_or(1.0));
        }
        std::sort(seen.begin(), seen.end());
        return seen;
    };
    const auto damped = overshoots({1.0, 500.0}, 24);
    const auto swinging = overshoots({0.2, 400.0}, 24);
    std::printf("  none: %.3f median, %.3f in 38 of 40; of 53 %%: %.3f median, %.3f in 38 of 40\n", damped[20],
        damped[37], swinging[20], swinging[2]);
    EXPECT_LE(damped[20], 0.05);
    EXPECT_LE(damped[37], 0.10);
    EXPECT_GE(swinging[2], 0.10);
}

TEST(StepMetrics, RepeatsWhoseSamplesLieUponEachOtherOvershootNoMoreThanTheirHighestSample)
{
    std::vector<Trace> runs;
    for (int run = 0; run < 3; ++run) {
        Trace trace;
        for (int i = -50; i < 1000; ++i) {
            const double t = i * 1e-3 + run * 1e-7; // a stamp of each, hardly beside those of the others
            const double end = 1.0 + (run - 1) * 2e-3;
            trace.add(t, t < 0.0 ? 0.0 : end * (1.0 - std::exp(-t / 0.05)));
        }
        runs.push_back(trace);
    }
    const Response response = readResponse(merged(runs), 1.0, 0.0, 3);
    ASSERT_TRUE(response.metrics.overshoot);
    EXPECT_LT(*response.metrics.overshoot, 0.01);
}

TEST(StepMetrics, ALoopThatStopsShortSettlesThereAndItsErrorIsToldOfTheSetPoint)
{
    std::mt19937_64 random(1);
    Trace trace = test::sampledStep(1.0, 20.0, 0.005, 0.0, 0.0, random);
    for (double &value : trace.y)
        value = 1000.0 + value * 900.0;
    const Response response = readResponse(trace, 2000.0, 5.0);
    EXPECT_NEAR(response.metrics.sse.value_or(0.0), 0.1, 1e-3);
    EXPECT_NEAR(response.metrics.settle.value_or(0.0), 0.292, 0.006);
    EXPECT_DOUBLE_EQ(response.metrics.overshoot.value_or(-1.0), 0.0);
}

TEST(StepMetrics, AStepDownIsReadLikeOneUp)
{
    Trace down = goldenStep({0.5, 15.0});
    for (double &value : down.y)
        value = 500.0 - 800.0 * value;
    const Response response = readResponse(down, -300.0, 5.0);
    EXPECT_NEAR(response.metrics.overshoot.value_or(0.0), 0.163, 0.0002);
    EXPECT_NEAR(response.metrics.rise.value_or(0.0), 0.1092, 0.0002);
}

TEST(StepMetrics, WhatDidNotMoveHasNoRiseAndNoSettling)
{
    Trace still;
    Trace little = goldenStep({0.7, 15.0});
    for (int i = 0; i < 200; ++i)
        still.add(-0.3 + 0.01 * i, i % 2 == 0 ? 3.0 : 4.0);
    for (double &value : little.y)
        value *= 4.0; // whole way of a step of 4 counts
    for (const auto &[trace, target] : {std::pair{still, 1000.0}, std::pair{little, 4.0}}) {
        const Response response = readResponse(trace, target, 5.0);
        EXPECT_FALSE(response.moved);
        EXPECT_FALSE(response.metrics.rise);
        EXPECT_FALSE(response.metrics.settle);
        EXPECT_FALSE(response.metrics.overshoot);
    }
}

TEST(StepMetrics, AHoldThatEndsBeforeItSettlesHasNoSettlingTime)
{
    const Trace whole = goldenStep({0.5, 15.0});
    EXPECT_FALSE(readResponse(whole.part(-0.3, 0.45), 1.0, 0.0).metrics.settle);
    EXPECT_FALSE(readResponse(whole.part(-0.3, 0.003), 1.0, 0.0).metrics.rise);
    EXPECT_FALSE(readResponse(Trace(), 1.0, 0.0).moved);
}

TEST(StepMetrics, AnOpenLoopHasNoErrorBecauseItHasNoTarget)
{
    Trace trace = goldenStep({1.0, 20.0});
    for (double &value : trace.y)
        value *= 5000.0;
    const Response response = readResponse(trace, std::nullopt, 5.0);
    EXPECT_NEAR(response.metrics.rise.value_or(0.0), 0.1679, 0.0002);
    EXPECT_FALSE(response.metrics.sse);
    EXPECT_FALSE(response.metrics.iae);
}

TEST(Traces, ThePeriodOfSamplesIsTheMedianOfAllTheirSteps)
{
    Trace trace;
    for (const double time : {0.0, 1.0})
        trace.add(time, 0.0);
    EXPECT_DOUBLE_EQ(samplePeriod(trace), 1.0);
    for (const double time : {3.0, 4.0, 10.0})
        trace.add(time, 0.0);
    EXPECT_DOUBLE_EQ(samplePeriod(trace), 1.5);
}

TEST(Effort, IsReadOverTheHold)
{
    Trace current;
    Trace duty;
    for (int i = -20; i < 120; ++i) {
        const double t = 0.01 * i;
        current.add(t, t < 0.1 ? -58.0 : 4.0);
        const double chatter = i % 2 == 0 ? 0.02 : -0.02;
        duty.add(t, t < 0.25 - 1e-9 ? 0.5 : 0.3 + chatter);
    }
    Metrics metrics;
    readEffort(metrics, current, duty, 1.0, 0.5);
    EXPECT_DOUBLE_EQ(metrics.peakCurrent.value_or(0.0), 58.0);
    EXPECT_NEAR(metrics.saturated.value_or(0.0), 0.25, 0.011);
    EXPECT_NEAR(metrics.dutyChatter.value_or(0.0), 0.02, 0.002);
    Metrics unknown;
    readEffort(unknown, Trace(), Trace(), 1.0, 0.5);
    EXPECT_EQ(unknown, Metrics());
}

/// The first `seconds` of a step that would overshoot by 16.3 %.
Response cutAfter(double seconds)
{
    const Trace whole = goldenStep({0.5, 15.0});
    return cutShort(readResponse(whole.part(-0.3, seconds), 1.0, 0.0), seconds);
}

TEST(CutShort, OfAStepThatIsCutWhileItRisesNothingIsTold)
{
    for (const double seconds : {0.03, 0.06, 0.1, 0.2, 0.4, 0.5}) {
        SCOPED_TRACE(seconds);
        EXPECT_EQ(cutAfter(seconds).metrics, Metrics());
    }
}

TEST(CutShort, OfAStepThatHadSettledAllIsTold)
{
    const Metrics metrics = cutAfter(1.5).metrics;
    EXPECT_NEAR(metrics.rise.value_or(0.0), 0.1092, 0.0002);
    EXPECT_NEAR(metrics.overshoot.value_or(0.0), 0.163, 0.0002);
    EXPECT_NEAR(metrics.settle.value_or(0.0), 0.538, 0.002);
    EXPECT_NEAR(metrics.iae.value_or(0.0), 0.1142, 0.0002);
    EXPECT_NEAR(metrics.sse.value_or(1.0), 0.0, 1e-3);
}

TEST(Effort, OfRepeatsHasAnErrorOnlyWhereAllRunsHaveAValue)
{
    Metrics one;
    Metrics two;
    one.rise = 0.10;
    two.rise = 0.12;
    one.settle = 0.3;
    const Metrics errors = errorsOf({one, two});
    EXPECT_NEAR(errors.rise.value_or(0.0), 0.02, 1e-12);
    EXPECT_FALSE(errors.settle);
    EXPECT_FALSE(errorsOf({one}).rise);
}

} // namespace
} // namespace mb::tuning
