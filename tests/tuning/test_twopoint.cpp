// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/tuning/experimentbench.h"
#include "tests/tuning/tuningbench.h"
#include "tuning/autotune.h"
#include "tuning/loopfit.h"
#include "tuning/prediction.h"
#include "tuning/refinement.h"
#include "tuning/simulatedloop.h"
#include "tuning/twopointfit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <span>
#include <tuple>

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

/// How telemetry brings it.
struct Record {
    double period = 0.015;
    double jitter = 0.001;
};

/// A record of a loop with friction.
LoopRun runOf(const PlantModel &plant, const TriedScale &scale, double p, double d, double step, unsigned seed,
    double winding = 0.0, const Record &record = {})
{
    std::mt19937 random(seed);
    std::normal_distribution<double> late(0.0, record.jitter);
    LoopShape shape;
    shape.period = scale.cycle;
    shape.isCounted = true;
    shape.winding = winding;
    SimulatedLoop loop(Mode::Position, plant, {p * scale.p, 0.0, d * scale.d, 0.0}, shape, 0.0);
    LoopRun run{p, d, step, {}};
    double t = 0.0;
    for (double at = record.period; at < 0.9; at += record.period) {
        for (; t < at; t += scale.cycle)
            (void)loop.pass(step);
        run.way.add(at + 0.006 + late(random), std::floor(loop.value()));
    }
    return run;
}

/// Of a step, how far two motors are apart at most in a loop that was not tried.
double farthestApart(const PlantModel &one, const PlantModel &other, const TriedScale &scale)
{
    LoopShape shape;
    shape.period = scale.cycle;
    const ContinuousGains gains{489.0 * scale.p, 0.0, 11566.0 * scale.d, 0.0};
    constexpr double step = 600.0;
    const Trace a = predictStep(Mode::Position, one, gains, 0.0, step, 0.4, shape).measured;
    const Trace b = predictStep(Mode::Position, other, gains, 0.0, step, 0.4, shape).measured;
    double most = 0.0;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        most = std::max(most, std::abs(a.y[i] - b.y[i]) / step);
    return most;
}

