// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiment/envelope.h"
#include "tests/tuning/experimentbench.h"
#include "tests/tuning/tuningbench.h"
#include "tuning/loopfit.h"
#include "tuning/prediction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <random>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace mb::tuning {
namespace {

using test::ExperimentBench;

constexpr double currentLimit = 5.0; ///< A, that a Supermodified stores

std::string unitOfThird(const std::string &motor, const std::string &load)
{
    return "supermodified:6,dialect=D3,motor=" + motor + ",load=" + load;
}

/// A node of the third dialect, whose gains have an unknown scale, and the largest current that it told.
struct ThirdBench : ExperimentBench {
    ThirdBench(const std::string &motor, const std::string &load)
        : ExperimentBench("sim:serial", "supermodified", 6, unitOfThird(motor, load))
        , current(*axisChannel(*device, "current", 1))
        , seen(device->telemetry()->samples().add([this](const Sample &sample) {
            if (sample.channel == current)
                most = std::max(most, std::abs(sample.value));
        }))
    {
    }
    [[nodiscard]] std::vector<std::int64_t> stored()
    {
        std::vector<std::int64_t> all;
        for (const char *const key : {"gain.p", "gain.i", "gain.d", "profile.velocity", "profile.acceleration"})
            all.push_back(test::rawOf(*this, key));
        return all;
    }
    [[nodiscard]] std::size_t tries() const
    {
        return static_cast<std::size_t>(std::count_if(notes.begin(), notes.end(),
            [](const std::string &note) { return note.starts_with("a step of -20 counts"); }));
    }

