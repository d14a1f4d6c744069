// SPDX-License-Identifier: GPL-3.0-or-later
#include "tuning/twopointruns.h"
#include "tuning/twopointsteps.h"

#include <gtest/gtest.h>

namespace mb::tuning {
namespace {

/// Full output at 20 000 raw P times counts, within 6000 counts.
StepGround knownGround()
{
    StepGround ground;
    ground.stored = {500.0, 4000.0};
    ground.isKnown = true;
    ground.full = 20'000.0;
    ground.cycle = 0.001;
    ground.room = 6000.0;
    return ground;
}

/// Nobody knows what full output is; 1 A for 10 000 of P times counts, of which 2000 move it.
StepGround unknownGround()
{
    StepGround ground;
    ground.stored = {250.0, 1000.0};
    ground.cycle = 0.001;
    ground.room = 6000.0;
    ground.envelope.current = 5.0;
    ground.moves = {2000.0, 1e-4};
    return ground;
}

TEST(TwoPointSteps, WithAKnownOutputTheyMakeHalfOfItOfAWeakerP)
{
    const auto steps = TwoPointSteps::chosenFrom(knownGround());
    ASSERT_TRUE(steps) << steps.error().text();
    EXPECT_EQ(steps->drive, 10'000.0);
    EXPECT_EQ(steps->first.p, 67.0) << "the smallest step of three has 60 counts: 10 000 over 150";
    EXPECT_NEAR(steps->first.d, 4000.0 * std::sqrt(67.0 / 500.0), 0.5) << "as well damped as the stored ones";
    EXPECT_FALSE(steps->isLed);
}

TEST(TwoPointSteps, ALimitOfDutyMakesThemSmaller)
{
    StepGround ground = knownGround();
    ground.envelope.duty = 0.3;
    const auto steps = TwoPointSteps::chosenFrom(ground);
    ASSERT_TRUE(steps);
    EXPECT_EQ(steps->drive, 3000.0);
    EXPECT_EQ(steps->first.p, 20.0);
}

TEST(TwoPointSteps, ThePIsNeverFirmerThanTheStoredOne)
{
    StepGround ground = knownGround();
    ground.stored = {30.0, 0.0};
    const auto steps = TwoPointSteps::chosenFrom(ground);
    ASSERT_TRUE(steps);
    EXPECT_EQ(steps->first.p, 30.0);
    EXPECT_EQ(steps->first.d, 240.0) << "a unit without D gets eight of it for one of P";
}

TEST(TwoPointSteps, RoomBoundsTheStepsAndTooLittleOfItIsRefused)
{
    StepGround ground = knownGround();
    ground.stored.p = 20.0;
    ground.room = 100.0;
    const auto bounded = TwoPointSteps::chosenFrom(ground);
    ASSERT_TRUE(bounded);
    EXPECT_EQ(bounded->drive, 2000.0) << "P of 20 over 100 counts";
    ground.room = 49.0;
    const auto refused = TwoPointSteps::chosenFrom(ground);
    ASSERT_FALSE(refused) << "the smallest step is 2.5 times smaller: under 20 counts";
    EXPECT_EQ(refused.error().fault, Fault::OutOfRange);
    EXPECT_NE(refused.error().text().find("steps of 20 counts"), std::string::npos) << refused.error().text();
}

TEST(TwoPointSteps, WithoutAKnownOutputTheyMakeAsMuchAsTheStoredPOf200Counts)
{
    EXPECT_TRUE(TwoPointSteps::chosenFrom(unknownGround())->isLed)
        << "50 000 of P times counts draw 5 A, all that it may";
    StepGround light = unknownGround();
    light.moves.current = 1e-5;
    const auto free = TwoPointSteps::chosenFrom(light);
    ASSERT_TRUE(free);
    EXPECT_EQ(free->first.p, 100.0);
    EXPECT_EQ(free->first.d, 500.0);
    EXPECT_FALSE(free->isLed);
    EXPECT_EQ(free->drive, 50'000.0);
    EXPECT_FALSE(free->isGrown) << "friction is 1430 of it";
}

TEST(TwoPointSteps, FrictionThatTakesMuchMakesThemLargerWithinWhatTheCurrentAllows)
{
    StepGround ground = unknownGround();
    ground.moves = {14'000.0, 1e-5};
    const auto steps = TwoPointSteps::chosenFrom(ground);
    ASSERT_TRUE(steps);
    EXPECT_TRUE(steps->isGrown);
    EXPECT_NEAR(steps->drive, 14'000.0 / 1.4 / 0.15, 1.0) << "so that friction is 15 % of it";
    ground.moves.push = 1e6;
    EXPECT_EQ(TwoPointSteps::chosenFrom(ground)->drive, 125'000.0) << "at most 2.5 times as large";
    ground.moves.current = 4e-5; // 5 A are 87 500 at the most
    EXPECT_NEAR(TwoPointSteps::chosenFrom(ground)->drive, 87'500.0, 1.0);
}

TEST(TwoPointSteps, AStrongMotorIsLedAtARateWhoseBeginningItsCurrentAllows)
{
    const StepGround ground = unknownGround();
    const auto steps = TwoPointSteps::chosenFrom(ground);
    ASSERT_TRUE(steps);
    EXPECT_EQ(steps->drive, 35'000.0) << "0.7 of 5 A";
    EXPECT_EQ(steps->first.p, 18.0) << "over 2000 counts";
    EXPECT_LE(steps->first.d, 0.1 * 5.0 / 1e-4 / 2.0) << "one count makes a tenth of the current through twice the D";
    const double drawn = steps->rate * 1e-4 * 2.0 * steps->first.d * 0.001;
    EXPECT_LE(drawn, 0.8 * 5.0 + 0.05);
    EXPECT_GE(drawn, 0.8 * 5.0 - 0.05);
    StepGround slow = ground;
    slow.envelope.speed = 300.0;
    EXPECT_EQ(TwoPointSteps::chosenFrom(slow)->rate, 300.0);
}

TEST(TwoPointSteps, AStrongMotorWhoseFrictionIsMostOfItsCurrentIsRefused)
{
    StepGround ground = unknownGround();
    ground.moves.push = 1.4 * 0.61 * 35'000.0;
    const auto refused = TwoPointSteps::chosenFrom(ground);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().text().find("friction takes 61"), std::string::npos) << refused.error().text();
    ground.moves.push = 1.4 * 0.59 * 35'000.0;
    EXPECT_TRUE(TwoPointSteps::chosenFrom(ground));
}

TEST(TwoPointSteps, TheyGrowOnceAndOnlyWhereTheOutputIsNotKnown)
{
    StepGround ground = unknownGround();
    ground.moves.current = 1e-5;
    auto steps = *TwoPointSteps::chosenFrom(ground);
    EXPECT_FALSE(steps.grow(ground, 0.15));
    EXPECT_TRUE(steps.grow(ground, 0.30));
    EXPECT_EQ(steps.drive, 100'000.0);
    EXPECT_FALSE(steps.grow(ground, 0.30)) << "once";
    auto known = *TwoPointSteps::chosenFrom(knownGround());
    EXPECT_FALSE(known.grow(knownGround(), 0.5));
    StepGround narrow = ground;
    narrow.room = 700.0;
    auto bounded = *TwoPointSteps::chosenFrom(narrow);
    EXPECT_TRUE(bounded.grow(narrow, 0.5));
    EXPECT_EQ(bounded.drive, 70'000.0) << "P of 100 over its room";
}

TEST(TwoPointSteps, LargerOnesHaveAQuarterOfThePAndHalfTheDOnceAndWhereTheyFit)
{
    const StepGround ground = knownGround();
    auto steps = *TwoPointSteps::chosenFrom(ground);
    const RawGains before = steps.first;
    EXPECT_TRUE(steps.enlarge(ground));
    EXPECT_EQ(steps.first.p, std::round(before.p / 4.0));
    EXPECT_EQ(steps.first.d, std::round(before.d / 2.0));
    EXPECT_EQ(steps.drive, 10'000.0) << "the same output";
    EXPECT_FALSE(steps.enlarge(ground)) << "once";
    StepGround narrow = ground;
    narrow.room = 500.0; // four times 149 counts do not fit
    auto bounded = *TwoPointSteps::chosenFrom(narrow);
    EXPECT_FALSE(bounded.enlarge(narrow));
    EXPECT_EQ(bounded.first.p, before.p);
    auto coarse = steps;
    coarse.isEnlarged = false;
    coarse.first.p = 36.0; // a quarter is no more than nine steps of its integer
    EXPECT_FALSE(coarse.enlarge(ground));
}

/// One that rests `left` before its target, halfway after 20 samples of 1 ms, or after `halfway`.
LoopRun wayTo(double step, double p, double left, int halfway = 20)
{
    LoopRun run;
    run.p = p;
    run.d = 100.0;
    run.step = step;
    for (int i = 0; i < 400; ++i) {
        run.way.t.push_back(0.001 * i);
        run.way.y.push_back((step - left) * std::min(1.0, 0.5 * i / halfway));
    }
    return run;
}

TEST(TwoPointRuns, FrictionHoldsWhatTheWorstStepLeftAndACount)
{
    TwoPointRuns runs;
    runs.steps = {wayTo(100.0, 100.0, 2.0), wayTo(-100.0, 100.0, -5.0)};
    EXPECT_NEAR(runs.holding(), 1.15 * (5.0 * 100.0 + 100.0), 30.0);
    runs.creeping = {wayTo(100.0, 100.0, 20.0)};
    EXPECT_NEAR(runs.holding(), 1.15 * (20.0 * 100.0 + 100.0), 100.0) << "slow ones tell it too";
}

TEST(TwoPointRuns, ASmallerStepThatIsQuickerTellsOfAnOutputAtItsEnd)
{
    TwoPointRuns runs;
    runs.steps = {wayTo(50.0, 100.0, 0.0, 14), wayTo(100.0, 100.0, 0.0, 20)};
    EXPECT_FALSE(runs.isLinear(10'000.0, false));
    runs.steps.front() = wayTo(50.0, 100.0, 0.0, 18);
    EXPECT_TRUE(runs.isLinear(10'000.0, false)) << "a tenth is no proof";
    runs.steps.front() = wayTo(50.0, 100.0, 0.0, 14);
    EXPECT_TRUE(runs.isLinear(10'000.0, true)) << "where the output is known they were chosen by it";
}

TEST(TwoPointRuns, OnlyStepsOfTheSameGainsAreHeldAgainstEachOther)
{
    TwoPointRuns runs;
    runs.steps = {wayTo(50.0, 100.0, 0.0, 14), wayTo(100.0, 100.0, 0.0, 20)};
    runs.steps.front().d = 50.0;
    EXPECT_TRUE(runs.isLinear(10'000.0, false));
    runs.steps.front().d = 100.0;
    runs.steps.front().p = 80.0;
    EXPECT_TRUE(runs.isLinear(10'000.0, false));
}

TEST(TwoPointRuns, AWayThatIsLedCountsWithWhatLeadsIt)
{
    TwoPointRuns runs;
    runs.steps = {wayTo(50.0, 100.0, 0.0, 22), wayTo(100.0, 100.0, 0.0, 42)};
    for (LoopRun &run : runs.steps)
        run.rate = 2000.0; // within 25 and 50 ms, 9.5 and 17 ms behind
    EXPECT_TRUE(runs.isLinear(10'000.0, false)) << "7.5 ms of 42";
    runs.steps.back() = wayTo(100.0, 100.0, 0.0, 70);
    runs.steps.back().rate = 2000.0;
    EXPECT_FALSE(runs.isLinear(10'000.0, false)) << "its output did not follow the profile";
}

TEST(TwoPointRuns, EachGateFailsByItself)
{
    TwoPointRuns runs;
    runs.steps = {wayTo(100.0, 100.0, 1.0), wayTo(-100.0, 100.0, -1.0)};
    LoopFit fit;
    fit.d = 1.0;
    const auto failed = [&] {
        std::string keys;
        for (const Gate &gate : runs.gates(fit, 10'000.0, false))
            keys += gate.passed ? "" : gate.name + ';';
        return keys;
    };
    EXPECT_EQ(failed(), "");
    fit.residual = 0.081;
    EXPECT_EQ(failed(), "fit;");
    EXPECT_TRUE(isDoubtful(fit));
    fit.residual = 0.079;
    fit.dError = 0.31;
    EXPECT_EQ(failed(), "damping;");
    EXPECT_TRUE(isDoubtful(fit));
    fit.dError = 0.29;
    EXPECT_FALSE(isDoubtful(fit));
    fit.pushError = 0.1;
    EXPECT_TRUE(isDoubtful(fit)) << "both together";
    fit.pushError = 0.0;
    runs.steps = {wayTo(100.0, 100.0, 60.0), wayTo(-100.0, 100.0, -60.0)};
    EXPECT_EQ(failed(), "friction;");
    runs.steps = {wayTo(100.0, 100.0, 20.0), wayTo(-100.0, 100.0, 5.0)};
    EXPECT_EQ(failed(), "asymmetric load;") << "it pulls one way";
}

} // namespace
} // namespace mb::tuning
