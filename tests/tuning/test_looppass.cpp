// SPDX-License-Identifier: GPL-3.0-or-later
// An Abstract DC Drive tells no version of its firmware: what its constants are taken for is looked at.
#include "tests/tuning/tuningbench.h"
#include "tuning/looppass.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

namespace mb::tuning {
namespace {

using test::ExperimentBench;
using test::planOf;
using test::tune;

TunePlan keeping(Mode loop)
{
    TunePlan plan = planOf(loop);
    plan.keep = true;
    return plan;
}

const Gate *periodOf(const TuneReport &report)
{
    const auto found = std::find_if(
        report.gates.begin(), report.gates.end(), [](const Gate &gate) { return gate.name == "period"; });
    return found == report.gates.end() ? nullptr : &*found;
}

/// A velocity that rises for half a second and is taken anew every `pass`, told every 10 ms and a little off.
Trial risen(double pass)
{
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> off(-0.001, 0.001);
    Trial trial;
    trial.mode = Mode::Velocity;
    trial.stimulus = *Stimulus::make(Profile::Step, 0.0, 8000.0, 1.0, 0.02);
    trial.holds = {{0.0, 1.0}};
    Signal velocity{"velocity", "counts/s", {}};
    for (double t = 0.0; t < 1.0; t += 0.01) {
        const double at = std::max(t + off(random), 0.0);
        const double taken = std::floor(at / pass) * pass;
        velocity.trace.add(at, std::round(8000.0 * (1.0 - std::exp(-taken / 0.25))));
    }
    trial.signals.push_back(std::move(velocity));
    return trial;
}

TEST(LoopPass, IsSeenInAVelocityThatIsTakenAnewAtEach)
{
    for (const double pass : {0.02004, 0.0334, 0.05}) {
        const auto seen = passOf(risen(pass));
        ASSERT_TRUE(seen) << pass;
        std::printf("%.2f ms: seen %.2f ms\n", 1e3 * pass, 1e3 * *seen);
        EXPECT_NEAR(*seen, pass, 0.06 * pass);
    }
    EXPECT_FALSE(passOf(Trial()));
}

TEST(LoopPass, IsSeenWhereManyPassesTellTheSameAgain)
{
    Trial trial = risen(0.02004);
    Trace &velocity = trial.signals.front().trace;
    double told = velocity.y.front();
    double taken = told;
    int pass = 0;
    for (double &y : velocity.y) { // as those of a few counts do
        if (y != taken)
            ++pass;
        taken = y;
        if (pass % 6 != 3 && pass % 6 != 5)
            told = y;
        y = told;
    }
    trial.holds.resize(3, trial.holds.front());
    const auto seen = passOf(trial);
    ASSERT_TRUE(seen);
    EXPECT_NEAR(*seen, 0.02004, 0.15 * 0.02004);
}

TEST(LoopPass, AVelocityLoopIsKeptWithTheNumberThatItsPassWasSeenToHave)
{
    ExperimentBench bench("sim:can", "abstractdc", 3);
    const auto report = tune(bench, keeping(Mode::Velocity));
    ASSERT_TRUE(report) << report.error().text();
    EXPECT_EQ(report->result, TuneResult::Kept) << report->evidence;
    const Gate *const gate = periodOf(*report);
    ASSERT_NE(gate, nullptr);
    std::printf("%s\n", gate->detail.english().c_str());
    EXPECT_TRUE(gate->passed);
}

TEST(LoopPass, ABuildThatRunsItsLoopAtAnotherPeriodIsRefusedWithTheNumber)
{
    for (const double pass : {0.01, 0.04}) {
        ExperimentBench bench("sim:can", "abstractdc", 3);
        ASSERT_TRUE(bench.simulator()->disturb("loop-period", pass));
        const auto report = tune(bench, keeping(Mode::Velocity));
        ASSERT_TRUE(report) << report.error().text();
        std::printf("%.0f ms: %s, %s\n", 1e3 * pass, std::string(toString(report->result)).c_str(),
            report->evidence.english().c_str());
        EXPECT_EQ(report->result, TuneResult::Refused);
        const Gate *const gate = periodOf(*report);
        ASSERT_NE(gate, nullptr);
        EXPECT_FALSE(gate->passed);
        EXPECT_NE(report->evidence.english().find("20 ms was expected"), std::string::npos) << report->evidence;
        EXPECT_TRUE(report->stopped);
    }
}

TEST(LoopPass, SamplesThatComeNoMoreOftenThanThePassesTellNothing)
{
    const ExperimentBench bench("sim:can", "abstractdc", 3);
    Trial trial = risen(0.02004);
    const auto gate = passGate(bench.device->family(), trial);
    ASSERT_TRUE(gate);
    EXPECT_TRUE(gate->passed) << gate->detail;
    Trace &velocity = trial.signals.front().trace;
    Trace seldom;
    for (std::size_t i = 0; i < velocity.size(); i += 3)
        seldom.add(velocity.t[i], velocity.y[i]);
    velocity = seldom;
    EXPECT_FALSE(passGate(bench.device->family(), trial));
}

TEST(LoopPass, OtherFamiliesAreNotAsked)
{
    ExperimentBench bench("sim:can", "dmc60c", 5);
    const auto report = tune(bench, planOf(Mode::Velocity));
    ASSERT_TRUE(report) << report.error().text();
    EXPECT_EQ(periodOf(*report), nullptr);
}

TEST(LoopPass, ADThatActsTheOtherWayRoundIsNamedByTheFirstPositionThatSwings)
{
    ExperimentBench bench("sim:can", "abstractdc", 3);
    ASSERT_TRUE(bench.simulator()->disturb("derivative-inverted", 1.0));
    const auto report = tune(bench, keeping(Mode::Position));
    ASSERT_TRUE(report) << report.error().text();
    std::printf("%s, %s: %s\n", std::string(toString(report->result)).c_str(),
        std::string(toString(report->stopReason)).c_str(), report->evidence.english().c_str());
    EXPECT_TRUE(report->result != TuneResult::Kept || report->measured.overshoot.value_or(1.0) <= 0.075);
    EXPECT_NE(report->evidence.english().find("its D acts the other way round"), std::string::npos);
    EXPECT_TRUE(report->stopped);
    EXPECT_FALSE(bench.simulator()->isOutputOn());
}

} // namespace
} // namespace mb::tuning
