// SPDX-License-Identifier: GPL-3.0-or-later
// What a tuning says, ends with and leaves in the unit itself where something strikes while it proves. It begins at its proof, with a
// model that is known, on every family in virtual time.
#include "app/console/failure.h"
#include "app/console/tuneverdict.h"
#include "async/sleep.h"
#include "experiment/owedgains.h"
#include "experiment/seconds.h"
#include "model/family.h"
#include "model/loopparameters.h"
#include "tests/tuning/matrix/groundtruth.h"
#include "tests/tuning/othermaster.h"
#include "tuning/gainrules.h"
#include "tuning/proofcourse.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

namespace mb::test {
namespace {

using namespace std::chrono_literals;
using tuning::TunePlan;
using tuning::TuneReport;
using tuning::TuneResult;

struct Strike {
    std::string_view what;
    std::string_view reason;    ///< of the report; empty: it is refused
    int status = 0;             ///< of the console
    std::string_view says = {}; ///< among others
};
const std::vector<Strike> anywhere{
    {"power", "link", 5}, {"cable", "link", 5}, {"user", "interrupted", 4}, {"full disk", "", 1, "the disk is full"}};
const std::vector<Strike> ofTheMotor{{"encoder-dead", "no motion", 4}, {"stall", "no motion", 4}};
const Strike master{"master", "foreign master", 4};

struct Case {
    Cell cell;
    Strike strike;
};

void PrintTo(const Case &test, std::ostream *out)
{
    *out << test.cell.family << test.cell.dialect << ' ' << toString(test.cell.loop) << ": " << test.strike.what;
}

Cell cellWith(const char *family, Mode loop, const char *dialect = "")
{
    Cell cell;
    cell.family = family;
    cell.motor = "25d";
    cell.loop = loop;
    cell.dialect = dialect;
    return cell;
}

std::vector<Case> cases()
{
    std::vector<Case> all;
    for (const Cell &cell :
        {cellWith("dmc60c", Mode::Velocity), cellWith("dmc60c", Mode::Position), cellWith("dmc60c", Mode::Current),
            cellWith("abstractdc", Mode::Velocity), cellWith("abstractdc", Mode::Position),
            cellWith("quadquad2drv", Mode::Velocity), cellWith("quadquad2drv", Mode::Position),
            cellWith("supermodified", Mode::Position, "D1"), cellWith("supermodified", Mode::Position, "D3")}) {
        const auto add = [&](const Strike &strike) { all.push_back({cell, strike}); };
        for (const Strike &strike : anywhere) {
            const bool isShort
                = cell.loop == Mode::Current && strike.status == 1; // its first step holds no model as rough as this
            const bool isWhole = cell.family == "quadquad2drv" && strike.what == "cable"; // its wire loses nothing
            if (!isShort && !isWhole)
                add(strike);
        }
        if (cell.family != "quadquad2drv") // whose wire has one master
            add(master);
        if (cell.loop == Mode::Current)
            continue;
        std::ranges::for_each(ofTheMotor, add);
    }
    return all;
}

using Gains = std::vector<std::pair<std::string, std::optional<std::int64_t>>>;

/// A unit whose gains are known, none of them what it starts with, and the order to prove others on a model of its motor.
struct Proven {
    explicit Proven(const Cell &cell)
        : loop(cell.loop)
        , unit(cell)
    {
        writeOnce(*loopOf(unit.device().family(), loop));
        before = unit.gainsInUnit();
        plan.loop = loop;
        plan.known = groundTruth(cell, 1000.0);
        plan.scale = trueScale(cell);
        if (cell.dialect != "D1") { // whose few counts need more than calm gains to overcome friction
            plan.response = tuning::responseOf(loop, tuning::Aim::Calm, *plan.known);
            plan.ms = 1.7;
        }
        task = tuning::autotune(unit.device(), unit.stream(), plan, unit.surroundings());
    }
    void writeOnce(const LoopGains &gains)
    {
        Device &device = unit.device();
        if (device.family().key != "quadquad2drv")
            return;
        for (const ParameterIndex index : loopParameters(device.family(), gains, 1, 0))
            EXPECT_TRUE(run(unit.clock(), device.write(index, 90 + index.value)));
    }
    [[nodiscard]] bool isStepping()
    {
        const SetPoint &now = unit.stream().setPoint();
        return unit.stream().isRunning() && now.mode == loop && !now.relative && now.target != 0.0
            && std::abs(unit.simulator().speed()) > 20.0;
    }
    void strike(std::string_view what)
    {
        if (what == "power")
            unit.simulator().setPowered(false);
        else if (what == "cable")
            unit.setLoss(1.0);
        else if (what == "user")
            unit.interruption().interrupt();
        else if (what == "full disk")
            unit.journal().isFull = true;
        else if (what == "master")
            commandElsewhere(*(other = unit.otherEnd()), unit.clock(), unit.device());
        else
            EXPECT_TRUE(unit.simulator().disturb(what, 1.0));
    }
    [[nodiscard]] TuneReport finish()
    {
        EXPECT_TRUE(unit.clock().runUntil([this] { return task.isFinished(); }, 3min));
        if (!task.isFinished() || !task.result()) {
            ADD_FAILURE() << (task.isFinished() ? task.result().error().text() : "it does not end");
            return {};
        }
        return std::move(*task.result());
    }
    /// Everything is as it should be again, and who asks the unit finds out what it is owed: how much he is asked about.
    [[nodiscard]] std::size_t connectAgain()
    {
        unit.setLoss(0.0);
        unit.simulator().setPowered(true);
        unit.journal().isFull = false;
        unit.device().stop(); // which is owed to a unit that did not hear it
        unit.clock().advance(3s);
        EXPECT_TRUE(run(unit.clock(), unit.device().refresh()));
        const auto owed = run(unit.clock(), tuning::lookForOwed(unit.device(), unit.journal()));
        EXPECT_TRUE(owed) << owed.error().text();
        if (!owed)
            return 0;
        for (const tuning::OwedGains &debt : *owed) {
            const auto paid = run(unit.clock(), tuning::payOwed(unit.device(), unit.journal(), debt));
            EXPECT_TRUE(paid) << paid.error().text();
        }
        return owed->size();
    }

