// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/gainrules.h"
#include "tuning/margins.h"
#include "tuning/prediction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

namespace mb::tuning {
namespace {

constexpr PlantModel testedPlant{362'000.0, 0.168, 0.051, 0.02};

TEST(GainRules, SimcHasItsPublishedMargins)
{
    struct Row {
        double factor, ms, gain, phase;
    };
    for (const Row &row : {Row{1.0, 1.59, 3.14, 61.0}, Row{1.5, 1.44, 3.9, 67.0}, Row{2.0, 1.35, 4.7, 71.0}}) {
        const Margins margins
            = marginsOf(Mode::Velocity, testedPlant, velocityRule(testedPlant, row.factor * testedPlant.delay));
        EXPECT_NEAR(margins.ms, row.ms, 0.01) << row.factor;
        EXPECT_NEAR(margins.gain, row.gain, 0.05) << row.factor;
        EXPECT_NEAR(margins.phase, row.phase, 1.0) << row.factor;
    }
}

TEST(GainRules, AnUnstableLoopHasNoMargin)
{
    const Margins margins = marginsOf(Mode::Velocity, testedPlant, {40.0 / testedPlant.gain, 0.0, 0.0, 0.0});
    EXPECT_FALSE(margins.isStable());
    EXPECT_TRUE(std::isinf(margins.ms));
}

TEST(GainRules, SimcIntegratesWithTheMotorsTimeOrFourLags)
{
    const ContinuousGains slow = velocityRule(testedPlant, testedPlant.delay);
    EXPECT_NEAR(slow.p, 0.168 / (362'000.0 * 0.102), 1e-12);
    EXPECT_NEAR(slow.p / slow.i, 0.168, 1e-9);
    const PlantModel heavy{362'000.0, 2.0, 0.051, 0.0};
    EXPECT_NEAR(velocityRule(heavy, 0.051).p / velocityRule(heavy, 0.051).i, 4.0 * 0.102, 1e-9);
}

TEST(GainRules, PositionPolesLieWhereTheyWereAsked)
{
    const PlantModel still{362'000.0, 0.168, 0.0, 0.0};
    const ContinuousGains gains = positionRule(still, 30.0);
    EXPECT_NEAR(still.gain * gains.p / still.tau, 900.0, 1e-6);
    EXPECT_NEAR((1.0 + still.gain * gains.d) / still.tau, 60.0, 1e-6);
    const ContinuousGains lazy = positionRule(still, 1.0); // more damped by itself
    EXPECT_EQ(lazy.d, 0.0);
}

TEST(Acceptance, A09_EveryAimKeepsItsMarginsAlsoWhenTheModelIsOff)
{
    struct Row {
        Aim aim;
        double ms, off;
    };
    for (const Row &row : {Row{Aim::Calm, 1.6, 1.9}, Row{Aim::Normal, 1.6, 1.9}, Row{Aim::Brisk, 1.7, 2.3}}) {
        double worst = 0.0;
        double worstOff = 0.0;
        for (const Mode loop : {Mode::Velocity, Mode::Position, Mode::Current}) {
            for (const double tau : {0.019, 0.093, 0.245}) {
                PlantModel plant{362'000.0, tau, loop == Mode::Velocity ? 0.051 : 0.004, 0.02};
                if (loop == Mode::Current)
                    plant = {133.0, 0.00067, 0.00075, 0.0};
                const Design made = design(loop, plant, responseOf(loop, row.aim, plant), {}, row.ms, row.off);
                PlantModel off = plant;
                off.gain *= 1.2;
                off.delay *= 1.3;
                EXPECT_LE(marginsOf(loop, plant, made.gains).ms, row.ms) << toString(row.aim) << tau;
                EXPECT_LE(marginsOf(loop, off, made.gains).ms, row.off) << toString(row.aim) << tau;
                worst = std::max(worst, marginsOf(loop, plant, made.gains).ms);
                worstOff = std::max(worstOff, marginsOf(loop, off, made.gains).ms);
            }
        }
        std::printf(
            "A9 %s: Ms %.2f, %.2f where the model is off\n", std::string(toString(row.aim)).c_str(), worst, worstOff);
    }
}

TEST(GainRules, DerivativeNoiseSlowsThePositionLoop)
{
    const PlantModel plant{362'000.0, 0.168, 0.002, 0.02};
    LoopBounds bounds;
    bounds.period = 0.0005;
    const Design made = design(Mode::Position, plant, 0.002 / 0.25, bounds);
    EXPECT_LE(made.gains.d / bounds.period, 0.1);
    EXPECT_EQ(made.bounds.at(0), "derivative noise");
    EXPECT_GT(made.response, 0.008);
}

TEST(GainRules, ALargeErrorDoesNotMakeARelayOfTheLoop)
{
    const PlantModel plant{362'000.0, 0.168, 0.002, 0.02};
    LoopBounds bounds;
    bounds.largestError = 40'000.0;
    const Design made = design(Mode::Position, plant, 0.02, bounds);
    EXPECT_LE(made.gains.p * 40'000.0, 3.0);
}

TEST(GainRules, FeedForwardAndIntegralThatFightAreSeen)
{
    ContinuousGains gains = velocityRule(testedPlant, 1.5 * testedPlant.delay);
    EXPECT_NEAR(conflictArea(testedPlant, gains, 1.5 * testedPlant.delay, 100'000.0), 0.0, 0.02);
    gains.f = 1.0 / testedPlant.gain;
    EXPECT_GT(conflictArea(testedPlant, gains, 1.5 * testedPlant.delay, 100'000.0), 0.09);
}

TEST(Acceptance, A04_TheNormalAimHardlyOvershootsAndSettlesInTimeOnTheModel)
{
    for (const double tau : {0.019, 0.093, 0.168, 0.245}) {
        const PlantModel plant{362'000.0, tau, 0.051, 0.02};
        const Design made = design(Mode::Velocity, plant, responseOf(Mode::Velocity, Aim::Normal, plant), {});
        const Prediction seen = predictStep(Mode::Velocity, plant, made.gains, 0.0, 80'000.0, 3.0);
        ASSERT_TRUE(seen.metrics.overshoot && seen.metrics.settle);
        EXPECT_LE(*seen.metrics.overshoot, 0.05) << tau;
        EXPECT_LE(*seen.metrics.settle, 8.0 * plant.delay) << tau;
        EXPECT_NEAR(seen.metrics.sse.value_or(1.0), 0.0, 0.002) << tau;
        std::printf("A4 tau %.0f ms: overshoot %.1f %%, settled in %.1f delays\n", 1e3 * tau,
            100.0 * *seen.metrics.overshoot, *seen.metrics.settle / plant.delay);
    }
}

TEST(Prediction, FrictionHoldsAProportionalPositionLoopShort)
{
    const PlantModel plant{362'000.0, 0.168, 0.001, 0.05};
    const ContinuousGains gains = positionRule(plant, 10.0);
    const double step = 20'000.0;
    const Prediction seen = predictStep(Mode::Position, plant, gains, 0.0, step, 3.0);
    const double left = step - seen.measured.y.back();
    EXPECT_GT(left, 0.0);
    EXPECT_LE(left, 1.05 * deadband(plant, gains));
}

TEST(Prediction, IsSummedOverAsLongAsATrialIsHeld)
{
    const PlantModel plant{362'000.0, 0.168, 0.001, 0.05};
    const ContinuousGains gains
        = positionRule(plant, 10.0); // friction holds it short, which counts for as long as one looks
    Prediction longer = predictStep(Mode::Position, plant, gains, 0.0, 20'000.0, 3.0);
    const Prediction held = predictStep(Mode::Position, plant, gains, 0.0, 20'000.0, 0.8);
    EXPECT_GT(*longer.metrics.itae, 2.0 * *held.metrics.itae);
    const auto settle = longer.metrics.settle;
    sumOver(longer, Mode::Position, 20'000.0, 0.8);
    EXPECT_NEAR(*longer.metrics.itae, *held.metrics.itae, 0.01 * *held.metrics.itae);
    EXPECT_NEAR(*longer.metrics.iae, *held.metrics.iae, 0.01 * *held.metrics.iae);
    EXPECT_EQ(longer.metrics.settle, settle);
}

TEST(Prediction, TheOutputStaysWithinItsLimit)
{
    LoopShape half;
    half.mostDuty = 0.5;
    const Prediction seen = predictStep(
        Mode::Velocity, testedPlant, velocityRule(testedPlant, testedPlant.delay), 0.0, 300'000.0, 2.0, half);
    for (const double duty : seen.duty.y)
        EXPECT_LE(std::abs(duty), 0.5);
}

} // namespace
} // namespace mb::tuning
