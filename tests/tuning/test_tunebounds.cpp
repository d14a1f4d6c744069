// SPDX-License-Identifier: GPL-3.0-or-later
// What a tuning must leave behind, and stay within, beside its gains.
#include "tests/tuning/tuningbench.h"
#include "tuning/proposals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <tuple>

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

TunePlan positionWithin(double duty, Aim aim = Aim::Normal)
{
    TunePlan plan = planOf(Mode::Position);
    plan.aim = aim;
    plan.limits.duty = duty;
    return plan;
}

TEST(TuneBounds, AProofOnAKnownModelTellsWhatItWasFoundOn)
{
    ExperimentBench bench("sim:can", "dmc60c", 5);
    TunePlan plan = planOf(Mode::Velocity);
    plan.propose = true;
    const auto identified = tune(bench, plan);
    ASSERT_TRUE(identified) << identified.error().text();
    plan = planOf(Mode::Velocity);
    plan.known = identified->plant;
    plan.taking = identified->taking;
    plan.motor = identified->motor;
    plan.gates = identified->gates;
    const auto report = tune(bench, plan);
    ASSERT_TRUE(report) << report.error().text();
    EXPECT_EQ(report->result, TuneResult::Kept) << report->evidence;
    ASSERT_TRUE(report->motor);
    EXPECT_GE(report->gates.size(), identified->gates.size());
    EXPECT_EQ(report->motor->line.gainError, identified->motor->line.gainError);
    EXPECT_EQ(report->motor->heat, 0.0) << "its pushes were long ago";
}

/// A second proof meets an obstacle: `strike` when it is announced.
TuneReport struckSecondProof(ExperimentBench &bench, const std::function<void()> &strike)
{
    bool isStruck = false;
    bench.surroundings.note = [&, before = bench.surroundings.note](const Message &text) {
        before(text);
        const std::string said = text.english();
        if (!isStruck && (said.find("now those") != std::string::npos)) {
            isStruck = true;
            strike();
        }
    };
    const auto report = tune(bench, planOf(Mode::Velocity));
    EXPECT_TRUE(report) << report.error().text();
    EXPECT_TRUE(isStruck);
    return report.value_or(TuneReport());
}

TEST(TuneBounds, ASecondProofThatAGuardEndsLeavesTheSetThatWasProven)
{
    ExperimentBench bench("sim:can", "dmc60c", 5);
    const TuneReport report = struckSecondProof(bench, [&] { bench.simulator()->disturb("stall", 1.0); });
    EXPECT_EQ(report.result, TuneResult::Kept) << report.evidence;
    EXPECT_EQ(report.proof.size(), 2U) << "those of the set that is kept";
    EXPECT_NE(report.evidence.english().find("were given up: "), std::string::npos) << report.evidence;
    for (const ScaledGains::Row &row : report.proposed.rows)
        EXPECT_EQ(rawOf(bench, row.key), row.raw) << row.key;
}

TEST(TuneBounds, ASecondProofThatTheUserStopsOrTheUnitIsLostInEndsTheTuning)
{
    for (const bool byUser : {true, false}) {
        ExperimentBench bench("sim:can", "dmc60c", 5);
        const std::int64_t before = rawOf(bench, "slot0.p");
        const TuneReport report = struckSecondProof(bench, [&] {
            if (byUser)
                bench.interruption.interrupt();
            else
                bench.simulator()->setPowered(false);
        });
        EXPECT_EQ(report.result, TuneResult::Stopped) << report.evidence;
        EXPECT_EQ(report.stopReason, byUser ? EndReason::Interrupted : EndReason::Link);
        if (byUser) {
            EXPECT_EQ(rawOf(bench, "slot0.p"), before);
        }
    }
}

TEST(TuneBounds, ADriveIsToldTheDutyThatALoopIsAllowed)
{
    for (const auto &[unit, duty, aim] :
        {std::tuple(5, 0.5, Aim::Normal), std::tuple(5, 0.15, Aim::Calm), std::tuple(7, 0.5, Aim::Normal)}) {
        ExperimentBench bench("sim:can", "dmc60c", unit);
        const auto report = tune(bench, positionWithin(duty, aim));
        ASSERT_TRUE(report) << report.error().text();
        EXPECT_EQ(report->result, TuneResult::Kept) << unit << ' ' << duty << ": " << report->evidence;
        const auto most = static_cast<std::int64_t>(std::floor(duty * 32767.0));
        EXPECT_EQ(rawOf(bench, "slot0.max_forward"), most);
        EXPECT_EQ(rawOf(bench, "slot0.max_reverse"), -most);
        EXPECT_EQ(rawOf(bench, "slot1.max_forward"), 32767) << "the slot that it was proven in is as it was";
    }
}