TEST(LoopFit, TellsFrictionFromDragOutOfTheStepsOfItsOwnLoop)
{
    PlantModel plant{15'600.0, 0.1, 0.0, 0.08};
    plant.braking = 1.5;
    constexpr double full = 256.0 * 255.0;
    constexpr double cycle = 1.024e-3;
    const LoopLaw law{{1.0 / full, cycle / full, cycle, 0.0, 0.0}, true};
    std::vector<LoopRun> runs;
    unsigned number = 0;
    for (const double sign : {1.0, -1.0}) {
        runs.push_back(runOf(plant, law.scale, 218.0, 7470.0, 150.0 * sign, ++number));
        runs.push_back(runOf(plant, law.scale, 545.0, 7470.0, 60.0 * sign, ++number));
        runs.push_back(runOf(plant, law.scale, 545.0, 14940.0, 60.0 * sign, ++number));
    }
    const auto linear = fitTwoPoint(runs);
    ASSERT_TRUE(linear) << linear.error().text();
    const auto fit = fitLoop(runs, law, *linear);
    ASSERT_TRUE(fit) << fit.error().text();
    const double push = fit->plant.gain / fit->plant.tau * plant.tau / plant.gain;
    std::printf(
        "  push %.3f of the true one (%.3f without friction), tau %.1f ms, friction %.4f, braking %.2f, left %.4f\n",
        push, linear->p * full * plant.tau / plant.gain, 1e3 * fit->plant.tau, fit->plant.friction, fit->plant.braking,
        fit->residual);
    EXPECT_NEAR(push, 1.0, 0.1);
    PlantModel spread = plant; // what the linear fit takes it for
    spread.tau = 1.0 / linear->drag;
    spread.gain = linear->p * full * spread.tau;
    const double off = farthestApart(plant, fit->plant, law.scale);
    std::printf("  another loop, of larger steps, is foretold within %.3f of them (%.3f without friction)\n", off,
        farthestApart(plant, spread, law.scale));
    EXPECT_LE(off, 0.05);
    EXPECT_LE(off, 0.5 * farthestApart(plant, spread, law.scale));
    EXPECT_NEAR(fit->shift, 0.006, 0.002);
    EXPECT_LT(fit->residual, linear->residual);
    EXPECT_FALSE(fitLoop(std::span(runs).first(2), law, *linear)) << "too few";
}

constexpr double fullOfSupermodified = 256.0 * 255.0;
constexpr double cycleOfSupermodified = 1.024e-3;
const LoopLaw lawOfSupermodified{
    {1.0 / fullOfSupermodified, cycleOfSupermodified / fullOfSupermodified, cycleOfSupermodified, 0.0, 0.0}, true};

/// As a tuning tries them.
std::vector<LoopRun> runsOfTuning(const PlantModel &plant, double d, double winding)
{
    std::vector<LoopRun> runs;
    unsigned number = 0;
    for (const double sign : {1.0, -1.0}) {
        for (const auto &[p, more, step] :
            {std::tuple(218.0, 1.0, 150.0), std::tuple(545.0, 1.0, 60.0), std::tuple(545.0, 2.0, 60.0)})
            runs.push_back(
                runOf(plant, lawOfSupermodified.scale, p, more * d, step * sign, ++number, winding, {0.01, 0.0002}));
    }
    return runs;
}

double pushOf(const PlantModel &plant)
{
    return plant.gain / plant.tau;
}

TEST(LoopFit, TellsTheWindingOfAMotorFromItsInertia)
{
    PlantModel plant{425'700.0, 0.245, 0.0, 0.076};
    plant.braking = 1.1;
    for (const double winding : {0.8e-3, 1.35e-3}) {
        const auto runs = runsOfTuning(plant, 2988.0, winding);
        const auto linear = fitTwoPoint(runs);
        ASSERT_TRUE(linear) << linear.error().text();
        const auto fit = fitLoop(runs, lawOfSupermodified, *linear);
        ASSERT_TRUE(fit) << fit.error().text();
        std::printf("  winding %.2f ms, found %.2f ms; push %.3f of the true one, left %.4f\n", 1e3 * winding,
            1e3 * fit->winding, pushOf(fit->plant) / pushOf(plant), fit->residual);
        EXPECT_NEAR(fit->winding, winding, 0.3e-3);
        EXPECT_NEAR(pushOf(fit->plant) / pushOf(plant), 1.0, 0.08);
    }
}

TEST(LoopFit, AnOrderThatWaitedBehindALostAnswerIsNoSlowerMotor)
{
    PlantModel plant{5'400.0, 0.25, 0.0, 0.12};
    plant.braking = 2.0;
    std::vector<LoopRun> runs = runsOfTuning(plant, 7470.0, 0.5e-3);
    for (const std::size_t waited : {1U, 5U}) {
        Trace late;
        for (std::size_t i = 3; i < runs[waited].way.size(); ++i)
            late.add(runs[waited].way.t[i] + 0.025, runs[waited].way.y[i]);
        runs[waited].way = late;
        EXPECT_TRUE(runs[waited].hasWaited());
    }
    EXPECT_FALSE(runs[0].hasWaited());
    const auto linear = fitTwoPoint(runs);
    ASSERT_TRUE(linear) << linear.error().text();
    const auto fit = fitLoop(runs, lawOfSupermodified, *linear);
    ASSERT_TRUE(fit) << fit.error().text();
    std::printf("  push %.3f of the true one, friction %.3f, braking %.2f, left %.4f\n",
        pushOf(fit->plant) / pushOf(plant), fit->plant.friction, fit->plant.braking, fit->residual);
    EXPECT_NEAR(pushOf(fit->plant) / pushOf(plant), 1.0, 0.05);
    EXPECT_LE(farthestApart(plant, fit->plant, lawOfSupermodified.scale), 0.06);
    EXPECT_LE(fit->residual, 0.006);
}

TEST(LoopFit, APartOfACountAtWhichItStoodIsNoFriction)
{
    PlantModel plant{33'000.0, 0.28, 0.0, 0.17};
    plant.braking = 2.0;
    std::vector<LoopRun> runs = runsOfTuning(plant, 7470.0, 0.3e-3);
    for (LoopRun &run : runs) { // whole counts of it: it stood at the end of one, whichever way it goes
        for (double &y : run.way.y)
            y += run.step > 0.0 ? 0.0 : 1.0;
    }
    const auto linear = fitTwoPoint(runs);
    ASSERT_TRUE(linear) << linear.error().text();
    const auto fit = fitLoop(runs, lawOfSupermodified, *linear);
    ASSERT_TRUE(fit) << fit.error().text();
    std::printf("  push %.3f of the true one, friction %.3f, left %.4f\n", pushOf(fit->plant) / pushOf(plant),
        fit->plant.friction, fit->residual);
    EXPECT_NEAR(pushOf(fit->plant) / pushOf(plant), 1.0, 0.05);
    EXPECT_LE(fit->residual, 0.004);
}

/// A step and its way back, as the proof of a tuning records them.
Trial provenStep(const PlantModel &plant, const SteppedLoop &loop, double step)
{
    constexpr double hold = 0.6;
    Trial trial;
    trial.mode = Mode::Position;
    trial.stimulus.to = step;
    trial.holds = {{0.0, hold}};
    trial.returns = {{hold, 2.0 * hold}};
    SimulatedLoop simulated(Mode::Position, plant, loop.gains, loop.shape, 0.0);
    Signal position{"position", "counts", {}};
    double t = -0.05;
    for (double at = t; at < 2.0 * hold; at += 0.01) {
        for (; t < at; t += loop.shape.period)
            (void)simulated.pass(t >= 0.0 && t < hold ? step : 0.0);
        position.trace.add(at + 0.006, std::floor(simulated.value()));
    }
    trial.signals.push_back(position);
    return trial;
}

TEST(Refinement, AStepThatIsLessBrakedThanThoughtCorrectsTheBraking)
{
    PlantModel plant{425'700.0, 0.32, 1.5 * cycleOfSupermodified + 1.35e-3, 0.1};
    plant.braking = 1.1;
    SteppedLoop loop;
    loop.gains = {0.0048, 0.0, 6.5e-5, 0.0};
    loop.shape.period = cycleOfSupermodified;
    loop.shape.winding = 1.35e-3;
    loop.mostLater = 0.025;
    loop.isTried = true;
    loop.trials = {provenStep(plant, loop, 400.0)};
    PlantModel thought = plant;
    thought.braking = 1.8;
    const auto corrected = refinedBy(loop, thought);
    ASSERT_TRUE(corrected);
    EXPECT_LT(corrected->braking, 1.5);
    EXPECT_GE(corrected->braking, 1.0);
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
        EXPECT_LE(report->seconds, 60.0); // docs/tuning-results.md#a13
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
    EXPECT_EQ(kept, 27);
}

TEST(TwoPointTuning, TheUserEndsItAtAnyPointAndTheGainsStay)
{
    for (const double seconds : {0.05, 0.5, 4.0, 10.0, 20.0}) { // at first before anything moves
        ExperimentBench bench("sim:serial", "supermodified", 5);
        const auto before = gainsOf(bench);
        Timer timer(bench.bench.clock);
        timer.startIn(
            std::chrono::milliseconds(std::lround(1000.0 * seconds)), [&bench] { bench.interruption.interrupt(); });
        const auto report = test::tune(bench, test::planOf(Mode::Position));
        ASSERT_TRUE(report) << report.error().text();
        EXPECT_EQ(report->stopReason, tuning::EndReason::Interrupted) << seconds;
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
    EXPECT_LE(proven->trials.size(), 4U) << "one each way, and again what these have bettered";
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