    ChannelIndex current;
    double most = 0.0;
    Subscription seen;
};

TEST(FirstMotion, PGrowsUntilAMotorMovesThatItsStoredGainsDoNotMove)
{
    for (const std::string load : {"3", "5.7", "7.5"}) {
        ThirdBench bench("25dlp", load);
        const auto report = test::tune(bench, test::planOf(Mode::Position));
        ASSERT_TRUE(report) << report.error().text();
        std::printf("  load %s: %s after %zu forces, %s\n", load.c_str(), std::string(toString(report->result)).c_str(),
            bench.tries(), report->evidence.english().c_str());
        EXPECT_EQ(report->result, TuneResult::Kept) << report->evidence;
        EXPECT_LE(report->measured.overshoot.value_or(1.0), 0.05);
        EXPECT_GT(bench.tries(), 6U) << "the stored P makes it move";
        for (const ScaledGains::Row &row : report->proposed.rows)
            EXPECT_EQ(test::rawOf(bench, row.key), row.raw) << row.key;
        EXPECT_FALSE(bench.simulator()->isOutputOn());
    }
}

TEST(FirstMotion, AStrongMotorIsLedByTheUnitsProfileAndNeverDrawsMoreThanItsLimit)
{
    for (const auto &[motor, load] :
        {std::pair("rs775", "5.7"), std::pair("rs775", "3"), std::pair("775pro", "8"), std::pair("775pro", "10.4")}) {
        ThirdBench bench(motor, load);
        const auto before = bench.stored();
        double drawn = 0.0; // between two samples, too
        Timer looking(bench.bench.clock);
        const std::function<void()> look = [&] {
            drawn = std::max(drawn, std::abs(bench.simulator()->current().value_or(0.0)));
            looking.startIn(std::chrono::milliseconds(1), look);
        };
        look();
        const auto report = test::tune(bench, test::planOf(Mode::Position));
        ASSERT_TRUE(report) << report.error().text();
        std::printf("  %s %s: %s, at most %.1f A, %.1f s, overshoot %.3f\n", motor, load,
            std::string(toString(report->result)).c_str(), drawn, report->seconds,
            report->measured.overshoot.value_or(-1.0));
        EXPECT_EQ(report->result, TuneResult::Kept) << report->evidence;
        EXPECT_LE(bench.most, currentLimit);
        EXPECT_LE(drawn, currentLimit);
        EXPECT_LE(report->measured.overshoot.value_or(1.0), 0.05);
        EXPECT_LE(report->seconds, 60.0); // docs/tuning-results.md#a13
        ASSERT_TRUE(report->scale);
        EXPECT_GT(report->scale->rate, 0.0);
        EXPECT_NE(report->evidence.english().find("profile"), std::string::npos);
        const auto after = bench.stored();
        EXPECT_EQ(after[3], before[3]) << "the profile's velocity";
        EXPECT_EQ(after[4], before[4]) << "the profile's acceleration";
        EXPECT_FALSE(bench.simulator()->isOutputOn());
    }
}

TEST(FirstMotion, AMotorWhoseFrictionTakesItsCurrentIsRefusedWithThatReason)
{
    ThirdBench bench("cim", "13");
    const auto before = bench.stored();
    const auto report = test::tune(bench, test::planOf(Mode::Position));
    ASSERT_TRUE(report) << report.error().text();
    std::printf("  %s, at most %.1f A\n", report->evidence.english().c_str(), bench.most);
    EXPECT_EQ(report->result, TuneResult::Refused);
    EXPECT_NE(report->evidence.english().find("friction"), std::string::npos) << report->evidence;
    EXPECT_LE(bench.most, currentLimit);
    EXPECT_TRUE(report->stopped);
    EXPECT_EQ(bench.stored(), before);
}

TEST(FirstMotion, ADeadSensorIsNotPushedHarderOnceTheMotorTurns)
{
    for (const std::string motor : {"775pro", "rs775"}) {
        ThirdBench bench(motor, "6");
        const auto before = bench.stored();
        ASSERT_TRUE(bench.simulator()->disturb("encoder-dead", 1.0));
        const auto report = test::tune(bench, test::planOf(Mode::Position));
        ASSERT_TRUE(report) << report.error().text();
        std::printf("  %s: %zu forces, %s\n", motor.c_str(), bench.tries(), report->evidence.english().c_str());
        EXPECT_EQ(report->stopReason, tuning::EndReason::NoMotion);
        EXPECT_LE(bench.tries(), motor == "775pro" ? 5U : 11U) << "one more than makes it turn";
        EXPECT_LE(bench.most, currentLimit);
        EXPECT_EQ(bench.stored(), before);
        EXPECT_FALSE(bench.simulator()->isOutputOn());
    }
}

TEST(FirstMotion, AStalledShaftStaysWithinItsCurrentAndTheGainsStay)
{
    for (const std::string motor : {"775pro", "25dlp"}) {
        ThirdBench bench(motor, "6");
        const auto before = bench.stored();
        ASSERT_TRUE(bench.simulator()->disturb("stall", 1.0));
        const auto report = test::tune(bench, test::planOf(Mode::Position));
        ASSERT_TRUE(report) << report.error().text();
        std::printf("  %s: at most %.1f A, %s\n", motor.c_str(), bench.most, report->evidence.english().c_str());
        EXPECT_EQ(report->stopReason, tuning::EndReason::NoMotion);
        EXPECT_LE(bench.most, currentLimit);
        EXPECT_EQ(bench.stored(), before);
        EXPECT_FALSE(bench.simulator()->isOutputOn());
    }
}

TEST(FirstMotion, GainsAndProfileAreAsTheyWereWhereverItIsInterrupted)
{
    for (const double seconds : {0.3, 1.1, 7.0, 14.0, 21.0, 34.0}) {
        ThirdBench bench("rs775", "5.7");
        const auto before = bench.stored();
        Timer timer(bench.bench.clock);
        timer.startIn(
            std::chrono::milliseconds(std::lround(1000.0 * seconds)), [&bench] { bench.interruption.interrupt(); });
        const auto report = test::tune(bench, test::planOf(Mode::Position));
        ASSERT_TRUE(report) << report.error().text();
        EXPECT_EQ(report->stopReason, tuning::EndReason::Interrupted) << seconds;
        EXPECT_TRUE(report->stopped);
        EXPECT_EQ(bench.stored(), before) << seconds;
    }
}

/// Its first P are too small to move it, and a guard ends each; that is no news where the next has moved it.
TEST(FirstMotion, AProposalDoesNotTellTheCauseOfAGuardThatWasForgiven)
{
    ThirdBench bench("25dlp", "12");
    TunePlan plan = test::planOf(Mode::Position);
    plan.propose = true;
    const auto report = test::tune(bench, plan);
    ASSERT_TRUE(report) << report.error().text();
    ASSERT_EQ(report->result, TuneResult::Proposed) << report->evidence.english();
    EXPECT_EQ(report->evidence.english(), "what these gains do is predicted, and not proven on the motor");
}

TEST(FirstMotion, ACheckThatDoesNotBeginToMoveTheMotorIsGivenUpAfterThreeTenthsOfASecond)
{
    ExperimentBench bench("sim:serial", "supermodified", 4);
    ASSERT_TRUE(bench.simulator()->disturb("stall", 1.0));
    int milliseconds = 0;
    Timer looking(bench.bench.clock);
    const std::function<void()> look = [&] {
        milliseconds += bench.simulator()->isOutputOn() ? 5 : 0;
        looking.startIn(std::chrono::milliseconds(5), look);
    };
    look();
    const auto report = test::tune(bench, test::planOf(Mode::Position));
    ASSERT_TRUE(report) << report.error().text();
    EXPECT_EQ(report->stopReason, tuning::EndReason::NoMotion);
    EXPECT_GE(milliseconds, 250);
    EXPECT_LE(milliseconds, 400);
}

TEST(LoopFit, TellsAMotorThatItsProfileHasLed)
{
    PlantModel plant{3e6, 0.25, 0.0, 0.07};
    constexpr double full = 522'240.0;
    constexpr double cycle = 1.024e-3;
    constexpr double rate = 30'000.0;
    const LoopLaw law{{1.0 / full, cycle / full, cycle, 0.0, 0.0}, false};
    std::mt19937 random(7);
    std::normal_distribution<double> late(0.0, 0.001);
    std::vector<LoopRun> runs;
    for (const auto &[p, d, step] :
        {std::tuple(50.0, 1800.0, 2000.0), std::tuple(50.0, 1800.0, -2000.0), std::tuple(125.0, 1800.0, 800.0),
            std::tuple(125.0, 1800.0, -800.0), std::tuple(125.0, 3600.0, 800.0), std::tuple(125.0, 3600.0, -800.0)}) {
        LoopShape shape;
        shape.period = cycle;
        shape.isCounted = true;
        shape.setPointRate = rate;
        SimulatedLoop loop(Mode::Position, plant, {p * law.scale.p, 0.0, d * law.scale.d, 0.0}, shape, 0.0);
        LoopRun run{p, d, step, {}, rate, 0.0};
        double t = 0.0;
        for (double at = 0.01; at < 0.6; at += 0.01) {
            for (; t < at; t += cycle)
                (void)loop.pass(step);
            run.way.add(at + 0.006 + late(random), std::floor(loop.value()));
        }
        runs.push_back(run);
    }
    const auto linear = fitTwoPoint(runs);
    ASSERT_TRUE(linear) << linear.error().text();
    const auto fit = fitLoop(runs, law, *linear);
    ASSERT_TRUE(fit) << fit.error().text();
    const double push = fit->plant.gain / fit->plant.tau * plant.tau / plant.gain;
    std::printf("  push %.3f, D %.3f, friction %.3f of the true ones, left %.4f\n", push, fit->d / law.scale.d,
        fit->plant.friction / plant.friction, fit->residual);
    EXPECT_NEAR(push, 1.0, 0.1);
    EXPECT_NEAR(fit->d / law.scale.d, 1.0, 0.1);
    EXPECT_NEAR(fit->plant.friction / plant.friction, 1.0, 0.15);
}

TEST(TwoPointFit, ARampOfManySmallStepsIsTheStepWhereItTakesNoTime)
{
    EXPECT_EQ(rampOfSecondOrder(30.0, 400.0, 0.05, 0.1, 0.0), stepOfSecondOrder(30.0, 400.0, 0.1));
    // y'' + 40·y' + 400·y = 400·r of a ramp r = t: y = t − 0.1 + (0.1 + t)·e^(−20·t)
    const double t = 0.15;
    EXPECT_NEAR(rampOfSecondOrder(40.0, 400.0, 0.0, t, 0.3), (t - 0.1 + (0.1 + t) * std::exp(-20.0 * t)) / 0.3, 2e-3);
    // with a lead of 0.1 s it is 400·r + 40·r': y = t − t·e^(−20·t)
    EXPECT_NEAR(rampOfSecondOrder(40.0, 400.0, 0.1, t, 0.3), t * (1.0 - std::exp(-20.0 * t)) / 0.3, 2e-3);
}

TEST(PredictStep, ASetPointThatIsLedDrawsLessThanAStep)
{
    PlantModel plant{3e6, 0.25, 0.002, 0.07};
    plant.stallCurrent = 18.0;
    plant.backDuty = 1.0 / plant.gain;
    const ContinuousGains gains{50.0 / 522'240.0, 0.0, 1800.0 * 1.024e-3 / 522'240.0, 0.0};
    LoopShape shape;
    shape.period = 1.024e-3;
    const Prediction step = predictStep(Mode::Position, plant, gains, 0.0, 2000.0, 0.6, shape);
    shape.setPointRate = 30'000.0;
    const Prediction led = predictStep(Mode::Position, plant, gains, 0.0, 2000.0, 0.6, shape);
    std::printf("  %.1f A of a step, %.1f A led\n", *step.metrics.peakCurrent, *led.metrics.peakCurrent);
    EXPECT_GT(*step.metrics.peakCurrent, 17.0);
    EXPECT_LT(*led.metrics.peakCurrent, 5.0);
    EXPECT_NEAR(led.measured.y.back(), step.measured.y.back(), 0.25 * 2000.0);
}

} // namespace
} // namespace mb::tuning
