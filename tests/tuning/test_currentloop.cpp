// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/motormodel.h"
#include "tests/tuning/tuningbench.h"
#include "tuning/gainrules.h"
#include "tuning/proof.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace mb::tuning {
namespace {

using test::ExperimentBench;
using test::planOf;
using test::rawOf;
using test::tune;

std::int64_t rawNumberOf(const test::TuneReport &report, std::string_view key)
{
    for (const ScaledGains::Row &row : report.proposed.rows) {
        if (row.key == key)
            return row.raw;
    }
    return -2;
}

TEST(CurrentLoop, TheBoundOfAnIntegralOfOtherGainsDoesNotHoldItShort)
{
    ExperimentBench bench("sim:can", "dmc60c", 5, "dmc60c:5,motor=cim,load=9,gains=overshoot");
    ASSERT_GT(rawOf(bench, "slot0.i_zone"), 0);
    const auto report = tune(bench, planOf(Mode::Current));
    ASSERT_TRUE(report) << report.error().text();
    EXPECT_EQ(report->result, TuneResult::Kept) << report->evidence;
    EXPECT_LE(report->measured.overshoot.value_or(1.0), 0.05);
    EXPECT_EQ(rawOf(bench, "slot0.i_zone"), 0);
}

TEST(CurrentLoop, AMotorOfLittleCurrentIsProvenOnTheMeanOfManySteps)
{
    for (const std::string motor : {"n20", "25dlp"}) {
        ExperimentBench bench("sim:can", "dmc60c", 5, "dmc60c:5,motor=" + motor + ",load=5,gains=overshoot");
        const auto report = tune(bench, planOf(Mode::Current));
        ASSERT_TRUE(report) << report.error().text();
        test::print(*report);
        EXPECT_EQ(report->result, TuneResult::Kept) << report->evidence;
        EXPECT_LE(report->seconds, 60.0);
        EXPECT_EQ(report->plant.tau, 0.5e-3) << "noise hides its L/R";
        EXPECT_NEAR(report->plant.reading, 0.031586, 0.0002);
        EXPECT_GT(report->plant.pickUp, 0.0);
        ASSERT_EQ(report->proof.size(), 2U);
        EXPECT_GT(report->proof.front().holds.size(), 6U) << "a few steps do not tell it";
        EXPECT_EQ(static_cast<int>(report->proof.front().holds.size()),
            currentRepeats(report->plant.noise, report->proof.front().stimulus.to));
    }
}

TEST(CurrentLoop, ItsPushesBeginGentlyAndGrowToTwiceAtMostUntilTheCurrentIsClear)
{
    for (const char *const motor : {"775pro", "n20"}) {
        ExperimentBench bench("sim:can", "dmc60c", 5, std::string("dmc60c:5,motor=") + motor + ",load=5");
        const auto report = tune(bench, planOf(Mode::Current));
        ASSERT_TRUE(report) << report.error().text();
        double strongest = 0.0;
        int pushes = 0;
        for (const Trial &trial : bench.journal.completed) {
            if (trial.mode != Mode::Duty)
                continue;
            const double duty = std::abs(trial.stimulus.to);
            EXPECT_LE(duty, pushes == 0 ? 0.05 : 2.0 * strongest + 1e-9) << motor << ", push " << pushes;
            strongest = std::max(strongest, duty);
            ++pushes;
        }
        EXPECT_GE(pushes, 4) << motor;
        EXPECT_LE(strongest, 0.5) << motor << " stands, and so does its current";
    }
}

TEST(CurrentLoop, WhatItsStepsTellOfTheWindingIsDesignedOnOnceMore)
{
    ExperimentBench bench("sim:can", "dmc60c", 5, "dmc60c:5,motor=775pro,load=7,gains=overshoot");
    const auto report = tune(bench, planOf(Mode::Current));
    ASSERT_TRUE(report) << report.error().text();
    test::print(*report);
    const MotorParameters &motor = *motorByName("775pro");
    const double lag = motor.inductance / (motor.resistance + MotorSupply().bridgeResistance);
    EXPECT_EQ(report->result, TuneResult::Kept) << report->evidence;
    EXPECT_NEAR(report->plant.tau, lag, 0.3 * lag);
    EXPECT_GT(report->plant.lagDoubt, 0.0);
    EXPECT_NE(report->evidence.english().find("proven first left more error"), std::string::npos) << report->evidence;
    const ContinuousGains rule = currentRule(report->plant, responseOf(Mode::Current, Aim::Normal, report->plant));
    EXPECT_GT(report->proposed.made.i, 1.3 * rule.i);
    EXPECT_EQ(rawOf(bench, "slot0.i"), rawNumberOf(*report, "slot0.i"));
    EXPECT_LE(report->seconds, 60.0);
}

TEST(CurrentLoop, WhatIsKeptIsWhatWasProvenLast)
{
    for (const char *const motor : {"775pro", "25d", "rs775"}) {
        ExperimentBench bench(
            "sim:can", "dmc60c", 5, std::string("dmc60c:5,motor=") + motor + ",load=5,gains=overshoot");
        const auto report = tune(bench, planOf(Mode::Current));
        ASSERT_TRUE(report) << report.error().text();
        ASSERT_EQ(report->result, TuneResult::Kept) << report->evidence;
        for (const Trial &trial : report->proof) {
            for (const ScaledGains::Row &row : report->proposed.rows) {
                const auto proven = std::find_if(trial.gains.begin(), trial.gains.end(), [&row](const auto &gain) {
                    return gain.first.substr(gain.first.find('.')) == row.key.substr(row.key.find('.'));
                });
                ASSERT_NE(proven, trial.gains.end()) << row.key;
                EXPECT_NEAR(proven->second.value_or(-1.0), row.number, 1e-4) << motor << ' ' << row.key;
            }
        }
    }
}

TEST(CurrentLoop, CalmGainsAndNumbersAreProvenOnce)
{
    for (const bool calm : {true, false}) {
        ExperimentBench bench("sim:can", "dmc60c", 5, "dmc60c:5,motor=775pro,load=7,gains=overshoot");
        TunePlan plan = planOf(Mode::Current);
        plan.aim = calm ? Aim::Calm : Aim::Normal;
        if (!calm)
            plan.response = 2.5e-3;
        const auto report = tune(bench, plan);
        ASSERT_TRUE(report) << report.error().text();
        EXPECT_EQ(report->result, TuneResult::Kept) << report->evidence;
        EXPECT_EQ(report->plant.tau, 0.5e-3);
        EXPECT_EQ(report->plant.lagDoubt, 0.0);
        for (const Proposal &one : report->proposals) // numbers of one's own take no aim's place
            EXPECT_EQ(one.design.response, responseOf(Mode::Current, one.aim, report->plant));
        const double asked = calm ? responseOf(Mode::Current, Aim::Calm, report->plant) : 2.5e-3;
        EXPECT_NEAR(report->proposed.made.i, currentRule(report->plant, asked).i, 0.01 * report->proposed.made.i);
    }
}

TEST(CurrentLoop, NoiseAsksForMoreStepsUpToAnEnd)
{
    EXPECT_EQ(currentRepeats(0.0, 20.0), 6);
    EXPECT_EQ(currentRepeats(0.063, 0.27), 16);
    EXPECT_EQ(currentRepeats(0.063, 0.225), 22);
    EXPECT_EQ(currentRepeats(1.0, 0.2), 30);
    for (const double step : {0.1, 0.27, 5.0}) // more noise than so many steps take out of their mean
        EXPECT_EQ(currentRepeats(1.001 * mostNoise(step), step), currentRepeats(0.999 * mostNoise(step), step));
    EXPECT_LT(mostNoise(0.18), 0.063) << "a limit of 0.6 A leaves an N20 too small a step";
}

TEST(CurrentLoop, AMotorWhoseCurrentIsLostInTheNoiseIsRefusedAndItsGainsStay)
{
    ExperimentBench bench("sim:can", "dmc60c", 5, "dmc60c:5,motor=n20,load=5,gains=overshoot");
    const auto before = rawOf(bench, "slot0.p");
    TunePlan plan = planOf(Mode::Current);
    plan.limits.current = 0.6;
    const auto report = tune(bench, plan);
    ASSERT_TRUE(report) << report.error().text();
    std::printf("  %s\n", report->evidence.english().c_str());
    EXPECT_EQ(report->result, TuneResult::Refused);
    EXPECT_FALSE(report->evidence.empty());
    EXPECT_EQ(rawOf(bench, "slot0.p"), before);
}

constexpr double askedCounts = 200.0; ///< of the converter

/// Where the current of an Abstract DC Drive with P alone came to rest, and the most that it was before.
struct HeldCurrent {
    double rest = 0.0;
    double peak = 0.0;
};

HeldCurrent held(double loopGain)
{
    ExperimentBench bench("sim:can", "abstractdc", 3, "abstractdc:3,dialect=F,motor=rs775,load=5");
    EXPECT_TRUE(bench.simulator()->disturb("stall", 1.0));
    bench.directions.add(bench.device->selector(), 1, 0.1);
    constexpr double divisor = 1e6;
    constexpr double perPwm = 18.0 * 20.0 / 255.0; // counts of the converter, at standstill
    ExperimentPlan plan;
    plan.mode = Mode::Current;
    plan.to = askedCounts;
    plan.seconds = 0.4; // a shaft that stands longer is taken for stalled
    plan.keep = Keep::Always;
    for (const auto &[key, value] : {std::pair("current.p", divisor * loopGain / perPwm), std::pair("current.i", 0.0),
             std::pair("current.d", 0.0), std::pair("current.divisor", divisor)})
        plan.gains.push_back(bench.change(key, std::round(value)));
    const auto trial = bench.run(plan);
    EXPECT_TRUE(trial) << trial.error().text();
    if (!trial || trial->holds.empty())
        return {};
    const Trace current = trial->signal("current")->trace.part(trial->holds.front().from, trial->holds.front().to);
    HeldCurrent seen;
    for (const double value : current.y)
        seen.peak = std::max(seen.peak, value);
    seen.rest = median(current.part(current.t.back() - 0.1, current.t.back()).y);
    return seen;
}

TEST(CurrentLoop, AFamilyWithoutTheLoopNamesThoseThatItHas)
{
    ExperimentBench board("sim:spi", "quadquad2drv", 0);
    const auto report = tune(board, planOf(Mode::Current));
    ASSERT_FALSE(report);
    EXPECT_NE(report.error().text().find("it has velocity, position"), std::string::npos) << report.error().text();
}

TEST(CurrentLoop, WhatPAloneOfAnAbstractDcHoldsIsSaidBeforeAnythingMoves)
{
    ExperimentBench bench("sim:can", "abstractdc", 3);
    TunePlan plan = planOf(Mode::Current);
    plan.keep = true;
    const auto report = tune(bench, plan);
    ASSERT_FALSE(report);
    EXPECT_EQ(report.error().fault, Fault::Unsupported);
    EXPECT_NE(report.error().text().find("holds 4.8 %"), std::string::npos) << report.error().text();
    EXPECT_FALSE(bench.simulator()->isOutputOn());
    for (const double loopGain : {0.1, 0.3, 0.6}) {
        const HeldCurrent seen = held(loopGain);
        const double rest = loopGain / (1.0 + loopGain) * askedCounts;
        std::printf("  P times gain %.1f: rests at %.0f of 200 (%.0f), overshoots that by %.0f %%\n", loopGain,
            seen.rest, rest, 100.0 * (seen.peak / seen.rest - 1.0));
        EXPECT_NEAR(seen.rest, rest, 0.15 * rest + 3.0);
        EXPECT_GE(seen.peak / seen.rest, 1.0 + 0.6 * loopGain);
    }
}

} // namespace
} // namespace mb::tuning
