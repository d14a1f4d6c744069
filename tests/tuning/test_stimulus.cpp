// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiment/stimulus.h"
#include "model/family.h"
#include "tests/tuning/experimentbench.h"
#include "tests/tuning/realunit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <tuple>
#include <vector>

namespace mb::tuning {
namespace {

using namespace std::chrono_literals;

constexpr double beat = 0.02;

Stimulus madeStimulus(Profile profile, std::optional<double> seconds = {}, double from = -100.0, double to = 300.0)
{
    const auto stimulus = Stimulus::make(profile, from, to, seconds, beat);
    EXPECT_TRUE(stimulus) << (stimulus ? "" : stimulus.error().text());
    return stimulus.value_or(Stimulus());
}

TEST(Stimulus, EveryProfileStartsAndEndsWhereItCameFromAndStaysBetween)
{
    for (const Profile profile :
        {Profile::Step, Profile::Square, Profile::Ramp, Profile::Sine, Profile::Chirp, Profile::Prbs}) {
        const Stimulus stimulus = madeStimulus(profile);
        EXPECT_EQ(profileFromString(toString(profile)), profile);
        EXPECT_EQ(stimulus.at(-0.001), -100.0) << toString(profile);
        EXPECT_EQ(stimulus.at(stimulus.length()), -100.0) << toString(profile);
        double most = -1e9;
        for (double t = 0.0; t < stimulus.length(); t += 0.001) {
            EXPECT_GE(stimulus.at(t), -100.0 - 1e-9) << toString(profile) << t;
            most = std::max(most, stimulus.at(t));
        }
        EXPECT_NEAR(most, 300.0, 0.01) << toString(profile);
    }
    EXPECT_FALSE(profileFromString("steps"));
}

TEST(Stimulus, HasTheTimesOfTheRulesUnlessToldOtherwise)
{
    EXPECT_DOUBLE_EQ(madeStimulus(Profile::Sine).time, 6.0);
    EXPECT_DOUBLE_EQ(madeStimulus(Profile::Sine).period, 1.0);
    EXPECT_DOUBLE_EQ(madeStimulus(Profile::Square).period, 2.0);
    EXPECT_DOUBLE_EQ(madeStimulus(Profile::Chirp).time, 30.0);
    EXPECT_DOUBLE_EQ(madeStimulus(Profile::Chirp).high, 5.0); // 0.1/Ts of 20 ms
    EXPECT_DOUBLE_EQ(Stimulus::make(Profile::Chirp, 0.0, 1.0, {}, 0.001)->high, 15.0);
    EXPECT_DOUBLE_EQ(madeStimulus(Profile::Prbs).period, 0.125);
    EXPECT_TRUE(madeStimulus(Profile::Step).ends);
    EXPECT_FALSE(madeStimulus(Profile::Step, 2.0).ends);
    EXPECT_DOUBLE_EQ(madeStimulus(Profile::Step, 2.0).length(), 2.0);
}

TEST(Stimulus, TheChirpSweepsFromItsFirstToItsLastFrequency)
{
    const Stimulus chirp = madeStimulus(Profile::Chirp, {}, -1.0, 1.0);
    const auto crossings = [&chirp](double from, double to) {
        int count = 0;
        for (double t = from; t < to; t += 1e-4)
            count += (chirp.at(t) < 0.0) != (chirp.at(t + 1e-4) < 0.0) ? 1 : 0;
        return count;
    };
    EXPECT_NEAR(crossings(29.0, 29.9), 2 * 5.0 * 0.9, 2.0);
    EXPECT_LE(crossings(0.0, 4.0), 1);
}

TEST(Stimulus, TheBitsOfThePrbsAreAMaximalSequence)
{
    int ones = 0;
    std::set<int> windows;
    for (int i = 0; i < 127; ++i) {
        ones += prbsBit(i) ? 1 : 0;
        int window = 0;
        for (int k = 0; k < 7; ++k)
            window = window * 2 + (prbsBit(i + k) ? 1 : 0);
        windows.insert(window);
        EXPECT_EQ(prbsBit(i), prbsBit(i + 127));
    }
    EXPECT_EQ(ones, 64);
    EXPECT_EQ(windows.size(), 127U);
}

TEST(Stimulus, EdgesAreWhereTheTargetJumpsToItsGoal)
{
    EXPECT_EQ(madeStimulus(Profile::Step).edges(), (std::vector<double>{0.0}));
    EXPECT_EQ(madeStimulus(Profile::Square).edges(), (std::vector<double>{0.0, 2.0}));
    EXPECT_TRUE(madeStimulus(Profile::Sine).edges().empty());
}

TEST(Stimulus, FinerThanTheDeviceTakesSetPointsIsRefusedWithTheNumbers)
{
    struct Row {
        Profile profile;
        double seconds;
        std::string_view number;
    };
    constexpr Row rows[] = {
        {Profile::Step, 0.03, "30 ms"},
        {Profile::Ramp, 0.03, "30 ms"},
        {Profile::Square, 0.1, "25 ms"},
        {Profile::Sine, 0.6, "100 ms"},
        {Profile::Prbs, 2.54, "20 ms"},
        {Profile::Chirp, 5.0, "10 s"},
    };
    for (const Row &row : rows) {
        const auto stimulus = Stimulus::make(row.profile, 0.0, 1.0, row.seconds, beat);
        ASSERT_FALSE(stimulus) << toString(row.profile);
        EXPECT_EQ(stimulus.error().fault, Fault::OutOfRange);
        EXPECT_NE(stimulus.error().text().find(row.number), std::string::npos) << stimulus.error().detail;
    }
    EXPECT_TRUE(Stimulus::make(Profile::Step, 0.0, 1.0, 0.05, beat));
}

/// Of a profile that this program leads, at every phase of its set-points against the loop's passes.
TEST(Stimulus, ARampIsNoOscillationOfTheLoopOnAnyFamily)
{
    for (const auto &[link, name, address, to] :
        {std::tuple{"sim:can", "dmc60c", 5, 150'000.0}, std::tuple{"sim:can", "abstractdc", 3, 10'000.0},
            std::tuple{"sim:spi", "quadquad2drv", 0, 2000.0}, std::tuple{"sim:serial", "supermodified", 4, 20'000.0},
            std::tuple{"sim:serial", "supermodified", 5, 2000.0}}) {
        test::ExperimentBench bench(link, name, address);
        const Family &family = bench.device->family();
        EXPECT_LE(family.trials->glideBeat, family.capabilities.commandPeriod);
        ExperimentPlan plan = test::stepTo(Mode::Position, to);
        plan.from = 0.0;
        plan.profile = Profile::Ramp;
        plan.seconds = 1.5;
        for (int phase = 0; phase < 10; ++phase) {
            bench.bench.clock.advance(2s + phase * 2ms);
            const auto trial = bench.run(plan);
            ASSERT_TRUE(trial) << trial.error().text();
            EXPECT_EQ(trial->reason, tuning::EndReason::Done) << name << ": " << trial->detail;
        }
    }
}

/// After which the set-points that were missed are not sent all at once.
TEST(Stimulus, ARampGoesOnWithItsNewestSetPointWhereTheProgramWasHeldUp)
{
    test::RealUnit unit; // a simulated one waits for a program that is held up
    SetPointStream stream(*unit.device, unit.dated);
    ExperimentPlan plan = test::stepTo(Mode::Duty, 0.3);
    plan.profile = Profile::Ramp;
    plan.limits = {.travel = 1e7, .speed = 1e6, .current = 100.0, .duty = 0.6};
    const Subscription sent = stream.changed().add([&unit] { unit.clock.stall(20us); }); // it takes a moment
    stream.renew();
    auto task = runExperiment(*unit.device, stream, plan, {});
    task.start();
    const auto passes
        = [&](const auto &reached) { return unit.clock.runUntil([&] { return stream.renew(), reached(); }, 10s); };
    ASSERT_TRUE(passes([&] { return stream.isRunning() && stream.setPoint().target > 0.1; }));
    unit.clock.stall(60ms);
    ASSERT_TRUE(passes([&] { return task.isFinished(); }));
    ASSERT_TRUE(task.result()) << task.result().error().text();
    ASSERT_EQ(task.result()->reason, tuning::EndReason::Done) << task.result()->detail;
    const std::vector<double> told = task.result()->signal("setpoint")->trace.t;
    EXPECT_GT(told.size(), 300U) << "every 5 ms";
    for (std::size_t i = 2; i < told.size(); ++i)
        EXPECT_GT(told[i] - told[i - 2], 0.002) << "besides what keeps it alive";
}

} // namespace
} // namespace mb::tuning
