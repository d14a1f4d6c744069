// SPDX-License-Identifier: GPL-3.0-or-later
#include "async/clock.h"
#include "experiment/gains.h"
#include "families/quadquad2drv/calibrations.h"
#include "families/quadquad2drv/simulatoraxis.h"
#include "simulation/motormodel.h"
#include "tests/tuning/experimentbench.h"
#include "tests/tuning/tuningbench.h"
#include "tuning/autotune.h"
#include "tuning/autotunerun.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <optional>
#include <tuple>
#include <utility>

namespace mb::tuning {
namespace {

using namespace std::chrono_literals;

using test::ExperimentBench;
using test::planOf;
using test::print;
using test::rawOf;
using test::tune;

TEST(Autotune, TakesTheOvershootOfUnitSevenAway)
{
    ExperimentBench bench("sim:can", "dmc60c", 7);
    const auto before = bench.run(test::stepTo(Mode::Velocity, 60'000));
    ASSERT_TRUE(before) << before.error().text();
    EXPECT_GT(before->metrics.overshoot.value_or(0.0), 0.1);
    const auto report = tune(bench, planOf(Mode::Velocity));
    ASSERT_TRUE(report) << report.error().text();
    print(*report);
    EXPECT_EQ(report->result, TuneResult::Kept) << report->evidence;
    EXPECT_TRUE(report->stopped);
    const auto after = bench.run(test::stepTo(Mode::Velocity, 60'000));
    ASSERT_TRUE(after);
    EXPECT_LE(after->metrics.overshoot.value_or(1.0), 0.02);
    for (const ScaledGains::Row &row : report->proposed.rows)
        EXPECT_EQ(rawOf(bench, row.key), row.raw) << row.key;
    EXPECT_LE(report->seconds, 60.0); // docs/tuning-results.md#a13
    ASSERT_EQ(bench.journal.tunings.size(), 1U);
    EXPECT_EQ(bench.journal.tunings.front().result, TuneResult::Kept);
    EXPECT_EQ(bench.journal.tunings.front().unit, after->unit);
}

/// The gain that somebody had, and how often the same experiment was tried again.
struct Lossy {
    TuneResult result = TuneResult::Refused;
    tuning::EndReason reason;
    std::ptrdiff_t again = 0;
    bool stopped = false;
    bool sameGains = false;
};

std::ptrdiff_t triedAgain(const ExperimentBench &bench)
{
    return std::ranges::count_if(
        bench.notes, [](const std::string &note) { return note.find("the same again") != std::string::npos; });
}

/// A wire that always loses this share of its frames, and at `worst` a third of them for half a second.
Lossy tuneWithLoss(double share, std::optional<Duration> worst = std::nullopt)
{
    ExperimentBench bench("sim:can", "dmc60c", 7);
    auto &wire = *bench.bench.session.bench(*bench.bench.link);
    wire.setLoss(share);
    Timer begins(bench.bench.clock);
    Timer ends(bench.bench.clock);
    if (worst) {
        begins.startIn(*worst, [&] {
            wire.setLoss(0.3);
            ends.startIn(500ms, [&] { wire.setLoss(share); });
        });
    }
    const auto before = rawOf(bench, "slot0.p");
    const auto report = tune(bench, planOf(Mode::Velocity));
    EXPECT_TRUE(report) << report.error().text();
    return {report->result, report->stopReason, triedAgain(bench), report->stopped, rawOf(bench, "slot0.p") == before};
}

TEST(Autotune, AWireThatLosesNowAndThenIsTriedAgain)
{
    for (const Duration worst : {3s, 6s, 12s}) {
        const Lossy lossy = tuneWithLoss(0.03, worst);
        std::printf("3 %% lost: %td experiments again\n", lossy.again);
        EXPECT_EQ(lossy.result, TuneResult::Kept) << toString(lossy.reason);
        EXPECT_GE(lossy.again, 1);
    }
}

TEST(Autotune, AWireThatLosesAllTheTimeStopsIt)
{
    const Lossy lossy = tuneWithLoss(0.12);
    EXPECT_EQ(lossy.result, TuneResult::Stopped);
    EXPECT_EQ(lossy.reason, tuning::EndReason::Link);
    EXPECT_EQ(lossy.again, 4);
    EXPECT_TRUE(lossy.stopped);
    EXPECT_TRUE(lossy.sameGains);
}

TEST(Autotune, NothingIsTriedAgainThatTheMinuteHasNoRoomFor)
{
    struct Row {
        Duration gone;
        double followed;
        std::ptrdiff_t again;
    };
    for (const Row &row : {Row{0s, 0.0, 4}, {53s, 0.0, 0}, {40s, 20.0, 0}}) {
        ExperimentBench bench("sim:can", "dmc60c", 7);
        AutotuneRun tuning(
            *bench.device, bench.bench.session.stream(*bench.device), planOf(Mode::Velocity), bench.surroundings);
        bench.bench.clock.advance(row.gone);
        bench.bench.session.bench(*bench.bench.link)->setLoss(0.15);
        ExperimentPlan plan = test::stepTo(Mode::Velocity, 60'000);
        plan.seconds = 3.0;
        plan.repeat = 2;
        const auto trial = test::run(bench.bench.clock, tuning.run(plan, row.followed));
        ASSERT_TRUE(trial) << trial.error().text();
        EXPECT_EQ(tuning.report().stopReason, EndReason::Link);
        EXPECT_EQ(triedAgain(bench), row.again);
        const std::string evidence = tuning.report().evidence.english();
        EXPECT_EQ(evidence.ends_with("no time was left to do the same again"), row.again == 0) << evidence;
    }
}

TEST(Autotune, LeavesTheSlotItProvedInAsItWas)
{
    ExperimentBench bench("sim:can", "dmc60c", 5);
    for (const auto &[key, gentle] : {std::pair{"slot1.max_forward", 6553.0}, {"slot1.max_reverse", -6553.0}}) {
        const ParameterChange change = bench.change(key, gentle); // those of the slot that it is for bound its proof
        ASSERT_TRUE(test::run(bench.bench.clock, bench.device->write(change.index, change.raw))) << key;
    }
    std::vector<std::int64_t> other;
    for (const std::string_view key : {"slot1.p", "slot1.i", "slot1.d", "slot1.f", "slot1.max_forward"})
        other.push_back(rawOf(bench, key));
    const auto report = tune(bench, planOf(Mode::Velocity));
    ASSERT_TRUE(report) << report.error().text();
    print(*report);
    EXPECT_EQ(report->result, TuneResult::Kept) << report->evidence;
    std::size_t at = 0;
    for (const std::string_view key : {"slot1.p", "slot1.i", "slot1.d", "slot1.f", "slot1.max_forward"})
        EXPECT_EQ(rawOf(bench, key), other.at(at++)) << key;
}

TEST(Autotune, ThatOwesGainsIsRefusedBeforeAnythingMovesWhereNobodyKeepsThem)
{
    const auto planFor = [](Mode loop, bool propose, bool keep) {
        TunePlan plan = planOf(loop);
        plan.propose = propose;
        plan.keep = keep;
        return plan;
    };
    for (const auto &[link, family, address, plan] :
        {std::tuple{"sim:serial", "supermodified", 4, planFor(Mode::Position, true, false)},
            {"sim:serial", "supermodified", 4, planFor(Mode::Position, false, true)},
            {"sim:can", "dmc60c", 5, planFor(Mode::Velocity, false, true)},
            {"sim:can", "dmc60c", 5, planFor(Mode::Velocity, false, false)}}) {
        ExperimentBench bench(link, family, address);
        bench.surroundings.journal = nullptr;
        EXPECT_TRUE(writesGains(*bench.device, plan) && owesGains(*bench.device, plan)) << family;
        const double place = bench.simulator()->position();
        const auto report = tune(bench, plan);
        ASSERT_FALSE(report) << report->evidence;
        EXPECT_EQ(report.error().fault, Fault::OutOfRange) << report.error().text();
        EXPECT_EQ(bench.simulator()->position(), place) << family;
    }
    ExperimentBench bench;
    EXPECT_FALSE(writesGains(*bench.device, planFor(Mode::Velocity, true, false)));
    EXPECT_FALSE(owesGains(*bench.device, planFor(Mode::Velocity, true, false)));
    ExperimentBench drive("sim:can", "abstractdc", 3);
    EXPECT_FALSE(owesGains(*drive.device, planFor(Mode::Velocity, false, true)))
        << "nobody knows them, and they may stay";
}

TEST(Autotune, ProvesAPositionLoop)
{
    ExperimentBench bench("sim:can", "dmc60c", 5);
    TunePlan plan = planOf(Mode::Position);
    plan.slot = 1;
    const auto report = tune(bench, plan);
    ASSERT_TRUE(report) << report.error().text();
    print(*report);
    EXPECT_EQ(report->result, TuneResult::Kept) << report->evidence;
    EXPECT_LE(report->measured.overshoot.value_or(1.0), 0.05);
}

TEST(Autotune, ProvesTheCurrentLoopOfEachDmc60c)
{
    for (const int number : {5, 7}) {
        ExperimentBench bench("sim:can", "dmc60c", number);
        const auto report = tune(bench, planOf(Mode::Current));
        ASSERT_TRUE(report) << report.error().text();
        print(*report);
        for (const Gate &gate : report->gates)
            std::printf("  %s: %s\n", gate.name.c_str(), gate.detail.english().c_str());
        EXPECT_EQ(report->result, TuneResult::Kept) << report->evidence;
        EXPECT_LE(report->measured.overshoot.value_or(1.0), 0.05);
        const MotorParameters &motor = *motorByName(number == 5 ? "cim" : "775pro");
        const MotorSupply supply;
        const double gain = supply.voltage / (motor.resistance + supply.bridgeResistance);
        EXPECT_NEAR(report->plant.gain, gain, 0.03 * gain);
        EXPECT_TRUE(report->stopped);
        EXPECT_LE(report->seconds, 60.0); // docs/tuning-results.md#a13
        for (const ScaledGains::Row &row : report->proposed.rows)
            EXPECT_EQ(rawOf(bench, row.key), row.raw) << row.key;
    }
}

TEST(Autotune, ACurrentLimitThatIsTooLowForACurrentLoopIsSaidAndNothingIsWritten)
{
    ExperimentBench bench("sim:can", "dmc60c", 7);
    const std::int64_t p = rawOf(bench, "slot0.p");
    TunePlan plan = planOf(Mode::Current);
    plan.limits.current = 2.0;
    const auto report = tune(bench, plan);
    const std::string why = report ? report->evidence.english() : report.error().text();
    std::printf("  %s\n", why.c_str());
    EXPECT_FALSE(report && report->result == TuneResult::Kept);
    EXPECT_NE(why.find(" A"), std::string::npos);
    EXPECT_EQ(rawOf(bench, "slot0.p"), p);
}

TEST(Autotune, ProposesWithoutWritingAnything)
{
    ExperimentBench bench("sim:can", "dmc60c", 7);
    const std::int64_t p = rawOf(bench, "slot0.p");
    TunePlan plan = planOf(Mode::Velocity);
    plan.propose = true;
    const auto report = tune(bench, plan);
    ASSERT_TRUE(report) << report.error().text();
    EXPECT_EQ(report->result, TuneResult::Proposed);
    EXPECT_FALSE(report->proposed.rows.empty());
    EXPECT_EQ(rawOf(bench, "slot0.p"), p);
    EXPECT_TRUE(report->proof.empty());
}

TEST(Autotune, AStalledShaftStopsItWithTheGuardsNameAndWritesNothing)
{
    ExperimentBench bench;
    ASSERT_NE(bench.simulator(), nullptr);
    ASSERT_TRUE(bench.simulator()->disturb("stall", 1.0));
    const std::int64_t p = rawOf(bench, "slot0.p");
    const auto report = tune(bench, planOf(Mode::Velocity));
    ASSERT_TRUE(report) << report.error().text();
    EXPECT_EQ(report->result, TuneResult::Stopped);
    EXPECT_EQ(report->stopReason, tuning::EndReason::NoMotion);
    EXPECT_TRUE(report->stopped);
    EXPECT_EQ(rawOf(bench, "slot0.p"), p);
}

TEST(Autotune, TheUserEndsItAtAnyPointAndTheGainsStay)
{
    for (const double seconds : {0.5, 5.0, 20.0, 33.0}) {
        ExperimentBench bench("sim:can", "dmc60c", 7);
        const std::int64_t p = rawOf(bench, "slot0.p");
        const std::int64_t other = rawOf(bench, "slot1.p");
        Timer timer(bench.bench.clock);
        timer.startIn(
            std::chrono::milliseconds(std::lround(1000.0 * seconds)), [&bench] { bench.interruption.interrupt(); });
        const auto report = tune(bench, planOf(Mode::Velocity));
        ASSERT_TRUE(report) << report.error().text();
        EXPECT_EQ(report->result, TuneResult::Stopped) << seconds;
        EXPECT_EQ(report->stopReason, tuning::EndReason::Interrupted) << seconds;
        EXPECT_TRUE(report->stopped);
        EXPECT_EQ(rawOf(bench, "slot0.p"), p) << seconds;
        EXPECT_EQ(rawOf(bench, "slot1.p"), other) << seconds;
    }
}

TEST(Autotune, TooLittleTravelIsRefusedWithItsReason)
{
    ExperimentBench bench;
    TunePlan plan = planOf(Mode::Velocity);
    plan.limits.travel = 3000.0;
    const auto report = tune(bench, plan);
    if (report) {
        EXPECT_NE(report->result, TuneResult::Kept);
        EXPECT_FALSE(report->evidence.empty());
        std::printf("  %s: %s\n", std::string(toString(report->result)).c_str(), report->evidence.english().c_str());
    } else {
        EXPECT_FALSE(report.error().text().empty());
    }
}

TEST(Autotune, TunesBothLoopsOfAnAbstractDcThatCannotBeRead)
{
    for (const Mode loop : {Mode::Velocity, Mode::Position}) {
        ExperimentBench bench("sim:can", "abstractdc", 3);
        TunePlan plan = planOf(loop);
        const auto refused = tune(bench, plan);
        ASSERT_FALSE(refused) << "what it replaces is not known, which is found out before anything moves";
        EXPECT_EQ(refused.error().fault, Fault::OutOfRange);
        plan.keep = true;
        const auto report = tune(bench, plan);
        ASSERT_TRUE(report) << report.error().text();
        print(*report);
        EXPECT_EQ(report->result, TuneResult::Kept) << report->evidence;
    }
}

/// Nobody knows what it replaces, so that nothing can be put back: half of its first proof is over.
TEST(Autotune, GainsThatReplaceUnknownOnesAreSaidToBeInForceWhereTheirProofIsCutShort)
{
    ExperimentBench bench("sim:can", "abstractdc", 3);
    Timer cutting(bench.bench.clock);
    bench.surroundings.note = [&bench, &cutting](const Message &text) {
        if (text.english().starts_with("proving"))
            cutting.startIn(std::chrono::milliseconds(800), [&bench] { bench.interruption.interrupt(); });
    };
    TunePlan plan = planOf(Mode::Velocity);
    plan.keep = true;
    const auto report = tune(bench, plan);
    ASSERT_TRUE(report) << report.error().text();
    EXPECT_EQ(report->result, TuneResult::Stopped) << report->evidence;
    EXPECT_EQ(report->stopReason, tuning::EndReason::Interrupted);
    EXPECT_NE(report->notPutBack.english().find("those that were tried are in force"), std::string::npos)
        << report->notPutBack;
    EXPECT_NE(report->evidence.english().find("those that were tried are in force"), std::string::npos)
        << report->evidence;
}

TEST(Autotune, GainsThatReplaceUnknownOnesAndAreKeptOweNothing)
{
    ExperimentBench bench("sim:can", "abstractdc", 3);
    TunePlan plan = planOf(Mode::Velocity);
    plan.keep = true;
    const auto report = tune(bench, plan);
    ASSERT_TRUE(report) << report.error().text();
    EXPECT_EQ(report->result, TuneResult::Kept) << report->evidence;
    EXPECT_TRUE(report->notPutBack.empty()) << report->notPutBack;
}

TEST(Autotune, TunesAnAxisOfACalibratedBoard)
{
    for (const Mode loop : {Mode::Velocity, Mode::Position}) {
        ExperimentBench bench("sim:spi", "quadquad2drv", 0);
        using namespace quadquad2drv;
        using namespace quadquad2drv::simulation;
        ASSERT_TRUE(bench.device->knowledge().calibrate(calibration::velocityP, gain::velocityP));
        ASSERT_TRUE(bench.device->knowledge().calibrate(calibration::velocityI, gain::velocityI));
        ASSERT_TRUE(bench.device->knowledge().calibrate(calibration::positionP, gain::positionP));
        ASSERT_TRUE(bench.device->knowledge().calibrate(calibration::positionI, gain::positionI));
        ASSERT_TRUE(bench.device->knowledge().calibrate(calibration::positionD, gain::positionD));
        for (const auto &[key, value] : {std::pair("ch2.limit.power", 0.8), std::pair("history.length", 8.0)}) {
            const ParameterChange change = bench.change(key, value);
            ASSERT_TRUE(test::run(bench.bench.clock, bench.device->write(change.index, change.raw))) << key;
        }
        TunePlan plan = planOf(loop);
        plan.axis = 2;
        plan.keep = true;
        const auto report = tune(bench, plan);
        ASSERT_TRUE(report) << report.error().text();
        print(*report);
        EXPECT_EQ(report->result, TuneResult::Kept) << report->evidence;
    }
}

} // namespace
} // namespace mb::tuning
