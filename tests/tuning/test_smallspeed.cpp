// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiment/guards.h"
#include "tests/tuning/tuningbench.h"

#include <gtest/gtest.h>

namespace mb::tuning {
namespace {

using namespace mb::test;

/// The motor of the bench makes 47 000 counts/s of the 15 % duty of a first probe.
Result<TuneReport> tuneWithin(ExperimentBench &bench, Mode loop, double speed)
{
    TunePlan plan = planOf(loop);
    plan.slot = loop == Mode::Position ? 1 : 0;
    plan.limits.speed = speed;
    return tune(bench, plan);
}

TEST(SmallSpeed, NoProbeMakesMoreOfItThanIsAllowed)
{
    for (const Mode loop : {Mode::Velocity, Mode::Position}) {
        ExperimentBench bench;
        const auto report = tuneWithin(bench, loop, 20'000.0);
        ASSERT_TRUE(report) << report.error().text();
        print(*report);
        EXPECT_EQ(report->result, TuneResult::Kept) << report->evidence;
        for (const auto &trial : bench.journal.completed) {
            const Signal *const velocity = trial.signal("velocity");
            ASSERT_TRUE(velocity);
            for (const double speed : velocity->trace.y)
                ASSERT_LT(std::abs(speed), 1.2 * 20'000.0) << trial.stimulus.to;
        }
    }
}

TEST(SmallSpeed, ThatTheLeastDutyExceedsIsToldAsWhatIsMissing)
{
    for (const double speed : {10.0, 2000.0}) {
        ExperimentBench bench;
        const auto report = tuneWithin(bench, Mode::Velocity, speed);
        ASSERT_TRUE(report) << report.error().text();
        EXPECT_EQ(report->trials.size(), 1U);
        EXPECT_NE(report->evidence.english().find("allow more speed"), std::string::npos) << report->evidence;
    }
}

} // namespace
} // namespace mb::tuning