TEST(TuneBounds, APositionLoopThatNothingKeepsToADutyIsRefusedBeforeItMoves)
{
    for (const double duty : {0.4, 0.9}) {
        ExperimentBench bench("sim:can", "abstractdc", 3);
        const double place = bench.simulator()->position();
        TunePlan plan = positionWithin(duty);
        plan.keep = true;
        const auto report = tune(bench, plan);
        ASSERT_FALSE(report) << report->evidence;
        EXPECT_EQ(report.error().fault, Fault::OutOfRange);
        EXPECT_NE(report.error().text().find(duty < 0.5 ? "40 % duty" : "90 % duty"), std::string::npos)
            << report.error().text();
        EXPECT_EQ(bench.simulator()->position(), place);
        plan.propose = true;
        EXPECT_TRUE(checkTuning(bench.device->family(), plan)) << "no loop runs";
    }
}

TEST(TuneBounds, AVelocityLoopThatNothingKeepsToADutyMakesAStepThatStaysBelowIt)
{
    ExperimentBench bench("sim:can", "abstractdc", 3);
    TunePlan plan = planOf(Mode::Velocity);
    plan.limits.duty = 0.5;
    plan.keep = true;
    const auto report = tune(bench, plan);
    ASSERT_TRUE(report) << report.error().text();
    EXPECT_EQ(report->result, TuneResult::Kept) << report->evidence;
}

TEST(TuneBounds, ALimitOfTheOutputIsNeverWidened)
{
    const ExperimentBench bench;
    const Family &family = bench.device->family();
    const auto limits = [&family](double duty, const KnownGains &now) {
        ScaledGains gains;
        limitOutput(family, Mode::Position, 1, 0, duty, now, gains);
        std::vector<double> numbers;
        for (const ScaledGains::Row &row : gains.rows)
            numbers.push_back(row.number);
        return numbers;
    };
    EXPECT_EQ(limits(1.0, {}), std::vector<double>());
    EXPECT_EQ(limits(0.5, {}), (std::vector<double>{16383.0, -16383.0}));
    EXPECT_EQ(limits(0.5, {{"slot0.max_forward", 32767.0}, {"slot0.max_reverse", -100.0}}),
        (std::vector<double>{16383.0, -100.0}));
    EXPECT_EQ(limits(0.5, {{"slot0.max_reverse", 0.0}}), (std::vector<double>{16383.0, 0.0}));
}

TEST(TuneBounds, WhatIsPredictedToOvershootTooMuchIsRefusedBeforeItMoves)
{
    ExperimentBench bench("sim:can", "dmc60c", 5);
    const std::int64_t before = rawOf(bench, "slot0.p");
    const double place = bench.simulator()->position();
    TunePlan plan = planOf(Mode::Velocity);
    plan.known = PlantModel{367'000.0, 0.9, 0.052, 0.018};
    plan.response = 0.02;
    plan.ms = 2.5;
    const auto report = tune(bench, plan);
    ASSERT_FALSE(report) << report->evidence;
    EXPECT_EQ(report.error().fault, Fault::OutOfRange);
    EXPECT_NE(report.error().text().find("would overshoot by "), std::string::npos) << report.error().text();
    EXPECT_EQ(bench.simulator()->position(), place);
    EXPECT_EQ(rawOf(bench, "slot0.p"), before);
}

TEST(TuneBounds, AVelocityLoopIsProvenWithinItsTravel)
{
    for (const auto &[unit, travel] : {std::pair(5, 120'000.0), std::pair(7, 400'000.0)}) {
        ExperimentBench bench("sim:can", "dmc60c", unit);
        TunePlan plan = planOf(Mode::Velocity);
        plan.limits.travel = travel;
        const auto report = tune(bench, plan);
        ASSERT_TRUE(report) << report.error().text();
        EXPECT_EQ(report->result, TuneResult::Kept) << unit << ": " << report->evidence;
    }
}

TEST(TuneBounds, TravelThatNoStepFitsIntoIsSaidWithWhatItTakes)
{
    const ExperimentBench bench;
    Envelope envelope;
    envelope.duty = 1.0;
    envelope.speed = 1e6;
    envelope.travel = 20.0;
    const ProposalBasis basis{bench.device->family(), bench.device->knowledge().profile(), Mode::Velocity, 1, 0,
        PlantModel{1'285'000.0, 0.26, 0.0507, 0.002}, envelope, {}};
    const auto proposal = proposalFor(basis, {});
    ASSERT_FALSE(proposal);
    EXPECT_NE(proposal.error().text().find("counts of travel, 20 are allowed"), std::string::npos)
        << proposal.error().text();
}

} // namespace
} // namespace mb::tuning