    Mode loop;
    MatrixUnit unit;
    TunePlan plan;
    Gains before;
    std::unique_ptr<Link> other;
    Task<TuneReport> task;
};

int statusOf(const TuneReport &report)
{
    const auto verdict = console::verdictOfTuning(report);
    return verdict ? *verdict : console::exitStatusOf(verdict.error().fault, true);
}

class StruckProof : public testing::TestWithParam<Case> { };

TEST_P(StruckProof, EndsInItsWordAndItsStatusAndTheUnitHasItsGainsOrIsOwedThem)
{
    const auto &[cell, strike] = GetParam();
    Proven proven(cell);
    MatrixUnit &unit = proven.unit;
    proven.task.start();
    ASSERT_TRUE(unit.clock().runUntil([&] { return proven.task.isFinished() || proven.isStepping(); }, 60s));
    ASSERT_FALSE(proven.task.isFinished())
        << (proven.task.result() ? proven.task.result()->evidence.english() : proven.task.result().error().text());
    ASSERT_FALSE(unit.journal().owed.empty());
    proven.strike(strike.what);
    const TuneReport report = proven.finish();
    std::printf("  %s%s %s, %s: %s '%s': %s\n", cell.family.c_str(), cell.dialect.c_str(),
        std::string(toString(cell.loop)).c_str(), std::string(strike.what).c_str(),
        std::string(toString(report.result)).c_str(), std::string(toString(report.stopReason)).c_str(),
        report.evidence.english().c_str());
    EXPECT_EQ(report.result, strike.reason.empty() ? TuneResult::Refused : TuneResult::Stopped);
    EXPECT_EQ(toString(report.stopReason), strike.reason);
    EXPECT_EQ(statusOf(report), strike.status);
    EXPECT_NE(report.evidence.english().find(strike.says), std::string::npos) << report.evidence;
    const bool isLost = strike.reason == "link";
    EXPECT_EQ(report.stopped, !isLost);
    EXPECT_EQ(isPutBack(report), !isLost);
    if (!isLost) {
        EXPECT_FALSE(unit.simulator().isOutputOn());
        EXPECT_EQ(unit.gainsInUnit(), proven.before);
    }
    EXPECT_EQ(unit.journal().owed.empty(), !isLost && strike.what != "full disk");
    if (strike.what == "cable")
        unit.setLoss(0.0); // its unit is asked before anything else is done to it
    const bool isUnknown = strike.what == "power" && !unit.device().family().capabilities.readback;
    if (strike.what == "power")
        unit.simulator().setPowered(true);
    unit.clock().advance(3s);
    const bool isOther = unit.gainsInUnit() != proven.before;
    EXPECT_EQ(proven.connectAgain() > 0, isOther || isUnknown);
    EXPECT_TRUE(unit.journal().owed.empty());
    EXPECT_FALSE(unit.simulator().isOutputOn());
    EXPECT_EQ(unit.gainsInUnit(), proven.before);
}

INSTANTIATE_TEST_SUITE_P(
    EveryFamily, StruckProof, testing::ValuesIn(cases()), [](const auto &row) { return std::to_string(row.index); });

class FullDisk : public testing::TestWithParam<Case> { };

/// What is proven is written where it belongs only once what was there is written down.
TEST_P(FullDisk, AfterTheProofLeavesTheGainsAsTheyWereAndSaysWhy)
{
    Proven proven(GetParam().cell);
    int owed = 0;
    proven.unit.journal().whenOwed = [&] { proven.unit.journal().isFull = ++owed == 3; };
    proven.task.start();
    const TuneReport report = proven.finish();
    EXPECT_EQ(report.proof.size(), 2U) << report.evidence;
    EXPECT_EQ(owed, 3);
    EXPECT_EQ(report.result, TuneResult::Refused) << report.evidence;
    EXPECT_EQ(statusOf(report), 1);
    EXPECT_NE(report.evidence.english().find("the disk is full"), std::string::npos) << report.evidence;
    EXPECT_TRUE(isPutBack(report));
    EXPECT_EQ(proven.unit.gainsInUnit(), proven.before);
    EXPECT_FALSE(proven.unit.simulator().isOutputOn());
    proven.unit.journal().isFull = false;
    EXPECT_TRUE(proven.unit.journal().owed.empty());
}

INSTANTIATE_TEST_SUITE_P(EveryFamily, FullDisk,
    testing::Values(Case{cellWith("dmc60c", Mode::Velocity), {}}, Case{cellWith("abstractdc", Mode::Velocity), {}},
        Case{cellWith("quadquad2drv", Mode::Velocity), {}}),
    [](const auto &row) { return row.param.cell.family; });

TEST(ProofOfABoard, SaysThatItsGainsCannotBeReadBack)
{
    Proven proven(cellWith("quadquad2drv", Mode::Velocity));
    proven.task.start();
    const TuneReport report = proven.finish();
    EXPECT_EQ(report.result, TuneResult::Kept);
    EXPECT_NE(report.evidence.english().find("cannot read back"), std::string::npos) << report.evidence;
}

TEST(ProofOfADmc60c, ThatMeetsALimitSwitchNamesIt)
{
    for (const Mode loop : {Mode::Velocity, Mode::Position}) {
        Proven proven(cellWith("dmc60c", loop));
        proven.task.start();
        ASSERT_TRUE(proven.unit.clock().runUntil([&] { return proven.isStepping(); }, 60s));
        proven.strike("forward-limit");
        const TuneReport report = proven.finish();
        EXPECT_EQ(report.result, TuneResult::RolledBack) << report.evidence;
        EXPECT_EQ(statusOf(report), 1);
        EXPECT_NE(report.evidence.english().find("a limit switch was met"), std::string::npos) << report.evidence;
        EXPECT_TRUE(report.stopped);
        EXPECT_FALSE(proven.unit.simulator().isOutputOn());
        EXPECT_EQ(proven.unit.gainsInUnit(), proven.before);
    }
}

Task<void> waits(Clock &clock, Duration time)
{
    co_await Sleep(clock, time);
    co_return {};
}

/// Of a proof that something keeps from its first step for so many of the sixty seconds.
TuneReport provenAfter(double seconds)
{
    const Cell cell = cellWith("dmc60c", Mode::Velocity);
    MatrixUnit unit(cell);
    TunePlan plan;
    plan.known = groundTruth(cell, 1000.0);
    plan.response = tuning::responseOf(Mode::Velocity, tuning::Aim::Calm, *plan.known);
    plan.ms = 1.7;
    auto around = unit.surroundings();
    around.before = [&unit, seconds] { return waits(unit.clock(), tuning::ofSeconds(seconds)); };
    const auto report
        = run(unit.clock(), tuning::autotune(unit.device(), unit.stream(), plan, std::move(around)), 10min);
    EXPECT_TRUE(report) << report.error().text();
    return report ? *report : TuneReport();
}

std::size_t stepsMade(const TuneReport &report)
{
    std::size_t steps = 0;
    for (const tuning::Trial &trial : report.proof)
        steps += trial.holds.size();
    return steps;
}

TEST(StepsOfAProof, AreFourAsLongAsThereIsTimeForTwoMoreOrTheAnswerSaysHowManyTheyWere)
{
    const TuneReport early = provenAfter(0.0);
    ASSERT_EQ(early.result, TuneResult::Kept) << early.evidence;
    EXPECT_EQ(stepsMade(early), 4U);
    EXPECT_EQ(early.evidence.english().find("instead of 4"), std::string::npos) << early.evidence;
    const double way = tuning::proofSeconds(early.proof.front().stimulus.time, tuning::usualProofs);
    const TuneReport late = provenAfter(60.0 - 2.3 * way);
    ASSERT_EQ(late.result, TuneResult::Kept) << late.evidence;
    EXPECT_EQ(stepsMade(late), 4U) << "there is time for the other way";
    EXPECT_EQ(late.evidence.english().find("instead of 4"), std::string::npos) << late.evidence;
    const TuneReport tooLate = provenAfter(60.0 - way);
    ASSERT_EQ(tooLate.result, TuneResult::Kept) << tooLate.evidence;
    EXPECT_EQ(stepsMade(tooLate), 3U);
    EXPECT_NE(tooLate.evidence.english().find("they were proven by 3 steps instead of 4"), std::string::npos)
        << tooLate.evidence;
}

} // namespace
} // namespace mb::test
