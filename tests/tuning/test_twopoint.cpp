// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/tuning/experimentbench.h"
#include "tests/tuning/tuningbench.h"
#include "tuning/autotune.h"
#include "tuning/twopointfit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <random>

namespace mb::tuning {
namespace {

using test::ExperimentBench;

struct Loop {
    double p = 2.5;   ///< 1/s² per raw P
    double d = 0.003; ///< 1/s per raw D
    double drag = 12.0;
    double delay = 0.006;
};

/// A record as telemetry brings it: whole counts, a period of 15 ms with 1 ms of jitter.
LoopRun runWith(const Loop &loop, double p, double d, double step, unsigned seed)
{
    std::mt19937 random(seed);
    std::normal_distribution<double> late(0.0, 0.001);
    LoopRun run{p, d, step, {}};
    for (double t = -0.05; t < 0.9; t += 0.015) {
        const double y = step * stepOfSecondOrder(loop.drag + loop.d * d, loop.p * p, t - loop.delay);
        run.way.add(t + late(random), std::floor(y));
    }
    return run;
}

TEST(TwoPointFit, StepsOfSecondOrderHaveTheirGoldenOvershoot)
{
    double most = 0.0;
    for (double t = 0.0; t < 1.0; t += 1e-3)
        most = std::max(most, stepOfSecondOrder(2.0 * 0.5 * 15.0, 225.0, t));
    EXPECT_NEAR(most, 1.1630, 1e-4);
    EXPECT_NEAR(stepOfSecondOrder(40.0, 400.0, 0.1), 1.0 - std::exp(-2.0) * 3.0, 1e-12);
    EXPECT_NEAR(stepOfSecondOrder(40.0001, 400.0, 0.1), stepOfSecondOrder(39.9, 400.0, 0.1), 1e-3);
    EXPECT_EQ(stepOfSecondOrder(10.0, 100.0, -1.0), 0.0);
}

TEST(TwoPointFit, TellsWhatPAndDDoOutOfSixSteps)
{
    const Loop loop;
    double worst = 0.0;
    for (unsigned seed = 1; seed <= 8; ++seed) {
        std::vector<LoopRun> runs;
        unsigned number = 10 * seed;
        for (const double sign : {1.0, -1.0}) {
            runs.push_back(runWith(loop, 217.0, 7000.0, 150.0 * sign, ++number));
            runs.push_back(runWith(loop, 542.0, 7000.0, 60.0 * sign, ++number));
            runs.push_back(runWith(loop, 542.0, 14000.0, 60.0 * sign, ++number));
        }
        const auto fit = fitTwoPoint(runs);
        ASSERT_TRUE(fit) << fit.error().text();
        worst = std::max({worst, std::abs(fit->p / loop.p - 1.0), std::abs(fit->d / loop.d - 1.0)});
        EXPECT_NEAR(fit->drag, loop.drag, 0.2 * loop.drag);
        EXPECT_NEAR(fit->delay, loop.delay, 0.002);
    }
    std::printf("  P and D within %.1f %% over 8 seeds\n", 100.0 * worst);
    EXPECT_LE(worst, 0.05);
}

TEST(TwoPointFit, RefusesStepsThatDoNotTellItsGainsApart)
{
    const Loop loop;
    std::vector<LoopRun> runs;
    for (unsigned seed = 1; seed <= 4; ++seed)
        runs.push_back(runWith(loop, 217.0, 7000.0, 150.0, seed));
    const auto fit = fitTwoPoint(runs);
    ASSERT_FALSE(fit);
    EXPECT_EQ(fit.error().fault, Fault::OutOfRange);
}

TEST(TwoPointTuning, TunesSupermodifiedNodesOfBothScales)
{
    for (const int node : {4, 5}) {
        ExperimentBench bench("sim:serial", "supermodified", node);
        Simulator &other = *bench.bench.simulator("supermodified:" + std::to_string(9 - node));
        const double stood = other.position();
        const auto report = test::tune(bench, test::planOf(Mode::Position));
        ASSERT_TRUE(report) << report.error().text();
        test::print(*report);
        EXPECT_EQ(other.position(), stood) << "the other node has moved";
        EXPECT_FALSE(other.isOutputOn());
        EXPECT_EQ(report->result, TuneResult::Kept) << report->evidence;
        EXPECT_LE(report->measured.overshoot.value_or(1.0), 0.05);
        EXPECT_TRUE(report->stopped);
        EXPECT_LE(report->seconds, 60.0); // A13
        ASSERT_TRUE(report->motor);
        for (const Gate &gate : report->gates)
            std::printf("  %s: %s\n", gate.name.c_str(), gate.detail.english().c_str());
        for (const ScaledGains::Row &row : report->proposed.rows)
            EXPECT_EQ(test::rawOf(bench, row.key), row.raw) << row.key;
    }
}

std::vector<std::int64_t> gainsOf(ExperimentBench &bench)
{
    return {test::rawOf(bench, "gain.p"), test::rawOf(bench, "gain.i"), test::rawOf(bench, "gain.d")};
}

TEST(TwoPointTuning, KeepsMostGearedMotorsOfEveryDialectAndChangesNothingOfTheOthers)
{
    int kept = 0;
    int all = 0;
    for (const std::string dialect : {"D1", "D2", "D3"}) {
        for (const std::string motor : {"25d", "25dlp", "n20"}) {
            for (const std::string load : {"1.5", "5", "10"}) {
                ExperimentBench bench("sim:serial", "supermodified", 6,
                    "supermodified:6,dialect=" + dialect + ",motor=" + motor + ",load=" + load);
                const auto before = gainsOf(bench);
                const auto report = test::tune(bench, test::planOf(Mode::Position));
                ASSERT_TRUE(report) << report.error().text();
                std::printf("  %s %-6s %-4s %s: overshoot %.3f settle %.3f; %s\n", dialect.c_str(), motor.c_str(),
                    load.c_str(), std::string(toString(report->result)).c_str(),
                    report->measured.overshoot.value_or(-1.0), report->measured.settle.value_or(-1.0),
                    report->evidence.english().c_str());
                ++all;
                kept += report->result == TuneResult::Kept ? 1 : 0;
                if (report->result == TuneResult::Kept) {
                    EXPECT_LE(report->measured.overshoot.value_or(1.0), 0.05);
                } else {
                    EXPECT_EQ(gainsOf(bench), before);
                }
                EXPECT_FALSE(bench.simulator()->isOutputOn());
            }
        }
    }
    std::printf("  kept %d of %d\n", kept, all);
    EXPECT_GE(kept, 25);
}

TEST(TwoPointTuning, AStalledShaftOrAWrongSensorStopsItAndTheGainsStay)
{
    for (const int node : {4, 5}) {
        for (const std::string_view fault : {"stall", "encoder-dead", "encoder-reversed"}) {
            ExperimentBench bench("sim:serial", "supermodified", node);
            const auto before = gainsOf(bench);
            ASSERT_TRUE(bench.simulator()->disturb(fault, 1.0));
            const auto report = test::tune(bench, test::planOf(Mode::Position));
            ASSERT_TRUE(report) << report.error().text();
            std::printf("  %d %s: %s, %s\n", node, std::string(fault).c_str(),
                std::string(toString(report->result)).c_str(), report->evidence.english().c_str());
            EXPECT_NE(report->result, TuneResult::Kept);
            EXPECT_FALSE(report->evidence.empty());
            EXPECT_TRUE(report->stopped);
            EXPECT_FALSE(bench.simulator()->isOutputOn());
            EXPECT_EQ(gainsOf(bench), before);
        }
    }
}

TEST(TwoPointTuning, TheUserEndsItAtAnyPointAndTheGainsStay)
{
    for (const double seconds : {0.5, 4.0, 10.0, 20.0}) {
        ExperimentBench bench("sim:serial", "supermodified", 5);
        const auto before = gainsOf(bench);
        Timer timer(bench.bench.clock);
        timer.startIn(
            std::chrono::milliseconds(std::lround(1000.0 * seconds)), [&bench] { bench.interruption.interrupt(); });
        const auto report = test::tune(bench, test::planOf(Mode::Position));
        ASSERT_TRUE(report) << report.error().text();
        EXPECT_EQ(report->stopReason, "interrupted") << seconds;
        EXPECT_TRUE(report->stopped);
        EXPECT_EQ(gainsOf(bench), before) << seconds;
    }
}

TEST(TwoPointTuning, WhatWasIdentifiedIsProvenLaterWithoutTryingGainsAnew)
{
    ExperimentBench bench("sim:serial", "supermodified", 4);
    TunePlan plan = test::planOf(Mode::Position);
    plan.propose = true;
    const auto before = gainsOf(bench);
    const auto identified = test::tune(bench, plan);
    ASSERT_TRUE(identified) << identified.error().text();
    EXPECT_EQ(identified->result, TuneResult::Proposed);
    EXPECT_EQ(identified->proposals.size(), 3U);
    EXPECT_EQ(gainsOf(bench), before);
    plan.propose = false;
    plan.known = identified->plant;
    EXPECT_FALSE(test::tune(bench, plan)) << "gains without a scale";
    plan.scale = identified->scale;
    const auto proven = test::tune(bench, plan);
    ASSERT_TRUE(proven) << proven.error().text();
    EXPECT_EQ(proven->result, TuneResult::Kept) << proven->evidence;
    EXPECT_EQ(proven->trials.size(), 2U);
}

TEST(TwoPointTuning, TooLittleTravelIsRefusedWithItsReason)
{
    ExperimentBench bench("sim:serial", "supermodified", 4);
    TunePlan plan = test::planOf(Mode::Position);
    plan.limits.travel = 25.0;
    const auto report = test::tune(bench, plan);
    const std::string why = report ? report->evidence.english() : report.error().text();
    std::printf("  %s\n", why.c_str());
    EXPECT_FALSE(why.empty());
    EXPECT_FALSE(report && report->result == TuneResult::Kept);
}

} // namespace
} // namespace mb::tuning
