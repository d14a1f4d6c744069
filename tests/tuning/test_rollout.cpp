// SPDX-License-Identifier: GPL-3.0-or-later
// Pushes that end with the windings shorted, of motors whose way is known exactly.
#include "tuning/rollout.h"
#include "tuning/simulatedloop.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mb::tuning {
namespace {

const PlantModel rollingPlant{20'000.0, 0.2, 0.0, 0.05, 1.5};
constexpr double rollDelay = 0.004;

struct RollPush {
    double duty = 0.4;
    double seconds = 0.6;
    double rest = 1.0; ///< s until the next
    int count = 2;
};

/// One after the other, samples each 2 ms, `rollDelay` late.
Trial rollingTrial(const RollPush &push, const PlantModel &plant = rollingPlant)
{
    Trial trial;
    trial.mode = Mode::Duty;
    trial.stimulus.to = push.duty;
    Signal position{"ch1.position", "counts", {}};
    LoopShape shape;
    shape.period = 0.002;
    SimulatedLoop motor(Mode::Position, plant, {0.0, 0.0, 0.0, 1.0}, shape, 0.0);
    const double one = push.seconds + push.rest;
    for (int i = 0; i < push.count; ++i)
        trial.holds.push_back({i * one, i * one + push.seconds});
    const auto passes = static_cast<int>(std::lround(push.count * one / shape.period));
    for (int pass = 0; pass < passes; ++pass) {
        const double t = pass * shape.period;
        position.trace.add(t + rollDelay, motor.value());
        (void)motor.pass(std::fmod(t + 1e-9, one) < push.seconds ? push.duty : 0.0);
    }
    trial.signals = {position};
    return trial;
}

PushFit rollingFit()
{
    PushFit fit;
    fit.tau = rollingPlant.tau;
    fit.delay = rollDelay;
    return fit;
}

TEST(RollOut, TellsTheSpeedAtTheEndOfAPushAndTheWayFromThere)
{
    for (const double duty : {0.4, -0.4}) {
        const auto rolls = rollOutsOf(rollingTrial({duty}), rollingFit(), 0.05);
        ASSERT_EQ(rolls.size(), 2U);
        const double speed = 20'000.0 * 0.35 * (1.0 - std::exp(-0.6 / 0.2));
        // braked: tau/b and friction/b
        const double lag = 0.2 / 1.5;
        const double drag = 20'000.0 * 0.05 / 1.5;
        const double distance = lag * (speed - drag * std::log1p(speed / drag));
        for (const RollOut &roll : rolls) {
            EXPECT_NEAR(roll.speed, speed, 0.005 * speed);
            EXPECT_NEAR(roll.distance, distance, 0.01 * distance);
        }
        EXPECT_NEAR(brakingOf(rolls, 0.2, 1000.0).value_or(0.0), 1.5, 0.02);
    }
}

TEST(RollOut, CountsOnlyWhatWasSeenToComeToRest)
{
    EXPECT_EQ(rollOutsOf(rollingTrial({0.4, 0.6, 0.08}), rollingFit(), 0.05).size(), 0U) << "the next came too soon";
    EXPECT_EQ(rollOutsOf(rollingTrial({0.4, 0.6, 0.6}), rollingFit(), 0.05).size(), 2U);
    // the last one's record ends while it rolls
    Trial cut = rollingTrial({0.4, 0.6, 0.6});
    Trace &way = cut.signals.front().trace;
    way = way.part(0.0, 1.2 + 0.6 + 0.1);
    EXPECT_EQ(rollOutsOf(cut, rollingFit(), 0.05).size(), 1U);
}

TEST(RollOut, SaysNothingOfAMotorThatHardlyRolls)
{
    const double usual = rollOutsOf(rollingTrial({}), rollingFit(), 0.05).at(0).distance; // goes with the gain
    PlantModel sluggish = rollingPlant;
    sluggish.gain *= 9.5 / usual;
    EXPECT_TRUE(rollOutsOf(rollingTrial({}, sluggish), rollingFit(), 0.05).empty());
    sluggish.gain *= 10.5 / 9.5;
    EXPECT_EQ(rollOutsOf(rollingTrial({}, sluggish), rollingFit(), 0.05).size(), 2U);
    EXPECT_TRUE(rollOutsOf({}, rollingFit(), 0.05).empty());
    EXPECT_TRUE(rollOutsOf(rollingTrial({0.0}), rollingFit(), 0.05).empty());
}

TEST(RollOut, IsTheMedianOfThoseThatBrake)
{
    const auto rollAt = [](double braking) { return RollOut{3000.0, 0.2 / braking * 3000.0}; };
    EXPECT_NEAR(brakingOf({rollAt(1.2), rollAt(1.5), rollAt(3.0)}, 0.2, 0.0).value_or(0.0), 1.5, 1e-6);
    EXPECT_EQ(brakingOf({rollAt(0.9)}, 0.2, 0.0), 1.0) << "no motor brakes less than it drives";
    EXPECT_NEAR(brakingOf({rollAt(5.0)}, 0.2, 0.0).value_or(0.0), 4.0, 1e-6);
    // open windings: most of them longer than 1/0.8 of a motor that loses nothing
    EXPECT_FALSE(brakingOf({rollAt(0.79), rollAt(0.7), rollAt(1.5)}, 0.2, 0.0));
    EXPECT_FALSE(brakingOf({rollAt(0.79), rollAt(1.5)}, 0.2, 0.0));
    EXPECT_TRUE(brakingOf({rollAt(0.79), rollAt(1.5), rollAt(1.5)}, 0.2, 0.0));
}

} // namespace
} // namespace mb::tuning
