// SPDX-License-Identifier: GPL-3.0-or-later
// Each cause from a trial that was made to have it, with its number and the value to try; a good trial has none.
#include "tuning/adviser.h"

#include "model/family.h"
#include "model/registry.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace mb::tuning {
namespace {

const Family &familyOf(std::string_view key)
{
    return **std::find_if(families().begin(), families().end(), [key](const Family *f) { return f->key == key; });
}

using Curve = std::function<double(double)>;

constexpr double period = 0.005;
constexpr double hold = 1.0;

/// A trial with these curves, t = 0 at the edge.
Trial made(Mode mode, double to, const Curve &position, const Curve &velocity, const Curve &duty)
{
    Trial trial;
    trial.mode = mode;
    trial.stimulus.profile = Profile::Step;
    trial.stimulus.to = to;
    trial.stimulus.time = hold;
    trial.envelope.duty = 1.0;
    trial.holds = {{0.0, hold}};
    trial.returns = {{hold, 2.0 * hold}};
    trial.reason = tuning::EndReason::Done;
    Signal positions{"position", "counts", {}};
    Signal velocities{"velocity", "counts/s", {}};
    Signal duties{"duty", "fraction", {}};
    for (int i = -60; i <= 200; ++i) {
        const double t = i * period;
        positions.trace.add(t, std::round(position(t)));
        velocities.trace.add(t, velocity(t));
        duties.trace.add(t, duty(t));
    }
    trial.signals = {positions, velocities, duties};
    return trial;
}

/// First-order velocity loop to 60 000 counts/s with 50 ms, duty 30 % at its end.
Trial velocityStep(double late = 0.0)
{
    const auto rising = [](double t) { return t <= 0.0 ? 0.0 : 1.0 - std::exp(-t / 0.05); };
    const auto position = [](double t) { return t <= 0.0 ? 0.0 : 60'000.0 * (t - 0.05 * (1.0 - std::exp(-t / 0.05))); };
    Trial trial = made(
        Mode::Velocity, 60'000.0, position, [=](double t) { return 60'000.0 * rising(t - late); },
        [](double t) { return t < 0.0 ? 0.0 : 0.3 + 0.2 * std::exp(-t / 0.05); });
    trial.gains = {{"slot0.p", 1.2}, {"slot0.i", 0.004}, {"slot0.d", 0.0}, {"slot0.i_zone", 0.0}, {"slot0.f", 0.0},
        {"slot0.allowable_error", 0.0}, {"slot0.ramp", 0.0}, {"slot0.nominal_forward", 0.0},
        {"slot0.nominal_reverse", 0.0}};
    trial.metrics.rise = 0.11;
    trial.metrics.overshoot = 0.0;
    return trial;
}

/// Position loop to 1000 counts with 50 ms that stays where it is told, at rest without duty.
Trial positionStep(double end = 1000.0)
{
    const auto position = [end](double t) { return t <= 0.0 ? 0.0 : end * (1.0 - std::exp(-t / 0.05)); };
    Trial trial = made(
        Mode::Position, 1000.0, position, [](double t) { return t <= 0.0 ? 0.0 : 20'000.0 * std::exp(-t / 0.05); },
        [](double t) { return t < 0.0 ? 0.0 : 0.3 * std::exp(-t / 0.05); });
    trial.gains = velocityStep().gains;
    trial.gains[1].second = 0.0;
    trial.metrics.rise = 0.11;
    trial.metrics.overshoot = 0.0;
    return trial;
}

void set(Trial &trial, std::string_view name, double value)
{
    for (auto &[key, number] : trial.gains) {
        if (key.ends_with(name))
            number = value;
    }
}

void replace(Trial &trial, std::string_view channel, const Curve &curve)
{
    for (Signal &signal : trial.signals) {
        for (std::size_t i = 0; signal.channel == channel && i < signal.trace.size(); ++i)
            signal.trace.y[i] = curve(signal.trace.t[i]);
    }
}

const Advice *find(const std::vector<Advice> &all, Cause cause)
{
    const auto found = std::find_if(all.begin(), all.end(), [cause](const Advice &a) { return a.cause == cause; });
    return found == all.end() ? nullptr : &*found;
}

std::vector<Advice> adviseOn(const Trial &trial)
{
    return advise(familyOf("dmc60c"), trial);
}

double changeOf(const Advice &advice, std::string_view key)
{
    for (const auto &[name, value] : advice.changes) {
        if (name == key)
            return value;
    }
    return std::nan("");
}

TEST(Adviser, HasNothingToSayAboutAGoodTrialOrAnUnknownOne)
{
    EXPECT_TRUE(adviseOn(velocityStep()).empty());
    EXPECT_TRUE(adviseOn(positionStep()).empty());
    EXPECT_TRUE(adviseOn(Trial()).empty());
    Trial chirp = velocityStep();
    chirp.stimulus.profile = Profile::Chirp;
    set(chirp, ".ramp", 1.0);
    EXPECT_TRUE(adviseOn(chirp).empty());
}

TEST(Adviser, FeedForwardWithAnIntegralIsNamedWithItsProduct)
{
    Trial trial = velocityStep();
    trial.metrics.overshoot = 0.18;
    const double exact = 0.3 * 32767.0 / (60'000.0 * 0.1); // throttle for a count/100 ms at 30 %
    set(trial, ".f", 0.9 * exact);
    const auto all = adviseOn(trial);
    const Advice *advice = find(all, Cause::FeedForward);
    ASSERT_NE(advice, nullptr);
    EXPECT_NEAR(advice->number, 0.9, 0.01);
    EXPECT_EQ(changeOf(*advice, "slot0.f"), 0.0);
    set(trial, ".i", 0.0); // then it is what it is meant to be
    EXPECT_EQ(find(adviseOn(trial), Cause::FeedForward), nullptr);
}

TEST(Adviser, DeadbandIsWhatPAloneLeavesWhileItPushes)
{
    Trial trial = positionStep(985.0);
    replace(trial, "duty", [](double t) { return t < 0.0 ? 0.0 : 0.3 * std::exp(-t / 0.05) + 0.018; });
    const auto all = adviseOn(trial);
    const Advice *advice = find(all, Cause::Deadband);
    ASSERT_NE(advice, nullptr);
    EXPECT_NEAR(advice->number, 15.0, 0.5);
    EXPECT_NEAR(changeOf(*advice, "slot0.nominal_forward"), 1.25 * 0.018 * 32767.0, 5.0);
    set(trial, ".i", 0.01);
    EXPECT_EQ(find(adviseOn(trial), Cause::Deadband), nullptr);
}

TEST(Adviser, ResolutionCountsTheStepsOfAGainAndKeepsTheLoopWhereThereIsADivisor)
{
    Trial trial = velocityStep();
    set(trial, ".i", 0.0005); // 65536 steps for 1: 33 of them
    const auto all = adviseOn(trial);
    const Advice *advice = find(all, Cause::Resolution);
    ASSERT_NE(advice, nullptr);
    EXPECT_NEAR(advice->number, 0.0005 * 65536.0, 0.5);
    EXPECT_TRUE(advice->changes.empty());
    Trial divided = velocityStep();
    divided.gains = {{"velocity.p", 800.0}, {"velocity.i", 4.0}, {"velocity.d", 0.0}, {"velocity.divisor", 1000.0}};
    const auto other = advise(familyOf("abstractdc"), divided);
    const Advice *finer = find(other, Cause::Resolution);
    ASSERT_NE(finer, nullptr);
    EXPECT_EQ(finer->number, 4.0);
    EXPECT_EQ(changeOf(*finer, "velocity.i"), 40.0);
    EXPECT_EQ(changeOf(*finer, "velocity.divisor"), 10'000.0);
}

TEST(Adviser, DNoiseIsTheLeapOfOneCount)
{
    Trial trial = positionStep();
    set(trial, ".d", 0.25 * 32767.0);
    const auto all = adviseOn(trial);
    const Advice *advice = find(all, Cause::DerivativeNoise);
    ASSERT_NE(advice, nullptr);
    EXPECT_NEAR(advice->number, 0.25, 1e-9);
    EXPECT_NEAR(changeOf(*advice, "slot0.d"), 3276.7, 0.1);
}

TEST(Adviser, ARampOfTheDriveIsNamedWithItsTime)
{
    Trial trial = velocityStep();
    set(trial, ".ramp", 40.0); // 0.5 ms × 32767 / 40
    const auto all = adviseOn(trial);
    const Advice *advice = find(all, Cause::Ramp);
    ASSERT_NE(advice, nullptr);
    EXPECT_NEAR(advice->number, 0.41, 0.001);
    EXPECT_EQ(changeOf(*advice, "slot0.ramp"), 0.0);
}

TEST(Adviser, SaturationWithoutOvershootAsksForLessOfTheSameLoop)
{
    Trial trial = velocityStep();
    trial.envelope.duty = 0.5;
    set(trial, ".p", 32767.0 / 6000.0); // 100 % duty at the edge
    replace(trial, "duty", [](double t) { return t < 0.0 ? 0.0 : t < 0.1 ? 0.5 : 0.3; });
    const auto all = adviseOn(trial);
    const Advice *advice = find(all, Cause::Saturation);
    ASSERT_NE(advice, nullptr);
    EXPECT_NEAR(advice->number, 0.1, 0.006);
    EXPECT_NEAR(changeOf(*advice, "slot0.p"), 0.5 * 32767.0 / 6000.0, 1e-6);
    EXPECT_NEAR(changeOf(*advice, "slot0.i"), 0.002, 1e-9);
    EXPECT_EQ(find(all, Cause::Windup), nullptr);
}

TEST(Adviser, WindupIsSaturationThatWasPaidBack)
{
    Trial trial = velocityStep();
    trial.envelope.duty = 0.5;
    trial.metrics.overshoot = 0.2;
    replace(trial, "duty", [](double t) { return t < 0.0 ? 0.0 : t < 0.1 ? 0.5 : 0.3; });
    const auto all = adviseOn(trial);
    const Advice *advice = find(all, Cause::Windup);
    ASSERT_NE(advice, nullptr);
    EXPECT_NEAR(advice->number, 0.1, 0.006);
    EXPECT_NEAR(changeOf(*advice, "slot0.i_zone"), std::round(6000.0 * std::exp(-2.0)), 60.0);
    EXPECT_EQ(find(all, Cause::Saturation), nullptr);
}

TEST(Adviser, AVelocityThatIsLateIsNamedWithItsDelay)
{
    Trial trial = velocityStep(0.05);
    trial.metrics.overshoot = 0.2;
    const auto all = adviseOn(trial);
    const Advice *advice = find(all, Cause::FilterDelay);
    ASSERT_NE(advice, nullptr);
    EXPECT_NEAR(advice->number, 0.05, 0.006);
    EXPECT_NEAR(changeOf(*advice, "slot0.p"), 1.2 * 0.6, 1e-9);
    EXPECT_EQ(find(all, Cause::BlockVelocity), nullptr);
}

TEST(Adviser, ALateVelocityIsNoCauseOfATrialThatIsSluggish)
{
    Trial trial = velocityStep(0.05);
    trial.metrics.overshoot = 0.002;
    EXPECT_EQ(find(adviseOn(trial), Cause::FilterDelay), nullptr);
}

TEST(Adviser, AVelocityInBlocksIsNamedWithTheirLength)
{
    Trial trial = velocityStep();
    trial.metrics.overshoot = 0.2;
    trial.metrics.rise = 0.3;
    replace(trial, "velocity", [](double t) {
        const double last = std::floor(t / 0.1) * 0.1;
        return last <= 0.0 ? 0.0 : 60'000.0 * (1.0 - std::exp(-last / 0.2));
    });
    const auto all = adviseOn(trial);
    const Advice *advice = find(all, Cause::BlockVelocity);
    ASSERT_NE(advice, nullptr);
    EXPECT_NEAR(advice->number, 0.1, 0.006);
    EXPECT_EQ(find(all, Cause::FilterDelay), nullptr);
}

TEST(Adviser, FrictionIsTheDutyAtWhichAMotorBegins)
{
    Trial trial = velocityStep();
    const auto start = [](double t) { return t - 0.15; };
    replace(trial, "position", [&](double t) { return start(t) <= 0.0 ? 0.0 : 60'000.0 * start(t); });
    replace(trial, "velocity", [&](double t) { return start(t) <= 0.0 ? 0.0 : 60'000.0; });
    replace(trial, "duty", [](double t) { return t < 0.0 ? 0.0 : std::min(0.3, 0.6 * t); });
    const auto all = adviseOn(trial);
    const Advice *advice = find(all, Cause::Friction);
    ASSERT_NE(advice, nullptr);
    EXPECT_NEAR(advice->number, 0.09, 0.01);
    EXPECT_NEAR(changeOf(*advice, "slot0.nominal_forward"), 1.25 * 0.09 * 32767.0, 450.0);
    EXPECT_LT(changeOf(*advice, "slot0.nominal_reverse"), 0.0);
}

TEST(Adviser, GravityIsADutyThatHoldsBothPlaces)
{
    Trial trial = positionStep();
    replace(trial, "duty", [](double t) { return t < 0.0 ? 0.08 : 0.3 * std::exp(-t / 0.05) + 0.08; });
    const auto all = adviseOn(trial);
    const Advice *advice = find(all, Cause::Gravity);
    ASSERT_NE(advice, nullptr);
    EXPECT_NEAR(advice->number, 0.08, 0.002);
    EXPECT_NEAR(changeOf(*advice, "slot0.i"), 1.2 * 500e-6 / (4.0 * 0.11), 1e-6);
}

TEST(Adviser, BacklashIsASwingThatNeverEnds)
{
    Trial trial = positionStep();
    set(trial, ".i", 0.01);
    replace(trial, "position", [](double t) {
        return t <= 0.0 ? 0.0 : std::round(1000.0 * (1.0 - std::exp(-t / 0.05)) + 6.0 * std::sin(2.0 * M_PI * 8.0 * t));
    });
    replace(trial, "duty", [](double t) { return t < 0.0 ? 0.0 : 0.05 * std::cos(2.0 * M_PI * 8.0 * t); });
    const auto all = adviseOn(trial);
    const Advice *advice = find(all, Cause::Backlash);
    ASSERT_NE(advice, nullptr);
    EXPECT_NEAR(advice->number, 12.0, 1.0);
    EXPECT_NEAR(changeOf(*advice, "slot0.allowable_error"), 6.0, 1.0);
}

TEST(Adviser, TheWeightiestCauseComesFirst)
{
    Trial trial = velocityStep();
    set(trial, ".ramp", 4.0); // 4 s
    set(trial, ".i", 0.0007); // 46 steps
    const auto all = adviseOn(trial);
    ASSERT_EQ(all.size(), 2U);
    EXPECT_EQ(all.front().cause, Cause::Ramp);
    EXPECT_EQ(all.back().cause, Cause::Resolution);
}

} // namespace
} // namespace mb::tuning
