// SPDX-License-Identifier: GPL-3.0-or-later
// The rules of gains in numbers that can be worked out by hand, and what slows them.
#include "tuning/gainrules.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mb::tuning {
namespace {

const PlantModel ruledPlant{40'000.0, 0.2, 0.01, 0.04};

TEST(GainRules, ACurrentLoopIsTunedByItsLambda)
{
    // p = (L/R)/(gain·(lambda + delay)), i = 1/(gain·(lambda + delay))
    const ContinuousGains gains = currentRule({100.0, 0.0008, 0.0005}, 0.0015);
    EXPECT_NEAR(gains.i, 5.0, 1e-9);
    EXPECT_NEAR(gains.p, 0.004, 1e-12);
    EXPECT_EQ(gains.d, 0.0);
    EXPECT_EQ(gains.f, 0.0);
}

TEST(GainRules, PolesOfAPositionLoopWithAnIntegralLieWhereTheyWereAsked)
{
    // (s² + 2·zeta·omega·s + omega²)·(s + alpha·omega) = s³ + (1 + gain·d)/tau·s² + gain·p/tau·s + gain·i/tau
    const double omega = 12.0;
    const double zeta = 0.9;
    const double alpha = 0.3;
    const ContinuousGains gains = positionRuleWithIntegral(ruledPlant, omega, zeta, alpha);
    EXPECT_NEAR((1.0 + ruledPlant.gain * gains.d) / ruledPlant.tau, omega * (2.0 * zeta + alpha), 1e-9);
    EXPECT_NEAR(ruledPlant.gain * gains.p / ruledPlant.tau, omega * omega * (1.0 + 2.0 * zeta * alpha), 1e-9);
    EXPECT_NEAR(ruledPlant.gain * gains.i / ruledPlant.tau, omega * omega * omega * alpha, 1e-9);
    EXPECT_EQ(positionRuleWithIntegral(ruledPlant, 1.0, zeta, alpha).d, 0.0) << "its own damping is more";
}

TEST(GainRules, WithoutDThePIsWhatItsDampingAllows)
{
    // 1/tau = 2·zeta·omega at most
    for (const double zeta : {1.0, 0.7}) {
        const double omega = 1.0 / (2.0 * zeta * ruledPlant.tau);
        const double most = ruledPlant.tau * omega * omega / ruledPlant.gain;
        EXPECT_NEAR(positionRule(ruledPlant, 0.999 * omega, zeta).p, 0.999 * 0.999 * most, 1e-15);
        EXPECT_EQ(positionRule(ruledPlant, 0.999 * omega, zeta).d, 0.0);
        EXPECT_NEAR(positionRule(ruledPlant, 2.0 * omega, zeta).p, 4.0 * most, 1e-12);
        EXPECT_NEAR(positionRule(ruledPlant, 2.0 * omega, zeta).d, 1.0 / ruledPlant.gain, 1e-12);
    }
}

TEST(GainRules, EachAimIsAMultipleOfTheDelay)
{
    const auto response = [](Mode loop, Aim aim) { return responseOf(loop, aim, ruledPlant); };
    EXPECT_DOUBLE_EQ(response(Mode::Velocity, Aim::Calm), 0.03);
    EXPECT_DOUBLE_EQ(response(Mode::Velocity, Aim::Normal), 0.015);
    EXPECT_DOUBLE_EQ(response(Mode::Velocity, Aim::Brisk), 0.01);
    EXPECT_DOUBLE_EQ(response(Mode::Position, Aim::Calm), 0.1);
    EXPECT_DOUBLE_EQ(response(Mode::Position, Aim::Normal), 0.05);
    EXPECT_DOUBLE_EQ(response(Mode::Position, Aim::Brisk), 0.04);
    EXPECT_DOUBLE_EQ(response(Mode::Current, Aim::Calm), 0.003);
    EXPECT_DOUBLE_EQ(response(Mode::Current, Aim::Normal), 0.002);
    EXPECT_DOUBLE_EQ(response(Mode::Current, Aim::Brisk), 0.0015);
}

TEST(GainRules, AimsHaveTheirNames)
{
    for (const Aim aim : {Aim::Calm, Aim::Normal, Aim::Brisk})
        EXPECT_EQ(aimFromString(toString(aim)), aim);
    EXPECT_EQ(toString(Aim::Normal), "normal");
    EXPECT_FALSE(aimFromString("quick"));
}

TEST(GainRules, AMotorWithoutALagHasNoAccelerationToTell)
{
    EXPECT_EQ(profileLimits({40'000.0, 0.0, 0.0, 0.0}, 1.0).acceleration, 0.0);
    EXPECT_DOUBLE_EQ(profileLimits({40'000.0, 0.0, 0.0, 0.0}, 1.0).speed, 32'000.0);
}

TEST(GainRules, ALoopIsWithinItsBoundsUpToTheirEnd)
{
    LoopBounds bounds;
    EXPECT_TRUE(isWithin({1.0, 0.0, 1.0}, bounds)) << "nothing is known";
    bounds.period = 0.001;
    bounds.derivativeShare = 0.125;
    EXPECT_TRUE(isWithin({0.0, 0.0, 0.000125}, bounds));
    EXPECT_FALSE(isWithin({0.0, 0.0, 0.0001251}, bounds));
    bounds.largestError = 1000.0;
    EXPECT_TRUE(isWithin({0.003, 0.0, 0.0}, bounds));
    EXPECT_FALSE(isWithin({0.003001, 0.0, 0.0}, bounds));
}

TEST(GainRules, AMarginHoldsOnTheModelAndBesideIt)
{
    // an integrator of 0.5/delay behind its delay: 1.59; of 0.5 · 1.2 · 1.3: 2.22
    const PlantModel plant{40'000.0, 0.05, 0.01, 0.04};
    const ContinuousGains gains = velocityRule(plant, plant.delay);
    EXPECT_TRUE(hasMargin(Mode::Velocity, plant, gains, 1.6, 2.23));
    EXPECT_FALSE(hasMargin(Mode::Velocity, plant, gains, 1.58, 9.0));
    EXPECT_FALSE(hasMargin(Mode::Velocity, plant, gains, 1.6, 2.20));
}

TEST(GainRules, ADesignSaysWhatSlowedItOnceAndByHowMuch)
{
    const Design free = design(Mode::Velocity, ruledPlant, 0.02, {});
    EXPECT_TRUE(free.bounds.empty());
    EXPECT_EQ(free.response, 0.02);
    EXPECT_EQ(free.gains, velocityRule(ruledPlant, 0.02));
    const Design held = design(Mode::Velocity, ruledPlant, 0.004, {});
    ASSERT_EQ(held.bounds.size(), 1U);
    EXPECT_EQ(held.bounds.front(), "margin");
    EXPECT_EQ(held.asked, 0.004);
    EXPECT_EQ(held.gains, velocityRule(ruledPlant, held.response));
    // slower by 5 % each time, no further than it must
    const double times = std::log(held.response / 0.004) / std::log(1.05);
    EXPECT_NEAR(times, std::round(times), 1e-6);
    EXPECT_FALSE(hasMargin(Mode::Velocity, ruledPlant, velocityRule(ruledPlant, held.response / 1.05), 1.6, 1.9));
    LoopBounds bounds;
    bounds.largestError = 100'000.0;
    const Design still = design(Mode::Position, ruledPlant, 0.05, bounds);
    ASSERT_EQ(still.bounds.size(), 1U);
    EXPECT_EQ(still.bounds.front(), "largest error");
    EXPECT_NEAR(still.gains.p * 100'000.0, 3.0, 0.3);
    EXPECT_LE(still.gains.p * 100'000.0, 3.0);
}

TEST(GainRules, ADeadbandIsWhatFrictionHoldsOfP)
{
    EXPECT_DOUBLE_EQ(deadband(ruledPlant, {0.0004}), 100.0);
    EXPECT_EQ(deadband(ruledPlant, {}), 0.0);
}

TEST(GainRules, TheAreaOfAConflictIsWhatTheIntegralDoesNotNeed)
{
    // ∫e dt = (1/gain·(1 − f·gain) + friction/step)/i of a step; the unavoidable is response + delay
    const ContinuousGains gains{0.0, 0.001, 0.0, 0.5 / 40'000.0};
    const double area = (0.5 / 40'000.0 + 0.04 / 10'000.0) / 0.001;
    EXPECT_NEAR(conflictArea(ruledPlant, gains, 0.03, 10'000.0), 0.04 - area, 1e-12);
    EXPECT_NEAR(conflictArea(ruledPlant, gains, 0.03, -10'000.0), 0.04 - area, 1e-12);
    EXPECT_EQ(conflictArea(ruledPlant, {0.0, 0.0, 0.0, 1.0}, 0.03, 10'000.0), 0.0);
    EXPECT_EQ(conflictArea(ruledPlant, gains, 0.03, 0.0), 0.0);
    EXPECT_EQ(conflictArea(ruledPlant, gains, 0.0, 10'000.0), 0.0) << "the integral has more to do";
}

} // namespace
} // namespace mb::tuning
