// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/motormodel.h"
#include "tests/tuning/tuningbench.h"
#include "tuning/gainsearch.h"
#include "tuning/margins.h"
#include "tuning/proposals.h"
#include "tuning/rollout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>

namespace mb::tuning {
namespace {

using test::ExperimentBench;
using test::planOf;
using test::tune;

const PlantModel geared{8620.0, 0.1066, 0.0134, 0.0759, 2.2};

SearchTask taskOf(Mode loop)
{
    SearchTask task;
    task.bounds.period = 2e-3;
    task.bounds.integralWeight = loop == Mode::Position ? 0.1 : 0.0;
    task.step = loop == Mode::Position ? 600.0 : 1900.0;
    task.overshoot = 0.025;
    task.shape.period = 2e-3;
    task.shape.isCounted = true;
    task.shape.integralMost = loop == Mode::Position ? 0.21 : 0.0;
    return task;
}

double itaeOf(Mode loop, const ContinuousGains &gains, const SearchTask &task)
{
    SimulatedLoop simulated(loop, geared, gains, task.shape, 0.0);
    double itae = 0.0;
    for (double t = task.shape.period; t < 1.5; t += task.shape.period) {
        (void)simulated.pass(task.step);
        itae += t * std::abs(1.0 - simulated.value() / task.step) * task.shape.period;
    }
    return itae;
}

TEST(GainSearch, IsQuickerThanTheRuleAndWithinTheSameBounds)
{
    for (const Mode loop : {Mode::Velocity, Mode::Position}) {
        const SearchTask task = taskOf(loop);
        const Design rule = design(loop, geared, responseOf(loop, Aim::Normal, geared), task.bounds);
        const Design found = searched(loop, geared, rule, task);
        const double before = itaeOf(loop, rule.gains, task);
        const double after = itaeOf(loop, found.gains, task);
        std::printf("%s: integral %.5f by the rule, %.5f by the search, Ms %.2f\n", std::string(toString(loop)).c_str(),
            before, after, marginsOf(loop, geared, found.gains).ms);
        EXPECT_LT(after, 0.8 * before);
        EXPECT_TRUE(isWithin(found.gains, task.bounds));
        EXPECT_TRUE(hasMargin(loop, geared, found.gains, task.mostMs, task.mostMsOff));
    }
}

/// Strong motors of a Supermodified D3: friction holds them far from their target.
TEST(GainSearch, AStepThatAProfileLeadsIsSearchedForAsItIsLedAndKeepsItsOvershootWhereNothingLeads)
{
    struct Row {
        PlantModel motor;
        double step;
        double rate;
        double less; ///< of the error that gains for steps leave
    };
    for (const auto &[motor, step, rate, less] :
        {Row{{5e5, 0.19, 0.00204, 0.1}, 400.0, 9'100.0, 0.2}, Row{{5e6, 1.0, 0.00204, 0.26}, 5000.0, 31'000.0, 0.9}}) {
        SearchTask task;
        task.bounds.period = task.shape.period = 1.024e-3;
        task.step = task.bounds.largestError = step;
        task.overshoot = 0.03;
        task.shape.isCounted = true;
        const Design rule = design(Mode::Position, motor, responseOf(Mode::Position, Aim::Normal, motor), task.bounds);
        const ContinuousGains ofSteps = searched(Mode::Position, motor, rule, task).gains;
        task.shape.setPointRate = rate;
        const ContinuousGains found = searched(Mode::Position, motor, rule, task).gains;
        const double its = errorOfSteps(Mode::Position, motor, found, task);
        const double theirs = errorOfSteps(Mode::Position, motor, ofSteps, task);
        task.shape.setPointRate = 0.0;
        SimulatedLoop loop(Mode::Position, motor, found, task.shape, 0.0);
        double most = 0.0;
        for (double t = 0.0; t < 1.0; t += task.shape.period) {
            (void)loop.pass(step);
            most = std::max(most, loop.value() / step - 1.0);
        }
        std::printf("led: %.4f, of gains for steps %.4f; overshoot of a step %.3f\n", its, theirs, most);
        EXPECT_LT(its, less * theirs);
        EXPECT_LE(most, 0.035);
    }
}

/// Four of its lags pass until the integral of the rule has overcome friction.
TEST(GainSearch, GainsThatDoNotMoveTheMotorAreNotTakenForGainsThatDoNotOvershoot)
{
    const PlantModel stiff{7370.0, 0.186, 0.243, 0.133};
    SearchTask task;
    task.step = 259.0;
    task.overshoot = 0.005;
    task.isHeldToRule = true;
    task.shape.period = 2e-3;
    task.shape.mostDuty = 0.25;
    task.shape.isCounted = true;
    task.shape.window = 0.48;
    task.shape.windowCounts = 124.0;
    const Design rule
        = design(Mode::Velocity, stiff, responseOf(Mode::Velocity, Aim::Calm, stiff), task.bounds, 1.6, 1.88);
    const Design found = searched(Mode::Velocity, stiff, rule, task);
    SimulatedLoop simulated(Mode::Velocity, stiff, found.gains, task.shape, 0.0);
    for (double t = 0.0; t < 4.0; t += task.shape.period)
        (void)simulated.pass(task.step);
    EXPECT_GT(simulated.value(), 0.5 * task.step);
}

TEST(GainSearch, MarginsHoldForAMotorThatPushesSaidIsQuicker)
{
    SearchTask task = taskOf(Mode::Velocity);
    const Design rule = design(Mode::Velocity, geared, responseOf(Mode::Velocity, Aim::Normal, geared), task.bounds);
    PlantModel quicker = geared;
    quicker.tau /= 1.05;
    const auto holds = [&](const SearchTask &its) {
        return hasMargin(
            Mode::Velocity, quicker, searched(Mode::Velocity, geared, rule, its).gains, task.mostMs, task.mostMsOff);
    };
    EXPECT_FALSE(holds(task));
    task.steepest = quicker.gain / quicker.tau;
    EXPECT_TRUE(holds(task));
}

TEST(GainSearch, ACalmLoopIsHeldToItsRule)
{
    SearchTask task = taskOf(Mode::Velocity);
    task.isHeldToRule = true;
    const Design rule = design(Mode::Velocity, geared, responseOf(Mode::Velocity, Aim::Calm, geared), task.bounds);
    EXPECT_LE(searched(Mode::Velocity, geared, rule, task).gains.p, 1.002 * rule.gains.p);
    task.isHeldToRule = false;
    EXPECT_GT(searched(Mode::Velocity, geared, rule, task).gains.p, 1.2 * rule.gains.p);
}

TEST(GainSearch, ThreeAimsAreDesignedForEachLoopAndTheirTimeIsTold)
{
    const std::array<std::pair<const char *, int>, 2> drives{{{"dmc60c", 5}, {"abstractdc", 3}}};
    for (const auto &[family, address] : drives) {
        ExperimentBench bench("sim:can", family, address);
        for (const Mode loop : {Mode::Velocity, Mode::Position}) {
            Envelope envelope;
            envelope.duty = 1.0;
            envelope.speed = 1'500'000.0;
            envelope.travel = 2e7;
            const PlantModel plant{367'000.0, 0.2, loop == Mode::Velocity ? 0.052 : 0.004, 0.018, 1.34};
            const VelocityTaking taking{loop == Mode::Velocity ? 0.1 : 0.0, 0.05, 0.0};
            const ProposalBasis basis{
                bench.device->family(), bench.device->knowledge().profile(), loop, 1, 0, plant, envelope, {}, taking};
            const std::clock_t begin = std::clock();
            for (const Aim aim : {Aim::Calm, Aim::Normal, Aim::Brisk})
                EXPECT_TRUE(proposalFor(basis, {aim, {}, {}}));
            const double took = 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
            std::printf("%s %s: %.0f ms of processor time\n", family, std::string(toString(loop)).c_str(), took);
        }
    }
}

/// Passes of 20.04 ms are 20 by a clock of whole milliseconds, and each 25th is 21: it reads a speed that does not change 4.6 % low.
TEST(SimulatedLoop, AClockOfWholeMillisecondsReadsEachTwentyFifthPassLow)
{
    LoopShape shape;
    shape.period = shape.window = 20.04e-3;
    shape.clock = 1e-3;
    const PlantModel plant{8620.0, 0.1066, 0.04, 0.0759, 1.0};
    const auto lowOf = [&](double phase) {
        shape.phase = phase;
        SimulatedLoop simulated(Mode::Velocity, plant, {0.0, 1e-9, 0.0, 0.0}, shape, 1000.0);
        std::vector<int> low;
        for (int pass = 0; pass < 100; ++pass) {
            (void)simulated.pass(1000.0);
            if (std::abs(simulated.measured() - 954.0) < 2.0)
                low.push_back(pass);
            else
                EXPECT_NEAR(simulated.measured(), 1001.5, 1.0);
        }
        return low;
    };
    const std::vector<int> first = lowOf(0.0);
    const std::vector<int> other = lowOf(0.5);
    ASSERT_EQ(first.size(), 4U);
    EXPECT_NEAR(first[2] - first[0], 50, 1); // a sum of 20.04 ms is not quite whole where it should be
    ASSERT_FALSE(other.empty());
    EXPECT_NE(first[0], other[0]);
}

TEST(SimulatedLoop, AMotorFollowsItsOutputAsLateAsItsWindingLetsTheCurrent)
{
    constexpr double winding = 1.4e-3;
    const PlantModel plant{400'000.0, 0.25, 0.0015 + winding, 0.05};
    LoopShape shape;
    shape.period = 1e-3;
    std::array<double, 2> places{};
    std::array<double, 2> speeds{};
    for (const std::size_t has : {0U, 1U}) {
        shape.winding = has == 1 ? winding : 0.0;
        PlantModel own = plant;
        own.delay -= has == 1 ? 0.0 : winding; // which would be whole passes
        SimulatedLoop simulated(Mode::Position, own, {1.0, 0.0, 0.0, 0.0}, shape, 0.0);
        double before = 0.0;
        for (int pass = 0; pass < 40; ++pass) {
            before = simulated.value();
            (void)simulated.pass(1e6);
        }
        places.at(has) = simulated.value();
        speeds.at(has) = (simulated.value() - before) / shape.period;
    }
    EXPECT_NEAR((places[0] - places[1]) / speeds[0], winding, 0.05 * winding);
    EXPECT_GT(speeds[0], speeds[1]) << "it is behind to the end";
}

TEST(Prediction, ALagWithoutEndEnds)
{
    const PlantModel endless{1000.0, 1e9, 0.01, 0.0};
    const Prediction seen
        = predictStep(Mode::Velocity, endless, velocityRule(endless, 0.1), 0.0, 100.0, 1e10, 1.0, 0.01);
    EXPECT_LE(seen.measured.t.back(), longestPrediction);
    EXPECT_GE(seen.measured.t.back(), 0.9 * longestPrediction);
    EXPECT_LE(seen.measured.size(), 7000U);
}

TEST(RollOut, TellsAGearThatLosesTorqueFromOneThatDoesNot)
{
    for (const double braking : {1.0, 1.35, 2.5}) {
        const double tau = 0.2;
        const double friction = 600.0;
        std::vector<RollOut> rolls;
        for (const double speed : {2000.0, 3200.0}) {
            RollOut roll{speed, 0.0};
            for (double v = speed; v > 0.0; v -= (braking * v + friction) / tau * 1e-5)
                roll.distance += v * 1e-5;
            rolls.push_back(roll);
        }
        EXPECT_NEAR(brakingOf(rolls, tau, friction).value_or(0.0), braking, 0.01 * braking);
    }
    EXPECT_FALSE(brakingOf({{2000.0, 4000.0}, {2000.0, 4100.0}}, 0.2, 0.0)); // it coasted
    EXPECT_FALSE(brakingOf({}, 0.2, 0.0));
}

TEST(RollOut, IsFoundOnEachDrive)
{
    struct Place {
        const char *link;
        const char *family;
        int address;
        const char *unit;
    };
    for (const Place &place : {Place{"sim:can", "dmc60c", 5, "dmc60c:5,motor=25d,load=5"},
             Place{"sim:can", "abstractdc", 3, "abstractdc:3,dialect=F,motor=25d,load=5,gains=overshoot"}}) {
        ExperimentBench bench(place.link, place.family, place.address, place.unit);
        TunePlan plan = planOf(Mode::Velocity);
        plan.propose = true;
        plan.keep = true;
        const auto report = tune(bench, plan);
        ASSERT_TRUE(report) << report.error().text();
        const MotorParameters &motor = *motorByName("25d");
        const double truth = (1.0 + motor.torqueLoss) / (1.0 - motor.torqueLoss);
        std::printf("%s: brakes %.2f times as strongly as it drives, of the motor's figures %.2f\n", place.family,
            report->plant.braking, truth);
        EXPECT_NEAR(report->plant.braking, truth, 0.25 * truth);
    }
}

TEST(Autotune, AKnownModelIsProvenAsItsLoopTakesItsVelocity)
{
    ExperimentBench bench("sim:can", "dmc60c", 7);
    TunePlan plan = planOf(Mode::Velocity);
    plan.propose = true;
    const auto found = tune(bench, plan);
    ASSERT_TRUE(found) << found.error().text();
    ASSERT_GT(found->taking.window, 0.09);
    plan.propose = false;
    plan.known = found->plant;
    plan.taking = found->taking;
    const auto proven = tune(bench, plan);
    ASSERT_TRUE(proven) << proven.error().text();
    EXPECT_EQ(proven->result, TuneResult::Kept) << proven->evidence;
    EXPECT_EQ(proven->taking, found->taking);
    EXPECT_EQ(proven->proposed.made, found->proposed.made);
}

TEST(Autotune, ThePeakCurrentIsPredictedAndMeasured)
{
    ExperimentBench bench("sim:can", "dmc60c", 5);
    const auto report = tune(bench, planOf(Mode::Velocity));
    ASSERT_TRUE(report) << report.error().text();
    ASSERT_TRUE(report->predicted && report->predicted->metrics.peakCurrent);
    ASSERT_TRUE(report->measured.peakCurrent);
    std::printf("peak current: %.1f A predicted, %.1f A measured; %.1f A at standstill\n",
        *report->predicted->metrics.peakCurrent, *report->measured.peakCurrent, report->plant.stallCurrent);
    EXPECT_NEAR(
        *report->predicted->metrics.peakCurrent, *report->measured.peakCurrent, 0.15 * *report->measured.peakCurrent);
    EXPECT_LE(*report->predicted->metrics.peakCurrent, *report->proof.front().envelope.current);
}

} // namespace
} // namespace mb::tuning
