// SPDX-License-Identifier: GPL-3.0-or-later
// A battery of steps on every family in virtual time: what it says, what ends it, and that each step puts back what it tried.
#include "experiment/battery.h"
#include "model/loopparameters.h"
#include "tests/tuning/knownunit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace mb::test {
namespace {

using namespace std::chrono_literals;

struct BatteryCase {
    const char *family;
    Mode loop;
    double largest;
};

void PrintTo(const BatteryCase &test, std::ostream *out)
{
    *out << test.family << ' ' << toString(test.loop);
}

class BatteryOf : public testing::TestWithParam<BatteryCase> {
protected:
    BatteryOf()
        : unit(cellOfLoop(GetParam().family, GetParam().loop))
    {
        plan.mode = GetParam().loop;
        plan.to = here() + GetParam().largest;
        const Family &family = unit.device().family();
        const LoopGains &loop = *loopOf(family, plan.mode);
        const ParameterIndex p = loopParameters(family, loop, 1, 0).front();
        for (const auto &[key, raw] : unit.before) {
            if (unit.index(key).value == p.value && raw)
                plan.gains = {{p, std::llround(0.9 * static_cast<double>(*raw))}};
        }
        EXPECT_FALSE(plan.gains.empty());
    }
    [[nodiscard]] double here()
    {
        return plan.mode == Mode::Position && !isCounted() ? unit.simulator().position() : 0.0;
    }
    [[nodiscard]] bool isCounted() { return unit.device().family().capabilities.zeroPosition; }
    [[nodiscard]] std::vector<tuning::ExperimentPlan> steps()
    {
        return tuning::batteryOf(plan, std::round(here()), isCounted()).steps;
    }
    [[nodiscard]] Task<tuning::Trial> start(const tuning::ExperimentPlan &step)
    {
        return tuning::runExperiment(unit.device(), unit.stream(), step, unit.surroundings());
    }

    KnownUnit unit;
    tuning::ExperimentPlan plan;
};

TEST_P(BatteryOf, EverySizeIsSteppedBothWaysAndTheGainsThatWereTriedGoBackEachTime)
{
    std::vector<tuning::Trial> trials;
    for (const tuning::ExperimentPlan &step : steps()) {
        const std::size_t said = unit.notes().size();
        const auto trial = test::run(unit.clock(), start(step), 2min);
        ASSERT_TRUE(trial) << step.to << ": " << trial.error().text();
        EXPECT_EQ(trial->reason, EndReason::Done) << step.to << ": " << trial->detail;
        ASSERT_GT(unit.notes().size(), said);
        EXPECT_NE(unit.notes().back().second.find("from where it stands"), std::string::npos)
            << unit.notes().back().second;
        unit.expectStandsAsBefore();
        trials.push_back(*trial);
    }
    ASSERT_EQ(trials.size(), 10U);
    const tuning::BatteryWorst worst = tuning::worstOf(trials);
    std::printf("  %s %s: worst overshoot %.1f %%, worst time to settle %.2f s, worst error %.1f %%\n",
        GetParam().family, std::string(toString(GetParam().loop)).c_str(),
        100.0 * worst.metrics.overshoot.value_or(0.0), worst.metrics.settle.value_or(-1.0),
        100.0 * worst.metrics.sse.value_or(1.0));
    EXPECT_TRUE(worst.metrics.rise);
}

TEST_P(BatteryOf, AGuardEndsAStepOfItAndTheGainsThatWereTriedGoBack)
{
    const tuning::ExperimentPlan last = steps().back();
    auto task = start(last);
    task.start();
    ASSERT_TRUE(unit.clock().runUntil(
        [&] { return task.isFinished() || (unit.stream().isRunning() && unit.stream().setPoint().target == last.to); },
        60s));
    ASSERT_FALSE(task.isFinished());
    EXPECT_FALSE(unit.journal().owed.empty());
    EXPECT_TRUE(unit.simulator().disturb("stall", 1.0));
    ASSERT_TRUE(unit.clock().runUntil([&] { return task.isFinished(); }, 60s));
    ASSERT_TRUE(task.result()) << task.result().error().text();
    EXPECT_EQ(task.result()->reason, EndReason::NoMotion) << task.result()->detail;
    unit.expectStandsAsBefore();
}

INSTANTIATE_TEST_SUITE_P(EveryFamily, BatteryOf,
    testing::Values(BatteryCase{"dmc60c", Mode::Velocity, 4000.0}, BatteryCase{"abstractdc", Mode::Velocity, 4000.0},
        BatteryCase{"abstractdc", Mode::Position, 1500.0}, BatteryCase{"quadquad2drv", Mode::Velocity, 1500.0},
        BatteryCase{"quadquad2drv", Mode::Position, 1000.0}, BatteryCase{"supermodified", Mode::Position, 2000.0}),
    [](const auto &row) { return std::string(row.param.family) + '_' + std::string(toString(row.param.loop)); });

} // namespace
} // namespace mb::test
