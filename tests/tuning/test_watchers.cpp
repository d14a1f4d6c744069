// SPDX-License-Identifier: GPL-3.0-or-later
// What the guards of an experiment look at, at its edges.
#include "experiment/watchers.h"

#include <gtest/gtest.h>

#include <initializer_list>

namespace mb::tuning {
namespace {

using namespace std::chrono_literals;

constexpr Instant start{1s};
constexpr double friction = 0.25;

TEST(SlopeWatch, IsTakenOverTheLastThreeSamples)
{
    SlopeWatch slope;
    slope.add(start, 0.0);
    slope.add(start + 10ms, 10.0);
    EXPECT_DOUBLE_EQ(slope.add(start + 20ms, 30.0), 1500.0);
    EXPECT_DOUBLE_EQ(slope.add(start + 30ms, 60.0), 2500.0);
}

TEST(SlopeWatch, TakesMoreSamplesUntilTheyAreAMillisecondAndAHalfApart)
{
    SlopeWatch slope;
    slope.add(start, 0.0);
    slope.add(start + 500us, 1.0);
    EXPECT_EQ(slope.add(start + 1000us, 3.0), 0.0);
    EXPECT_DOUBLE_EQ(slope.add(start + 1500us, 6.0), 4000.0);
    EXPECT_DOUBLE_EQ(slope.add(start + 2000us, 10.0), 6000.0);
}

TEST(OverloadWatch, IsAboveItsLimitWithoutABreak)
{
    OverloadWatch watch;
    watch.add(start, 2.0, 1.0);
    watch.add(start + 60ms, -2.0, 1.0);
    EXPECT_EQ(watch.above(), 60ms);
    watch.add(start + 70ms, -1.0, 1.0);
    EXPECT_EQ(watch.above(), 0ms);
    watch.add(start + 80ms, 2.0, 1.0);
    watch.add(start + 130ms, 2.0, 1.0);
    EXPECT_EQ(watch.above(), 50ms);
}

TEST(OverloadWatch, ARestIsNeitherHeatNorOverload)
{
    OverloadWatch watch;
    watch.add(start, 2.0, 1.0);
    watch.add(start + 100ms, 2.0, 1.0);
    EXPECT_DOUBLE_EQ(watch.heat(), 0.4);
    watch.pause();
    EXPECT_EQ(watch.above(), 0ms);
    watch.add(start + 1100ms, 2.0, 1.0);
    EXPECT_DOUBLE_EQ(watch.heat(), 0.4);
    watch.add(start + 1200ms, 2.0, 1.0);
    EXPECT_DOUBLE_EQ(watch.heat(), 0.8);
    EXPECT_EQ(watch.above(), 100ms);
}

TEST(MotionWatch, ThreeCountsAreAMove)
{
    MotionWatch watch;
    watch.duty(start, 3.0 * friction, friction);
    watch.position(start, 0.0);
    watch.position(start + 100ms, 2.9);
    EXPECT_EQ(watch.stuck(), 100ms);
    watch.position(start + 200ms, 3.0);
    EXPECT_EQ(watch.stuck(), 0ms);
    watch.position(start + 300ms, 5.9);
    EXPECT_EQ(watch.stuck(), 100ms);
}

TEST(MotionWatch, IsStuckOnlyUnderThreeTimesWhatFrictionTakes)
{
    MotionWatch watch;
    watch.duty(start, 0.74, friction);
    watch.position(start, 0.0);
    watch.position(start + 1s, 0.0);
    EXPECT_EQ(watch.stuck(), 0ms);
    watch.duty(start + 1s, 0.75, friction);
    watch.duty(start + 1100ms, 0.75, friction);
    watch.position(start + 1200ms, 0.0);
    EXPECT_EQ(watch.stuck(), 200ms);
    watch.duty(start + 1300ms, 0.74, friction);
    EXPECT_EQ(watch.stuck(), 0ms);
    watch.position(start + 1400ms, 0.0);
    EXPECT_EQ(watch.stuck(), 0ms);
}

TEST(MotionWatch, APushTheOtherWayBeginsAnew)
{
    for (const double push : {0.75, -0.75}) {
        MotionWatch watch;
        watch.duty(start, push, friction);
        watch.position(start, 0.0);
        watch.position(start + 400ms, 0.0);
        EXPECT_EQ(watch.stuck(), 400ms);
        watch.duty(start + 400ms, -push, friction);
        EXPECT_EQ(watch.stuck(), 0ms);
        watch.position(start + 500ms, 0.0);
        EXPECT_EQ(watch.stuck(), 100ms);
    }
}

/// Samples 1/128 s apart after a push of six hundredths, where friction holds two.
struct Pushed {
    explicit Pushed(double push, std::initializer_list<double> before = {0.0})
    {
        see(before);
        watch.duty(now, push, 0.02);
    }
    int see(std::initializer_list<double> positions)
    {
        for (const double counts : positions)
            watch.position(now += 7812500ns, counts);
        return watch.wrong();
    }
    MotionWatch watch;
    Instant now = start;
};

TEST(MotionWatch, TenCountsTheWrongWayAreForgivenAndNoneBeyond)
{
    for (const double sign : {1.0, -1.0}) {
        EXPECT_EQ(Pushed(0.06 * sign).see({-10.05 * sign}), 1);
        Pushed motor(0.06 * sign);
        EXPECT_EQ(motor.see({-5.0 * sign, -10.0 * sign}), 0);
        motor.watch.duty(motor.now, 0.06 * sign, 0.02); // the same push goes on
        EXPECT_EQ(motor.see({-15.0 * sign}), 1);
        EXPECT_EQ(motor.see({-20.0 * sign}), 2);
        EXPECT_EQ(motor.see({-20.0 * sign}), 2) << "it stands";
        motor.now += 20s;
        EXPECT_EQ(motor.see({-19.0 * sign}), 0) << "however slowly, it goes the right way";
    }
}

TEST(MotionWatch, TheWrongWayIsThatFromWhereThePushBegan)
{
    Pushed motor(0.06);
    EXPECT_EQ(motor.see({40.0, 80.0}), 0);
    motor.watch.duty(motor.now, 0.01, 0.02);
    motor.see({80.0});
    motor.watch.duty(motor.now, 0.06, 0.02);
    EXPECT_EQ(motor.see({75.0, 70.0, 65.0, 60.0}), 2);
    motor.watch.duty(motor.now, 0.01, 0.02);
    EXPECT_EQ(motor.watch.wrong(), 0) << "nothing pushes any more";
    EXPECT_EQ(motor.see({55.0}), 0);
    motor.watch.duty(motor.now, 0.02, 0.02);
    EXPECT_EQ(motor.see({48.0, 41.0, 34.0}), 2);
    motor.watch.duty(motor.now, -0.06, 0.02);
    EXPECT_EQ(motor.watch.wrong(), 0);
}

TEST(MotionWatch, AMotorThatIsBrakedGoesOnButNotAFifthFaster)
{
    Pushed motor(0.06, {10.0, 0.0}); // 1280 counts/s
    EXPECT_EQ(motor.see({-12.0}), 0);
    EXPECT_EQ(motor.see({-24.5}), 1);
    EXPECT_EQ(motor.see({-36.9}), 1) << "slower than before";
    EXPECT_EQ(motor.see({-49.4}), 2);
}

TEST(MotionWatch, SamplesOfOneMomentTellNoSpeed)
{
    for (const double sign : {1.0, -1.0}) {
        Pushed motor(0.06 * sign);
        motor.see({0.0});
        motor.watch.position(motor.now, -15.0 * sign);
        EXPECT_EQ(motor.watch.wrong(), 0);
    }
}

/// Half waves of the error, one number each: growing() when the last begins.
int waves(OscillationWatch &watch, std::initializer_list<double> errors, double swing = 100.0, double noise = 0.0)
{
    for (const double error : errors)
        watch.error(error, swing, noise);
    return watch.growing();
}

TEST(OscillationWatch, CountsHalfWavesThatAreMoreThanATwentiethLargerThanTheOneBeforeOnTheirSide)
{
    OscillationWatch watch;
    EXPECT_EQ(waves(watch, {60.0}), 0);
    EXPECT_EQ(waves(watch, {-100.0}), 1);
    EXPECT_EQ(waves(watch, {63.1}), 2);
    EXPECT_EQ(waves(watch, {-105.0}), 3);
    EXPECT_EQ(waves(watch, {66.0}), 0) << "105 is exactly a twentieth more than 100";
    OscillationWatch small;
    EXPECT_EQ(waves(small, {0.05, -0.05, 0.06}, 0.2), 2);
    OscillationWatch within;
    EXPECT_EQ(waves(within, {5.0, -6.0}), 0) << "a twentieth of the swing";
    EXPECT_EQ(waves(within, {5.0}), 1);
    OscillationWatch noisy;
    EXPECT_EQ(waves(noisy, {60.0, -90.0}, 100.0, 60.0), 0);
    OscillationWatch touching;
    EXPECT_EQ(waves(touching, {60.0, 0.0}), 0) << "it is not through yet";
}

TEST(OscillationWatch, AHalfWaveThatTheTargetMadeByTurningCountsBeyondItsSwingOnly)
{
    OscillationWatch watch;
    EXPECT_EQ(waves(watch, {60.0, -60.0, 64.0, -64.0}), 3);
    watch.target(50.0);
    EXPECT_EQ(waves(watch, {70.0}), 4) << "the first target turned nothing";
    watch.target(100.0);
    EXPECT_EQ(waves(watch, {-70.0}), 0);
    EXPECT_EQ(waves(watch, {75.0}), 1);
    watch.target(200.0);
    EXPECT_EQ(waves(watch, {-80.0}), 2) << "further the same way";
    watch.target(100.0);
    watch.target(100.0);
    EXPECT_EQ(waves(watch, {80.0}), 0);
}

TEST(OscillationWatch, WhereTheDutyIsAtItsLimitAsLargeIsEnough)
{
    OscillationWatch watch;
    EXPECT_EQ(waves(watch, {60.0, -60.0, 60.0}), 2);
    watch.duty(start, -0.475, 0.5);
    EXPECT_EQ(waves(watch, {-60.0}), 3);
    EXPECT_EQ(waves(watch, {60.0}), 4) << "and in the half wave after it";
    EXPECT_EQ(waves(watch, {-60.0}), 0);
    OscillationWatch below;
    EXPECT_EQ(waves(below, {60.0, -60.0, 60.0}), 2);
    below.duty(start, 0.474, 0.5);
    EXPECT_EQ(waves(below, {-60.0}), 0);
    OscillationWatch smaller;
    EXPECT_EQ(waves(smaller, {60.0, -60.0, 57.0}), 2);
    smaller.duty(start, 0.5, 0.5);
    EXPECT_EQ(waves(smaller, {-60.0}), 0);
    OscillationWatch asLarge;
    EXPECT_EQ(waves(asLarge, {60.0, -60.0, 57.1}), 2);
    asLarge.duty(start, 0.5, 0.5);
    EXPECT_EQ(waves(asLarge, {-60.0}), 3);
}

TEST(OscillationWatch, TurnsOfMoreThanTheNoiseLastUntilTheTargetMoves)
{
    OscillationWatch watch;
    watch.target(0.0);
    waves(watch, {105.0, 100.0, 105.1});
    EXPECT_EQ(watch.lasting(), 1) << "a twentieth of the swing is no turn";
    waves(watch, {100.0, 105.1});
    EXPECT_EQ(watch.lasting(), 3);
    waves(watch, {95.0, 105.1}, 100.0, 20.0);
    EXPECT_EQ(watch.lasting(), 3);
    watch.target(0.0);
    EXPECT_EQ(watch.lasting(), 3);
    watch.target(1.0);
    EXPECT_EQ(watch.lasting(), 0);
}

TEST(OscillationWatch, BroadTurnsThatBecomeNoSmallerAreSustained)
{
    const auto after = [](double size, double share, int turns) {
        OscillationWatch watch;
        watch.target(0.0);
        for (int i = 0; i < turns; ++i) {
            waves(watch, {(i % 2 == 0 ? size : -size)});
            size *= share;
        }
        return watch;
    };
    EXPECT_EQ(after(15.1, 1.0, 14).sustained(), 12) << "15 % of the swing either way";
    EXPECT_EQ(after(14.9, 1.0, 14).sustained(), 0);
    EXPECT_GT(after(60.0, 0.9, 14).sustained(), 0);
    EXPECT_EQ(after(60.0, 0.8, 14).sustained(), 0) << "it comes to rest";
    OscillationWatch watch = after(20.0, 1.0, 14);
    watch.target(100.0);
    EXPECT_EQ(watch.sustained(), 0);
}

TEST(OscillationWatch, FlipsAreThoseOfMoreThanHalfTheDutyInASecond)
{
    OscillationWatch watch;
    watch.duty(start, 0.26, 0.5);
    EXPECT_EQ(watch.flips(), 0);
    watch.duty(start, -0.25, 0.5);
    EXPECT_EQ(watch.flips(), 0);
    watch.duty(start, -0.26, 0.5);
    EXPECT_EQ(watch.flips(), 1);
    watch.duty(start + 500ms, 0.26, 0.5);
    watch.duty(start + 1s, 0.0, 0.5);
    EXPECT_EQ(watch.flips(), 2);
    watch.duty(start + 1001ms, 0.0, 0.5);
    EXPECT_EQ(watch.flips(), 1);
}

TEST(LossWatch, FewerThanFortySamplesTellNothing)
{
    LossWatch loss;
    loss.add(start, 100, 5);
    loss.add(start + 500ms, 134, 10);
    EXPECT_EQ(loss.share(), 0.0);
    loss.add(start + 600ms, 135, 10);
    EXPECT_DOUBLE_EQ(loss.share(), 5.0 / 40.0 * 0.6);
}

TEST(LossWatch, OnePollAtTheBeginningIsNoTwentiethOfASecond)
{
    LossWatch loss;
    loss.add(start, 0, 0);
    loss.add(start + 150ms, 42, 3);
    EXPECT_LT(loss.share(), 0.05);
    loss.add(start + 400ms, 60, 60);
    EXPECT_GT(loss.share(), 0.05) << "half of them are";
}

TEST(LossWatch, IsThatOfTheLastSecond)
{
    LossWatch loss;
    loss.add(start, 0, 0);
    loss.add(start + 500ms, 50, 50);
    loss.add(start + 1s, 100, 50);
    EXPECT_DOUBLE_EQ(loss.share(), 50.0 / 150.0);
    loss.add(start + 1001ms, 100, 50);
    EXPECT_EQ(loss.share(), 0.0);
    loss.add(start + 5s, 100, 150);
    EXPECT_EQ(loss.share(), 0.0) << "nobody knows when in the four seconds";
}

} // namespace
} // namespace mb::tuning
