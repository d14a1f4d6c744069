// SPDX-License-Identifier: GPL-3.0-or-later
// Position loops of motors that may not turn far: too little room for pushes that last.
#include "tests/tuning/tuningbench.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdio>

namespace mb::tuning {
namespace {

using test::ExperimentBench;
using test::planOf;
using test::rawOf;
using test::tune;

const Gate *gateOf(const TuneReport &report, std::string_view name)
{
    const auto found = std::find_if(
        report.gates.begin(), report.gates.end(), [name](const Gate &gate) { return gate.name == name; });
    return found == report.gates.end() ? nullptr : &*found;
}

TEST(Relay, TakesThePlaceOfPushesWhereTravelIsSmall)
{
    TunePlan plan = planOf(Mode::Position);
    plan.slot = 1;
    ExperimentBench wide("sim:can", "dmc60c", 5);
    const auto far = tune(wide, plan);
    ASSERT_TRUE(far) << far.error().text();
    EXPECT_EQ(gateOf(*far, "relay"), nullptr) << "pushes tell more where there is room";
    for (const double share : {0.12, 0.08, 0.05}) {
        ExperimentBench bench("sim:can", "dmc60c", 5);
        plan.limits.travel = std::round(share * far->plant.gain * far->plant.tau / 0.17);
        const auto report = tune(bench, plan);
        ASSERT_TRUE(report) << report.error().text();
        std::printf("  travel %.0f: %s, gain %.0f and %.0f, tau %.1f and %.1f ms: %s\n", *plan.limits.travel,
            std::string(toString(report->result)).c_str(), report->plant.gain, far->plant.gain, 1e3 * report->plant.tau,
            1e3 * far->plant.tau, report->evidence.english().c_str());
        const Gate *const gate = gateOf(*report, "relay");
        ASSERT_NE(gate, nullptr);
        std::printf("  %s\n", gate->detail.english().c_str());
        EXPECT_TRUE(gate->passed);
        EXPECT_NEAR(report->plant.tau, far->plant.tau, 0.12 * far->plant.tau);
        const double quickness = far->plant.gain / far->plant.tau;
        EXPECT_NEAR(report->plant.gain / report->plant.tau, quickness, 0.12 * quickness) << "what its P depends on";
        EXPECT_EQ(report->result, TuneResult::Kept) << report->evidence;
        EXPECT_LE(report->measured.overshoot.value_or(1.0), 0.05);
    }
}

TEST(Relay, SwingsEvenlyWhereverItsSamplesLie)
{
    TunePlan plan = planOf(Mode::Position);
    plan.propose = true;
    plan.limits.travel = 30'000.0;
    for (int later = 0; later < 8; ++later) {
        ExperimentBench bench("sim:can", "dmc60c", 5);
        bench.bench.clock.advance(std::chrono::microseconds(700 * later)); // of the 5 ms between two
        const auto report = tune(bench, plan);
        ASSERT_TRUE(report) << report.error().text();
        EXPECT_NE(gateOf(*report, "relay"), nullptr) << later;
        EXPECT_EQ(report->result, TuneResult::Proposed) << later << ": " << report->evidence;
    }
}

TEST(Relay, NeverLeavesTheTravelThatIsAllowed)
{
    for (const char *const motor : {"775pro", "25d", "rs775"}) {
        ExperimentBench bench("sim:can", "dmc60c", 5, std::string("dmc60c:5,motor=") + motor + ",load=5");
        TunePlan plan = planOf(Mode::Position);
        plan.limits.travel = motor == std::string("25d") ? 800.0 : 40'000.0;
        const double rest = bench.simulator()->position();
        double farthest = 0.0;
        Timer looking(bench.bench.clock);
        const std::function<void()> look = [&] {
            farthest = std::max(farthest, std::abs(bench.simulator()->position() - rest));
            looking.startIn(std::chrono::milliseconds(1), look);
        };
        look();
        const auto before = rawOf(bench, "slot0.p");
        const auto report = tune(bench, plan);
        std::printf("  %s: %s; at most %.0f of %.0f counts away\n", motor,
            report ? report->evidence.english().c_str() : report.error().text().c_str(), farthest, *plan.limits.travel);
        EXPECT_LE(farthest, *plan.limits.travel);
        if (!report || report->result != TuneResult::Kept) {
            EXPECT_EQ(rawOf(bench, "slot0.p"), before);
        }
    }
}

} // namespace
} // namespace mb::tuning
