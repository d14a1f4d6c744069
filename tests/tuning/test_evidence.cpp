// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers that causes are told by, of trials whose curves are known.
#include "model/family.h"
#include "model/registry.h"
#include "tuning/evidence.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace mb::tuning {
namespace {

using Told = std::function<double(double)>;

const Family &shownFamily(std::string_view key)
{
    return **std::find_if(families().begin(), families().end(), [key](const Family *f) { return f->key == key; });
}

const Family &testedFamily()
{
    return shownFamily("dmc60c");
}

/// A hold of one second, samples each 5 ms from 0.3 s before it on.
Trial toldTrial(Mode mode, double to, const Told &position, const Told &velocity, const Told &duty)
{
    Trial trial;
    trial.mode = mode;
    trial.stimulus.to = to;
    trial.holds = {{0.0, 1.0}};
    trial.signals = {{"position", "counts", {}}, {"velocity", "counts/s", {}}, {"duty", "", {}}};
    const std::array<const Told *, 3> curves{&position, &velocity, &duty};
    for (int i = -60; i <= 200; ++i) {
        for (std::size_t k = 0; k < curves.size(); ++k)
            trial.signals[k].trace.add(0.005 * i, (*curves[k])(0.005 * i));
    }
    return trial;
}

double nothing(double)
{
    return 0.0;
}

void keep(Trial &trial, std::string_view channel, double from, double to)
{
    for (Signal &signal : trial.signals) {
        if (signal.channel == channel)
            signal.trace = signal.trace.part(from, to);
    }
}

/// Speeds up to 10 000 counts/s within 0.4 s, and tells it `late`.
Trial ramped(double late)
{
    const auto speed = [](double t) { return 25'000.0 * std::clamp(t, 0.0, 0.4); };
    const auto place = [](double t) {
        const double ramp = std::clamp(t, 0.0, 0.4);
        return 12'500.0 * ramp * ramp + 10'000.0 * std::max(t - 0.4, 0.0);
    };
    return toldTrial(
        Mode::Velocity, 10'000.0, place, [=](double t) { return speed(t - late); }, nothing);
}

TEST(Evidence, AVelocityIsLateByWhatItsMiddleComesAfterThatOfThePositions)
{
    EXPECT_NEAR(Evidence(testedFamily(), ramped(0.06)).velocityDelay().value_or(0.0), 0.06, 0.001);
    EXPECT_NEAR(Evidence(testedFamily(), ramped(0.0)).velocityDelay().value_or(1.0), 0.0, 0.001);
    for (const char *const channel : {"position", "velocity"}) {
        Trial few = ramped(0.06);
        keep(few, channel, 0.97, 2.0); // seven samples of one of them
        EXPECT_FALSE(Evidence(testedFamily(), few).velocityDelay()) << channel;
    }
    Trial silent = ramped(0.06);
    silent.signals.pop_back();
    silent.signals.pop_back();
    EXPECT_FALSE(Evidence(testedFamily(), silent).velocityDelay());
}

TEST(Evidence, TheDutyAtTheEndIsThatOfTheLastQuarterAndThatBeforeOfTheRest)
{
    const Told duty = [](double t) { return t < -0.2 ? 0.9 : t < -0.008 ? 0.02 : t < 0.7475 ? 0.8 : 0.3; };
    const Trial trial = toldTrial(Mode::Position, 100.0, nothing, nothing, duty);
    EXPECT_NEAR(Evidence(testedFamily(), trial).dutyAtEnd().value_or(0.0), 0.3, 1e-9);
    EXPECT_NEAR(Evidence(testedFamily(), trial).dutyBefore().value_or(0.0), 0.02, 1e-9);
    EXPECT_FALSE(Evidence(testedFamily(), {}).dutyAtEnd());
    const Trial left = toldTrial(
        Mode::Position, 100.0, [](double t) { return t < 0.74 ? 0.0 : 88.0; }, nothing, duty);
    EXPECT_NEAR(Evidence(testedFamily(), left).countsLeft().value_or(0.0), 12.0, 1e-9);
}

TEST(Evidence, TheTimeAtTheLimitIsThatWithNearlyAllThatIsAllowed)
{
    const Told duty = [](double t) { return t < 0.0 ? 0.0 : t < 0.2 ? -0.5 : t < 0.3 ? 0.495 : t < 0.4 ? 0.485 : 0.1; };
    Trial trial = toldTrial(
        Mode::Velocity, 1000.0, nothing, [](double t) { return t < 0.3 ? 400.0 : 900.0; }, duty);
    trial.envelope.duty = 0.5; // 0.49 is at it
    EXPECT_NEAR(Evidence(testedFamily(), trial).timeAtLimit(), 0.3, 0.0051);
    trial.envelope.duty.reset();
    EXPECT_EQ(Evidence(testedFamily(), trial).timeAtLimit(), 0.0);
    EXPECT_FALSE(Evidence(testedFamily(), trial).errorAfterLimit());
    trial.envelope.duty = 0.5;
    const double time = testedFamily().loop->velocityTime;
    EXPECT_NEAR(Evidence(testedFamily(), trial).errorAfterLimit().value_or(0.0), 100.0 * time, 2.0 * time);
    trial.mode = Mode::Position; // of the position, in counts
    EXPECT_NEAR(Evidence(testedFamily(), trial).errorAfterLimit().value_or(0.0), 1000.0, 1e-9);
    trial.signals.erase(trial.signals.begin());
    EXPECT_FALSE(Evidence(testedFamily(), trial).errorAfterLimit());
}

TEST(Evidence, MotionBeginsWithThreeCountsAndWithTheDutyOfThatTime)
{
    const Told place = [](double t) { return 7.0 + std::floor(100.0 * std::max(t, 0.0) + 1e-6); };
    const Told duty = [](double t) { return 2.0 * t; };
    const auto began = Evidence(testedFamily(), toldTrial(Mode::Position, 100.0, place, nothing, duty)).startOfMotion();
    ASSERT_TRUE(began);
    EXPECT_NEAR(began->time, 0.03, 1e-9);
    EXPECT_NEAR(began->duty, 0.06, 1e-9);
    const auto idle = [](double t) { return 0.15 * t; }; // 0.0045 is no duty
    EXPECT_FALSE(Evidence(testedFamily(), toldTrial(Mode::Position, 1.0, place, nothing, idle)).startOfMotion());
    EXPECT_FALSE(Evidence(testedFamily(), toldTrial(Mode::Position, 1.0, nothing, nothing, duty)).startOfMotion());
    EXPECT_FALSE(Evidence(testedFamily(), {}).startOfMotion());
}

TEST(Evidence, ASwingIsWhatThePositionGoesInTheSecondHalfAndTheTurnsOfItsDuty)
{
    const Told place = [](double t) { return t < 0.49 ? 1000.0 : std::lround(200.0 * t) % 2 == 0 ? 3.0 : -4.0; };
    const Told duty = [](double t) {
        const long part = std::lround(std::floor(10.0 * t + 1e-6));
        return t < 0.49 ? 0.0 : std::lround(200.0 * t) % 3 == 0 ? 0.004 : part % 2 == 0 ? 0.1 : -0.1;
    };
    const auto swing = Evidence(testedFamily(), toldTrial(Mode::Position, 0.0, place, nothing, duty)).swingAtEnd();
    ASSERT_TRUE(swing);
    EXPECT_NEAR(swing->counts, 7.0, 1e-9);
    EXPECT_EQ(swing->turns, 5); // at 0.6, 0.7, 0.8, 0.9, 1.0 s
    EXPECT_FALSE(Evidence(testedFamily(), {}).swingAtEnd());
}

TEST(Evidence, AVelocityIsHeldAsLongAsItsMedianStaysNearlyTwoSamplesAtLeast)
{
    const auto heldFor = [](double seconds) {
        Trial trial = toldTrial(
            Mode::Velocity, 1000.0, nothing, [=](double t) { return 100.0 * std::floor(t / seconds + 1e-6); }, nothing);
        trial.metrics.rise = 0.1; // looked at over three times that
        return Evidence(testedFamily(), trial).velocityHold();
    };
    EXPECT_NEAR(heldFor(0.03).value_or(0.0), 0.03, 1e-6);
    EXPECT_NEAR(heldFor(0.09).value_or(0.0), 0.09, 1e-6) << "three changes";
    EXPECT_FALSE(heldFor(0.11));
    EXPECT_FALSE(heldFor(0.005));
    EXPECT_NEAR(heldFor(0.01).value_or(0.0), 0.01, 1e-6);
}

TEST(Evidence, WhatItsGainsMakeIsToldInDuty)
{
    const LoopScale &scale = *testedFamily().loop;
    Trial trial = toldTrial(
        Mode::Velocity, 1000.0, nothing, [](double) { return 900.0; }, [](double) { return 0.25; });
    trial.stimulus.from = 200.0;
    trial.gains = {{"slot0.p", 1.5}, {"slot0.f", 0.5}, {"slot0.d", 3.0}, {"slot0.ramp", 2.0}};
    const Evidence evidence(testedFamily(), trial);
    EXPECT_NEAR(evidence.demandOfStep().value_or(0.0), 1.5 * 800.0 * scale.velocityTime / scale.fullDuty, 1e-12);
    EXPECT_NEAR(
        evidence.feedForwardTimesGain().value_or(0.0), 0.5 * scale.velocityTime / scale.fullDuty * 900.0 / 0.25, 1e-12);
    EXPECT_FALSE(evidence.leapOfOneCount()) << "of a velocity a count is no step";
    EXPECT_NEAR(evidence.rampTime().value_or(0.0), scale.period * scale.fullDuty / 2.0, 1e-12);
    Trial still = toldTrial(
        Mode::Velocity, 1000.0, nothing, [](double) { return 900.0; }, [](double) { return 0.004; });
    still.gains = trial.gains;
    EXPECT_FALSE(Evidence(testedFamily(), still).feedForwardTimesGain()) << "that duty is none";
    Trial untold = trial;
    keep(untold, "velocity", -1.0, 0.0);
    EXPECT_FALSE(Evidence(testedFamily(), untold).feedForwardTimesGain()) << "nobody told how fast it went";
    trial.mode = Mode::Position;
    EXPECT_NEAR(Evidence(testedFamily(), trial).leapOfOneCount().value_or(0.0), 3.0 / scale.fullDuty, 1e-12);
    EXPECT_NEAR(Evidence(testedFamily(), trial).demandOfStep().value_or(0.0), 1.5 * 800.0 / scale.fullDuty, 1e-12);
    const Family &timed = shownFamily("abstractdc"); // its D counts in ms, and its loop runs every 20
    Trial other = trial;
    other.gains = {{"position.d", 30.0}, {"position.divisor", 10.0}};
    EXPECT_NEAR(Evidence(timed, other).leapOfOneCount().value_or(0.0),
        3.0 / timed.loop->fullDuty * timed.loop->period / timed.loop->cycle, 1e-12);
    EXPECT_LT(timed.loop->period, 0.1 * timed.loop->cycle);
    trial.gains.clear();
    const Evidence none(testedFamily(), trial);
    EXPECT_FALSE(none.demandOfStep());
    EXPECT_FALSE(none.feedForwardTimesGain());
    EXPECT_FALSE(none.rampTime());
    EXPECT_FALSE(none.leapOfOneCount());
}

} // namespace
} // namespace mb::tuning
