// SPDX-License-Identifier: GPL-3.0-or-later
// The motor of a model in a loop, against what its equations say.
#include "tuning/simulatedloop.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mb::tuning {
namespace {

constexpr ContinuousGains noGains{};
/// A loop that puts out 1 for each count/s or count of its target.
constexpr ContinuousGains straight{0.0, 0.0, 0.0, 1.0};

LoopShape passShape(double pass)
{
    LoopShape shape;
    shape.period = pass;
    return shape;
}

TEST(SimulatedLoop, AMotorAnswersADutyAsItsLagSaysWhateverThePassesAre)
{
    const PlantModel plant{1000.0, 0.2, 0.0, 0.05};
    for (const double pass : {0.001, 0.01, 0.1}) {
        SimulatedLoop velocity(Mode::Velocity, plant, straight, passShape(pass), 0.0);
        SimulatedLoop position(Mode::Position, plant, straight, passShape(pass), 0.0);
        const int passes = static_cast<int>(std::lround(0.3 / pass));
        for (int i = 0; i < passes; ++i) {
            EXPECT_EQ(velocity.pass(0.4), 0.4);
            (void)position.pass(-0.4);
        }
        const double end = 1000.0 * 0.35;
        EXPECT_NEAR(velocity.value(), end * (1.0 - std::exp(-1.5)), 1e-9);
        EXPECT_NEAR(position.value(), -end * (0.3 - 0.2 * (1.0 - std::exp(-1.5))), 1e-9);
    }
}

TEST(SimulatedLoop, AMotorRollsOutAndStandsWhereFrictionStopsIt)
{
    // v = −f + (v0 + f)·e^(−t/tau): it stands after tau·ln(1 + v0/f), and does not go back
    const PlantModel plant{1000.0, 0.2, 0.0, 0.05};
    SimulatedLoop position(Mode::Position, plant, straight, passShape(0.01), 0.0);
    for (int i = 0; i < 500; ++i)
        (void)position.pass(0.45);
    const double before = position.value();
    for (int i = 0; i < 200; ++i)
        (void)position.pass(0.0);
    const double speed = 400.0;
    const double stops = 0.2 * std::log1p(speed / 50.0);
    EXPECT_NEAR(position.value() - before, -50.0 * stops + (speed + 50.0) * 0.2 * (1.0 - 50.0 / 450.0), 1e-6);
}

TEST(SimulatedLoop, AGearBrakesMoreStronglyThanItDrives)
{
    // braked: tau/b, and friction/b of the duty
    const PlantModel plant{1000.0, 0.2, 0.0, 0.05, 2.0};
    SimulatedLoop velocity(Mode::Velocity, plant, straight, passShape(0.01), 0.0);
    for (int i = 0; i < 1000; ++i)
        (void)velocity.pass(0.45);
    for (int i = 0; i < 5; ++i)
        (void)velocity.pass(0.1);
    const double end = 1000.0 * (0.1 - 0.025);
    EXPECT_NEAR(velocity.value(), end + (400.0 - end) * std::exp(-0.05 / 0.1), 1e-9);
}

TEST(SimulatedLoop, AMotorTurnsWithinAPassWithoutLosingItsTime)
{
    // braked to 0 and driven the other way in one long pass, as in many short ones
    const PlantModel plant{1000.0, 0.2, 0.0, 0.05, 1.5};
    SimulatedLoop coarse(Mode::Position, plant, straight, passShape(0.25), 0.0);
    SimulatedLoop small(Mode::Position, plant, straight, passShape(0.0001), 0.0);
    for (const double duty : {0.6, -0.6, 0.3}) {
        (void)coarse.pass(duty);
        for (int i = 0; i < 2500; ++i)
            (void)small.pass(duty);
        EXPECT_NEAR(coarse.value(), small.value(), 0.01) << duty;
    }
}

TEST(SimulatedLoop, ASupplyThatSagsMakesTheLagLongerToSevenDigits)
{
    // tau·(1 + sag·(duty² − 0.3²)); a pass shorter than a fifth of a lag takes a fraction for the exponential
    for (const double pass : {0.01, 0.03, 0.06}) {
        PlantModel plant{1000.0, 0.2, 0.0, 0.0};
        plant.sag = 0.5;
        SimulatedLoop velocity(Mode::Velocity, plant, straight, passShape(pass), 0.0);
        (void)velocity.pass(0.9);
        const double tau = 0.2 * (1.0 + 0.5 * (0.81 - 0.09));
        EXPECT_NEAR(velocity.value(), 900.0 * (1.0 - std::exp(-pass / tau)), 900.0 * 5e-7) << pass;
    }
}

TEST(SimulatedLoop, AtRestItIsHeldByMoreThanItsFrictionWhereNoGearLosesTorque)
{
    const auto moves = [](const PlantModel &plant, double duty, LoopShape shape) {
        SimulatedLoop position(Mode::Position, plant, straight, shape, 0.0);
        (void)position.pass(duty);
        return position.value() != 0.0;
    };
    const PlantModel plain{1000.0, 0.2, 0.0, 0.1};
    EXPECT_FALSE(moves(plain, 0.119, passShape(0.01)));
    EXPECT_FALSE(moves(plain, -0.119, passShape(0.01)));
    EXPECT_TRUE(moves(plain, 0.121, passShape(0.01)));
    EXPECT_TRUE(moves(plain, -0.121, passShape(0.01)));
    // 2/(1 + braking) of its friction is its own: 1.2·2/2.2 of it, or all of it
    PlantModel lossy = plain;
    lossy.braking = 1.2;
    EXPECT_FALSE(moves(lossy, 0.109, passShape(0.01)));
    EXPECT_TRUE(moves(lossy, 0.110, passShape(0.01)));
    lossy.braking = 2.0;
    EXPECT_FALSE(moves(lossy, 0.0999, passShape(0.01)));
    EXPECT_TRUE(moves(lossy, 0.1001, passShape(0.01)));
    LoopShape counted = passShape(0.01);
    counted.windowCounts = 8.0;
    EXPECT_FALSE(moves(lossy, 0.119, counted));
    EXPECT_TRUE(moves(lossy, 0.121, counted));
    LoopShape helped = passShape(0.01);
    helped.leastOutput = 0.11; // written so that it moves the motor
    EXPECT_FALSE(moves(plain, 0.05, passShape(0.01)));
    EXPECT_TRUE(moves(plain, 0.05, helped));
    helped.leastOutput = 0.5;
    EXPECT_TRUE(moves(plain, 0.05, helped));
}

TEST(SimulatedLoop, ItBeginsAtASpeedWithTheDutyThatKeepsIt)
{
    const PlantModel plant{1000.0, 0.2, 0.01, 0.05};
    const ContinuousGains gains{0.001, 0.005, 0.0, 0.0004};
    for (const double speed : {300.0, -300.0}) {
        SimulatedLoop velocity(Mode::Velocity, plant, gains, passShape(0.001), speed);
        for (int i = 0; i < 100; ++i)
            EXPECT_NEAR(velocity.pass(speed), speed / 1000.0 + std::copysign(0.05, speed), 1e-9);
        EXPECT_NEAR(velocity.value(), speed, 1e-6);
        EXPECT_NEAR(velocity.measured(), speed, 1e-6);
    }
    SimulatedLoop position(Mode::Position, plant, gains, passShape(0.001), 70.0);
    EXPECT_EQ(position.value(), 70.0);
    EXPECT_NEAR(position.pass(70.0), 0.0004 * 70.0, 1e-12) << "at rest, nothing of its integral";
}

TEST(SimulatedLoop, WhatItPutsOutIsThatOfItsGains)
{
    const PlantModel still{1e-9, 1.0, 0.0, 0.0};
    LoopShape shape = passShape(0.01);
    SimulatedLoop loop(Mode::Position, still, {0.001, 0.01, 0.0002, 0.0001}, shape, 0.0);
    // e = 100: 0.1 of P, 0.01 of I a pass, 0.0002·100/0.01 of D in the first, 0.01 of the target
    EXPECT_NEAR(loop.pass(100.0), 1.0, 1e-9) << "and no more than all";
    EXPECT_NEAR(loop.pass(100.0), 0.1 + 0.02 + 0.01, 1e-9);
    EXPECT_NEAR(loop.pass(90.0), 0.09 + 0.029 - 0.2 + 0.009, 1e-9);
    shape.mostDuty = 0.25;
    SimulatedLoop bounded(Mode::Position, still, {0.01, 0.0, 0.0, 0.0}, shape, 0.0);
    EXPECT_EQ(bounded.pass(100.0), 0.25);
    EXPECT_EQ(bounded.pass(-100.0), -0.25);
}

TEST(SimulatedLoop, IntegralAndOutputGoInWholeSteps)
{
    const PlantModel still{1e-9, 1.0, 0.0, 0.0};
    LoopShape shape = passShape(0.01);
    shape.integralStep = 0.01;
    SimulatedLoop coarse(Mode::Position, still, {0.0, 0.019, 0.0, 0.0}, shape, 0.0);
    EXPECT_NEAR(coarse.pass(100.0), 0.01, 1e-12); // 0.019 a pass
    EXPECT_NEAR(coarse.pass(100.0), 0.02, 1e-12);
    EXPECT_NEAR(coarse.pass(50.0), 0.02, 1e-12) << "less than a step moves nothing";
    shape.integralStep = 0.0;
    shape.integralMost = 0.03;
    SimulatedLoop held(Mode::Position, still, {0.0, 0.019, 0.0, 0.0}, shape, 0.0);
    (void)held.pass(100.0);
    EXPECT_NEAR(held.pass(100.0), 0.03, 1e-12);
    EXPECT_NEAR(held.pass(-100.0), 0.011, 1e-12) << "it does not wind up";
    LoopShape output = passShape(0.01);
    output.outputStep = 0.1;
    SimulatedLoop stepped(Mode::Position, still, {0.0029, 0.0, 0.0, 0.0005}, output, 0.0);
    EXPECT_NEAR(stepped.pass(100.0), 0.2 + 0.05, 1e-12) << "P and D alone are rounded, to 0";
    EXPECT_NEAR(stepped.pass(-100.0), -0.2 - 0.05, 1e-12);
}

TEST(SimulatedLoop, ALeastOutputOvercomesFrictionUntilItIsGoodEnough)
{
    const PlantModel still{1e-9, 1.0, 0.0, 0.0};
    LoopShape shape = passShape(0.01);
    shape.leastOutput = 0.1;
    shape.goodEnough = 4.0;
    SimulatedLoop loop(Mode::Position, still, {0.001, 0.05, 0.0, 0.0}, shape, 0.0);
    EXPECT_NEAR(loop.pass(20.0), 0.1, 1e-12);
    EXPECT_NEAR(loop.pass(-20.0), -0.1, 1e-12);
    EXPECT_NEAR(loop.pass(200.0), 0.2 + 0.1, 1e-12);
    EXPECT_EQ(loop.pass(3.9), 0.0);
    EXPECT_NEAR(loop.pass(4.1), 0.1, 1e-12);
    EXPECT_NEAR(loop.pass(200.0), 0.2 + 0.1 + 0.00205, 1e-9) << "what was integrated before is forgotten";
    shape.goodEnough = 0.0;
    SimulatedLoop sure(Mode::Position, still, {0.001, 0.0, 0.0, 0.0}, shape, 0.0);
    EXPECT_NEAR(sure.pass(0.5), 0.1, 1e-12);
}

TEST(SimulatedLoop, SeesAStepAsLateAsThePlantsDelaySaysWithoutAPassAndAHalf)
{
    const auto firstSeen = [](double delay) {
        const PlantModel plant{1000.0, 0.2, delay, 0.0};
        SimulatedLoop velocity(Mode::Velocity, plant, straight, passShape(0.01), 0.0);
        for (int pass = 0; pass < 50; ++pass) {
            (void)velocity.pass(0.5);
            if (velocity.measured() > 0.0)
                return pass;
        }
        return -1;
    };
    EXPECT_EQ(firstSeen(0.0), 1);
    EXPECT_EQ(firstSeen(0.015), 1);
    EXPECT_EQ(firstSeen(0.025), 2);
    EXPECT_EQ(firstSeen(0.065), 6);
}

TEST(SimulatedLoop, WindowAndWindingAreInTheDelay)
{
    // 3 passes besides half of a window of ten, and a winding of one
    const PlantModel plant{1000.0, 1e-6, 0.105, 0.0};
    LoopShape shape = passShape(0.01);
    shape.window = 0.1;
    shape.winding = 0.01;
    SimulatedLoop velocity(Mode::Velocity, plant, straight, shape, 0.0);
    int unseen = 0;
    for (; velocity.measured() < 1.0 && unseen < 50; ++unseen)
        (void)velocity.pass(0.5);
    EXPECT_EQ(unseen, 5) << "of the first pass, the second shows it at once";
    shape.winding = 0.0;
    const ContinuousGains gains{0.001, 0.005, 0.0, 0.0004};
    SimulatedLoop moving(Mode::Velocity, {1000.0, 0.2, 0.105, 0.05}, gains, shape, 300.0);
    for (int i = 0; i < 30; ++i) {
        EXPECT_NEAR(moving.pass(300.0), 0.35, 1e-9) << "it has been at its speed for ever";
        EXPECT_NEAR(moving.measured(), 300.0, 1e-6);
    }
    shape.window = 0.02;
    shape.windowCounts = 8.0;
    SimulatedLoop counted(Mode::Velocity, {1000.0, 1e-6, 0.045, 0.0}, straight, shape, 0.0);
    for (int pass = 0; pass < 100; ++pass)
        (void)counted.pass(0.5);
    for (const double exactly : {500.0, 500.0, 500.0}) { // two passes, and the one that is not over
        (void)counted.pass(1.0);
        EXPECT_NEAR(counted.measured(), exactly, 1e-3);
    }
    (void)counted.pass(1.0);
    EXPECT_GT(counted.measured(), 700.0);
}

TEST(SimulatedLoop, AVelocityIsTakenOverItsWindow)
{
    // position after each pass of a motor at a constant speed from rest: its mean over ten passes
    const PlantModel plant{1000.0, 1e-6, 0.065, 0.0};
    LoopShape shape = passShape(0.01);
    shape.window = 0.1; // half of it is in the delay
    SimulatedLoop velocity(Mode::Velocity, plant, straight, shape, 0.0);
    for (int pass = 0; pass <= 12; ++pass) {
        (void)velocity.pass(0.5);
        EXPECT_NEAR(velocity.measured(), 500.0 * std::min(pass, 10) / 10.0, 0.1) << pass;
    }
    shape.isCounted = true;
    SimulatedLoop counted(Mode::Velocity, {333.0, 1e-6, 0.065, 0.0}, straight, shape, 0.0);
    for (int pass = 0; pass <= 20; ++pass)
        (void)counted.pass(0.5);
    EXPECT_NEAR(std::fmod(counted.measured(), 10.0), 0.0, 1e-9) << "whole counts over 0.1 s";
    EXPECT_NEAR(counted.measured(), 166.5, 10.0);
}

TEST(SimulatedLoop, AWindowOfCountsIsTheShortestInWhichItWentSoFar)
{
    const PlantModel plant{1000.0, 1e-6, 0.015, 0.0};
    LoopShape shape = passShape(0.01);
    shape.window = 0.02;
    shape.windowCounts = 8.0;
    SimulatedLoop quick(Mode::Velocity, plant, straight, shape, 0.0);
    for (int pass = 0; pass < 100; ++pass)
        (void)quick.pass(0.5); // five counts a pass: two of them
    EXPECT_NEAR(quick.measured(), 500.0, 1e-3);
    (void)quick.pass(0.1);
    (void)quick.pass(0.1); // which sees the one before: 1 count after 5 and 5
    EXPECT_NEAR(quick.measured(), 11.0 / 0.03, 0.1);
    // slower than eight counts in 0.671 s it waits no longer
    SimulatedLoop late(Mode::Velocity, plant, straight, shape, 0.0);
    for (int pass = 0; pass < 300; ++pass)
        (void)late.pass(0.005);
    EXPECT_NEAR(late.measured(), 5.0, 0.01);
    for (int pass = 0; pass < 34; ++pass)
        (void)late.pass(0.0);
    EXPECT_NEAR(late.measured(), 5.0 * 34.0 / 67.0, 0.15) << "half of its window at rest";
}

TEST(SimulatedLoop, ASetPointIsLedAtItsRate)
{
    const PlantModel still{1e-9, 1.0, 0.0, 0.0};
    LoopShape shape = passShape(0.01);
    shape.setPointRate = 1250.0;
    SimulatedLoop loop(Mode::Position, still, {0.01, 0.0, 0.0, 0.0}, shape, 0.0);
    EXPECT_NEAR(loop.pass(30.0), 0.125, 1e-9);
    EXPECT_NEAR(loop.pass(30.0), 0.25, 1e-9);
    EXPECT_NEAR(loop.pass(30.0), 0.3, 1e-9);
    EXPECT_NEAR(loop.pass(-30.0), 0.175, 1e-9);
    loop.beginAt(-30.0);
    EXPECT_NEAR(loop.pass(-30.0), -0.3, 1e-9);
    shape.isCounted = true;
    SimulatedLoop counted(Mode::Position, still, {0.01, 0.0, 0.0, 0.0}, shape, 0.0);
    EXPECT_NEAR(counted.pass(30.0), 0.13, 1e-9) << "12.5 counts";
}

TEST(SimulatedLoop, ItsCurrentIsWhatTheDutyLeavesOverTheSpeed)
{
    PlantModel plant{1000.0, 0.2, 0.0, 0.0};
    plant.stallCurrent = 40.0;
    plant.backDuty = 0.001;
    SimulatedLoop velocity(Mode::Velocity, plant, straight, passShape(0.01), 0.0);
    (void)velocity.pass(0.5);
    EXPECT_NEAR(velocity.current(), 40.0 * (0.5 - 0.001 * velocity.value()), 1e-9);
    EXPECT_GT(velocity.current(), 18.0);
    EXPECT_EQ(SimulatedLoop(Mode::Velocity, {1000.0, 0.2}, noGains, passShape(0.01), 0.0).current(), 0.0);
}

} // namespace
} // namespace mb::tuning
