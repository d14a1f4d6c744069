// SPDX-License-Identifier: GPL-3.0-or-later
// What a tuning must leave behind, and stay within, beside its gains.
#include "tests/tuning/tuningbench.h"

#include <gtest/gtest.h>

namespace mb::tuning {
namespace {

using test::ExperimentBench;
using test::planOf;
using test::rawOf;
using test::tune;

void write(ExperimentBench &bench, std::string_view key, double number)
{
    const ParameterChange change = bench.change(key, number);
    ASSERT_TRUE(test::run(bench.bench.clock, bench.device->write(change.index, change.raw))) << key;
}

TEST(TuneBounds, TheLeastOutputOfAPositionLoopIsTakenFromALoopThatIsNone)
{
    for (const Mode loop : {Mode::Velocity, Mode::Current}) {
        ExperimentBench bench("sim:can", "dmc60c", 5);
        write(bench, "slot0.nominal_forward", 862.0);
        write(bench, "slot0.nominal_reverse", -862.0);
        const auto report = tune(bench, planOf(loop));
        ASSERT_TRUE(report) << report.error().text();
        EXPECT_EQ(report->result, TuneResult::Kept) << report->evidence;
        EXPECT_EQ(rawOf(bench, "slot0.nominal_forward"), 0) << toString(loop);
        EXPECT_EQ(rawOf(bench, "slot0.nominal_reverse"), 0) << toString(loop);
    }
}

} // namespace
} // namespace mb::tuning
