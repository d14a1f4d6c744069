// SPDX-License-Identifier: GPL-3.0-or-later
// A board on a bad wire: frames on SPI are lost, or told apart from good ones by their check.
#include "families/quadquad2drv/calibrations.h"
#include "families/quadquad2drv/simulatoraxis.h"
#include "tests/tuning/tuningbench.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <string>

namespace mb::tuning {
namespace {

using test::ExperimentBench;
using test::planOf;
using test::tune;

Result<TuneReport> tuneBoard(ExperimentBench &bench)
{
    using namespace quadquad2drv;
    using namespace quadquad2drv::simulation;
    EXPECT_TRUE(bench.device->knowledge().calibrate(calibration::velocityP, gain::velocityP));
    EXPECT_TRUE(bench.device->knowledge().calibrate(calibration::velocityI, gain::velocityI));
    for (const auto &[key, value] : {std::pair("ch2.limit.power", 0.8), std::pair("history.length", 8.0)}) {
        const ParameterChange change = bench.change(key, value);
        Result<std::int64_t> written = fail(Fault::Timeout);
        for (int again = 0; !written && again < 5; ++again)
            written = test::run(bench.bench.clock, bench.device->write(change.index, change.raw));
        EXPECT_TRUE(written) << key;
    }
    TunePlan plan = planOf(Mode::Velocity);
    plan.axis = 2;
    plan.keep = true;
    return tune(bench, plan);
}

TEST(BoardLoss, AWireThatLosesOneInAHundredIsTunedAsWell)
{
    ExperimentBench clean("sim:spi?seed=3", "quadquad2drv", 0);
    const auto whole = tuneBoard(clean);
    ASSERT_TRUE(whole) << whole.error().text();
    ASSERT_EQ(whole->result, TuneResult::Kept) << whole->evidence;
    ExperimentBench lossy("sim:spi?seed=3&loss=0.01", "quadquad2drv", 0);
    const auto report = tuneBoard(lossy);
    ASSERT_TRUE(report) << report.error().text();
    std::printf("  %s, %s; gain %.0f and %.0f, tau %.1f and %.1f ms\n", std::string(toString(report->result)).c_str(),
        report->evidence.english().c_str(), report->plant.gain, whole->plant.gain, 1e3 * report->plant.tau,
        1e3 * whole->plant.tau);
    EXPECT_TRUE(report->stopped);
    EXPECT_EQ(report->result, TuneResult::Kept) << report->evidence;
    EXPECT_NEAR(report->plant.gain, whole->plant.gain, 0.02 * whole->plant.gain);
    EXPECT_NEAR(report->plant.tau, whole->plant.tau, 0.05 * whole->plant.tau);
}

TEST(BoardLoss, AWireThatLosesAThirdStopsTheMotorAndSaysIt)
{
    ExperimentBench bench("sim:spi?seed=3&loss=0.3", "quadquad2drv", 0);
    const auto report = tuneBoard(bench);
    if (report)
        std::printf("  %s, %s: %s\n", std::string(toString(report->result)).c_str(),
            std::string(toString(report->stopReason)).c_str(), report->evidence.english().c_str());
    else
        std::printf("  %s\n", report.error().text().c_str());
    EXPECT_FALSE(report && report->result == TuneResult::Kept);
    bench.bench.clock.advance(std::chrono::seconds(2));
    EXPECT_FALSE(bench.simulator()->isOutputOn());
}

} // namespace
} // namespace mb::tuning
