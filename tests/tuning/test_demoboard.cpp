// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiment/latepush.h"
#include "families/quadquad2drv/calibrations.h"
#include "families/quadquad2drv/simulatoraxis.h"
#include "tests/tuning/tuningbench.h"

#include <gtest/gtest.h>

namespace mb::tuning {
namespace {

using namespace mb::test;

/// The board of the bench as it comes, but for its gain scales.
void calibrateDemo(ExperimentBench &bench)
{
    using namespace quadquad2drv;
    using namespace quadquad2drv::simulation;
    for (const auto &[key, scale] :
        {std::pair(calibration::velocityP, gain::velocityP), std::pair(calibration::velocityI, gain::velocityI)})
        ASSERT_TRUE(bench.device->knowledge().calibrate(key, scale));
}

Result<TuneReport> tuneAxis(ExperimentBench &bench, int axis)
{
    calibrateDemo(bench);
    TunePlan plan = planOf(Mode::Velocity);
    plan.axis = axis;
    plan.keep = true;
    return tune(bench, plan);
}

TEST(DemoBoard, ItsAxesAreTunedWithTheQuarterOfItsPowerThatItBeginsWith)
{
    for (const int axis : {1, 2, 3, 4}) {
        ExperimentBench bench("sim:spi", "quadquad2drv", 0);
        const auto report = tuneAxis(bench, axis);
        ASSERT_TRUE(report) << report.error().text();
        print(*report);
        EXPECT_EQ(report->result, TuneResult::Kept) << axis << ": " << report->evidence;
        EXPECT_EQ(report->evidence.english().find("calm"), std::string::npos) << axis << ": " << report->evidence;
        EXPECT_LE(report->seconds, 60.0);
    }
}

TEST(DemoBoard, FrictionThatTakesHalfOfTheDutyLeavesTwoSizesOfPushesThatOvercomeIt)
{
    ExperimentBench bench("sim:spi", "quadquad2drv", 0);
    const auto report = tuneAxis(bench, 2);
    ASSERT_TRUE(report) << report.error().text();
    print(*report);
    EXPECT_NEAR(report->plant.friction, 0.133, 0.002);
    EXPECT_FALSE(report->proof.empty()) << report->evidence;
}

TEST(DemoBoard, PushesThatItsSpeedLeavesTooWeakForFrictionAreNamed)
{
    ExperimentBench bench("sim:spi", "quadquad2drv", 0);
    calibrateDemo(bench);
    TunePlan plan = planOf(Mode::Velocity);
    plan.axis = 2;
    plan.keep = true;
    plan.limits.speed = 200.0;
    const auto report = tune(bench, plan);
    ASSERT_TRUE(report) << report.error().text();
    EXPECT_EQ(report->result, TuneResult::Refused);
    EXPECT_NE(report->evidence.english().find("hardly moved"), std::string::npos) << report->evidence;
    EXPECT_NE(report->evidence.english().find("allow more"), std::string::npos) << report->evidence;
}

Trial weakStep(double i)
{
    Trial trial;
    trial.mode = Mode::Velocity;
    trial.stimulus.to = -500.0;
    trial.gains = {{"ch1.velocity.p", 40.0}, {"ch1.velocity.i", i}, {"ch1.velocity.d", 0.0}};
    return trial;
}

TEST(DemoBoard, AWeakIntegralPushesLate)
{
    ExperimentBench bench("sim:spi", "quadquad2drv", 0);
    EXPECT_EQ(secondsUntilPush(*bench.device, weakStep(40.0), 0.1), 0.0) << "nobody knows what a gain makes";
    calibrateDemo(bench);
    // 819.1 of 8191, of which P makes 200 at once and I 0.7 in each pass of 2 ms
    EXPECT_NEAR(secondsUntilPush(*bench.device, weakStep(40.0), 0.1), 1.769, 0.001);
    EXPECT_EQ(secondsUntilPush(*bench.device, weakStep(40.0), 0.02), 0.0);
    EXPECT_EQ(secondsUntilPush(*bench.device, weakStep(1.0), 0.1), 5.0);
    EXPECT_EQ(secondsUntilPush(*bench.device, weakStep(0.0), 0.1), 0.0);
}

} // namespace
} // namespace mb::tuning
