// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiment/gains.h"
#include "families/abstractdc/simulatoroptions.h"
#include "tests/tuning/experimentbench.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

namespace mb::tuning {
namespace {

using namespace std::chrono_literals;
using test::ExperimentBench;
using test::run;
using test::stepTo;

void expectDone(const Result<Trial> &trial)
{
    ASSERT_TRUE(trial) << trial.error().detail;
    EXPECT_EQ(trial->reason, tuning::EndReason::Done) << trial->detail;
    EXPECT_TRUE(trial->stopped);
    EXPECT_TRUE(trial->simulated);
}

TEST(Experiment, AVelocityStepOfTheWellTunedUnitOvershootsLittleAndOfTheOtherMuch)
{
    ExperimentBench good;
    const auto five = good.run(stepTo(Mode::Velocity, 60'000.0));
    expectDone(five);
    EXPECT_LE(five->metrics.overshoot.value_or(1.0), 0.06);
    EXPECT_NEAR(five->metrics.sse.value_or(1.0), 0.0, 0.01);
    EXPECT_TRUE(five->metrics.settle);
    EXPECT_GT(five->metrics.peakCurrent.value_or(0.0), 1.0);
    EXPECT_GT(five->samples, 100U);
    EXPECT_EQ(five->lost, 0U);

    ExperimentBench bad("sim:can", "dmc60c", 7);
    const auto seven = bad.run(stepTo(Mode::Velocity, 200'000.0));
    expectDone(seven);
    EXPECT_NEAR(seven->metrics.overshoot.value_or(0.0), 0.20, 0.05);
}

TEST(Experiment, IsBoundedByTheLimitsOfItsOwnGains)
{
    ExperimentBench bench;
    ExperimentPlan plan = stepTo(Mode::Velocity, 60'000.0);
    plan.seconds = 0.5;
    plan.gains = {bench.change("slot0.max_forward", 6553.0)};
    const auto gentle = bench.run(plan);
    expectDone(gentle);
    EXPECT_NEAR(gentle->envelope.duty.value_or(1.0), 0.2, 1e-3);
    EXPECT_GT(gentle->metrics.saturated.value_or(0.0), 0.2);
    EXPECT_TRUE(gentle->has(flag::saturated));
}

TEST(Experiment, AHoldThatEndsByItselfLastsUntilTheLoopIsWhereItWillRest)
{
    ExperimentBench bench("sim:can", "dmc60c", 7);
    ExperimentPlan plan = stepTo(Mode::Velocity, 60'000.0);
    plan.repeat = 2;
    plan.gains = {bench.change("slot0.p", 0.53871),
        bench.change("slot0.i", 0.00084)}; // turns round 3 % short of its target, then creeps
    const auto trial = bench.run(plan);
    expectDone(trial);
    EXPECT_LE(trial->errors.settle.value_or(1.0), 0.3); // 0.57 when one was cut off on its way, and 0.03 of the end
    EXPECT_LE(trial->errors.sse.value_or(1.0), 0.01);
}

TEST(Experiment, AHoldEndsByItselfAlsoWhereALoopRestsBesideItsTarget)
{
    ExperimentBench bench;
    ExperimentPlan plan = stepTo(Mode::Velocity, 60'000.0);
    plan.gains = {bench.change("slot0.i", 0.0)};
    const auto trial = bench.run(plan);
    expectDone(trial);
    EXPECT_GE(trial->metrics.sse.value_or(0.0), 0.05);
    ASSERT_FALSE(trial->holds.empty());
    EXPECT_LE(trial->holds.front().to - trial->holds.front().from, 5.0);
}

TEST(Experiment, AMotorThatItsIntegralTakesLongToBreakAwayIsWaitedFor)
{
    ExperimentBench bench;
    const auto trial = bench.run(stepTo(Mode::Velocity, 1000.0));
    expectDone(trial);
    EXPECT_FALSE(trial->has(flag::didNotMove));
    EXPECT_NEAR(trial->metrics.sse.value_or(1.0), 0.0, 0.1);
}

TEST(Experiment, AnEncoderThatDiesInTheStepIsNoLoopThatHasSettled)
{
    for (const Mode mode : {Mode::Velocity, Mode::Position}) {
        ExperimentBench bench;
        ExperimentPlan plan = stepTo(mode, 20'000.0);
        plan.slot = mode == Mode::Position ? 1 : 0;
        expectDone(bench.run(plan)); // its direction is known now
        auto task = bench.start(plan);
        task.start();
        ASSERT_TRUE(bench.bench.clock.runUntil([&] { return bench.simulator()->speed() > 3000.0; }, 10s));
        ASSERT_TRUE(bench.simulator()->disturb("encoder-dead", 1.0));
        ASSERT_TRUE(bench.bench.clock.runUntil([&] { return task.isFinished(); }, 20s));
        ASSERT_TRUE(task.result()) << task.result().error().text();
        EXPECT_EQ(task.result()->reason, tuning::EndReason::NoMotion) << toString(mode);
    }
}

TEST(Experiment, APositionStepStartsAtThePresentPositionAndComesBack)
{
    ExperimentBench bench;
    const double before = bench.device->telemetry()->latest(*bench.device->telemetry()->find("position"))->value;
    const auto trial = bench.run(stepTo(Mode::Position, before + 8000.0));
    expectDone(trial);
    EXPECT_EQ(trial->stimulus.from, before);
    EXPECT_NEAR(trial->metrics.sse.value_or(1.0), 0.0, 0.02);
    EXPECT_TRUE(trial->metrics.undershoot);
    EXPECT_NEAR(bench.simulator()->position(), before, 200.0);
}

TEST(Experiment, AStepThatAsksForMoreThanThereIsSaysSo)
{
    ExperimentBench bench;
    const auto easy = bench.run(stepTo(Mode::Velocity, 20'000.0));
    expectDone(easy);
    EXPECT_FALSE(easy->has(flag::saturated));
    ExperimentPlan plan = stepTo(Mode::Velocity, 20'000.0);
    plan.gains = {bench.change("slot0.p", 20.0)};
    const auto hard = bench.run(plan);
    ASSERT_TRUE(hard) << hard.error().text();
    EXPECT_GT(hard->metrics.saturated.value_or(0.0), 0.02);
    EXPECT_TRUE(hard->has(flag::saturated)) << "its shape is that of the limit, not of the gains";
}

TEST(Experiment, AStepOfFewCountsIsMarkedAsTooCoarse)
{
    ExperimentBench bench;
    const double before = bench.device->telemetry()->latest(*bench.device->telemetry()->find("position"))->value;
    const auto small = bench.run(stepTo(Mode::Position, before + 45.0));
    ASSERT_TRUE(small) << small.error().text();
    EXPECT_TRUE(small->has(flag::lowResolution));
    const auto large = bench.run(stepTo(Mode::Position, before + 2000.0));
    ASSERT_TRUE(large) << large.error().text();
    EXPECT_FALSE(large->has(flag::lowResolution));
}

TEST(Experiment, AMotorThatALoadPullsOneWayIsMarkedAsNotSymmetric)
{
    ExperimentBench bench;
    ExperimentPlan plan = stepTo(Mode::Velocity, 40'000.0);
    plan.gains = {bench.change("slot0.i", 0.0)};
    const auto even = bench.run(plan);
    ASSERT_TRUE(even) << even.error().text();
    EXPECT_FALSE(even->has(flag::asymmetric));
    ASSERT_TRUE(bench.simulator()->disturb("load-torque", 0.03));
    const auto pulled = bench.run(plan);
    expectDone(pulled);
    EXPECT_TRUE(pulled->has(flag::asymmetric));
}

TEST(Experiment, AStepThatALimitSwitchKeepsFromMovingIsMarkedSo)
{
    ExperimentBench bench;
    const ExperimentPlan plan = stepTo(Mode::Velocity, 20'000.0);
    const auto free = bench.run(plan);
    expectDone(free);
    EXPECT_FALSE(free->has(flag::limitSwitch));
    ASSERT_TRUE(bench.simulator()->disturb("forward-limit", 1.0));
    const auto met = bench.run(plan);
    ASSERT_TRUE(met) << met.error().text();
    EXPECT_TRUE(met->has(flag::limitSwitch));
    EXPECT_TRUE(met->has(flag::didNotMove)) << "the unit applies no duty, so nothing pushes";
}

TEST(Experiment, DoesNotBeginWhereALoadHoldsTheUnitAwayFromItsStart)
{
    ExperimentBench bench;
    ExperimentPlan plan = stepTo(Mode::Velocity, 40'000.0);
    plan.gains = {bench.change("slot0.i", 0.0)};
    expectDone(bench.run(plan)); // it knows which way its sensor counts
    ASSERT_TRUE(bench.simulator()->disturb("load-torque", 0.2));
    bench.bench.clock.advance(1s); // it turns
    const auto trial = bench.run(plan);
    ASSERT_TRUE(trial) << trial.error().text();
    EXPECT_TRUE(trial->has(flag::aborted));
    EXPECT_NE(trial->detail.english().find("away from where the experiment begins"), std::string::npos)
        << trial->detail;
    EXPECT_TRUE(trial->stopped);
    EXPECT_FALSE(bench.simulator()->isOutputOn());
}

struct Unit {
    std::string_view link;
    std::string_view family;
    int address;
    Mode mode;
    double to;
};

class EveryFamily : public testing::TestWithParam<Unit> { };

TEST_P(EveryFamily, RunsAStepThatEndsStoppedAndMeasured)
{
    const Unit &unit = GetParam();
    ExperimentBench bench(unit.link, unit.family, unit.address);
    const auto trial = bench.run(stepTo(unit.mode, unit.to));
    if (unit.family == "dmc60c" || unit.mode != Mode::Position) {
        expectDone(trial);
    } else {
        ExperimentPlan plan = stepTo(unit.mode, unit.to);
        ASSERT_TRUE(trial) << trial.error().detail;
    }
    ASSERT_TRUE(trial);
    EXPECT_EQ(trial->reason, tuning::EndReason::Done) << trial->detail;
    EXPECT_TRUE(trial->metrics.rise) << unit.family;
    EXPECT_TRUE(trial->metrics.sse) << unit.family;
    EXPECT_FALSE(trial->has(flag::didNotMove));
    EXPECT_FALSE(bench.simulator()->isOutputOn());
    std::printf("%-14s %-9s rise %.3f s  overshoot %.1f %%  settle %.3f s  sse %.2f %%\n",
        std::string(unit.family).c_str(), std::string(toString(unit.mode)).c_str(), trial->metrics.rise.value_or(0.0),
        trial->metrics.overshoot.value_or(-1.0) * 100.0, trial->metrics.settle.value_or(-1.0),
        trial->metrics.sse.value_or(-1.0) * 100.0);
}

INSTANTIATE_TEST_SUITE_P(OfTheBench, EveryFamily,
    testing::Values(Unit{"sim:can", "dmc60c", 5, Mode::Velocity, 60'000.0},
        Unit{"sim:can", "dmc60c", 5, Mode::Position, 8000.0}, Unit{"sim:can", "abstractdc", 3, Mode::Velocity, 4000.0},
        Unit{"sim:can", "abstractdc", 3, Mode::Position, 2000.0},
        Unit{"sim:can", "abstractdc", 3, Mode::Velocity, 2000.0},
        Unit{"sim:can", "abstractdc", 4, Mode::Velocity, 1000.0},
        Unit{"sim:can", "abstractdc", 4, Mode::Position, 500.0},
        Unit{"sim:serial", "supermodified", 4, Mode::Position, 400.0},
        Unit{"sim:serial", "supermodified", 5, Mode::Position, 4000.0},
        Unit{"sim:spi", "quadquad2drv", 0, Mode::Velocity, 1000.0},
        Unit{"sim:spi", "quadquad2drv", 0, Mode::Position, 1000.0}),
    [](const auto &row) {
        return std::string(row.param.family) + std::to_string(row.param.address) + std::string(toString(row.param.mode))
            + std::to_string(static_cast<int>(row.param.to));
    });

TEST(Experiment, RunsOnEveryAxisOfABoard)
{
    for (const int axis : {1, 2, 3, 4}) {
        ExperimentBench bench("sim:spi", "quadquad2drv", 0);
        ExperimentPlan plan = stepTo(Mode::Velocity, 2000.0);
        plan.axis = axis;
        const auto trial = bench.run(plan);
        ASSERT_TRUE(trial) << trial.error().text();
        EXPECT_EQ(trial->reason, tuning::EndReason::Done) << axis << ": " << trial->detail;
        EXPECT_TRUE(trial->metrics.rise) << axis;
    }
}

TEST(Experiment, AnOpenLoopWithoutATellingDutyIsNotTakenForAReversedSensor)
{
    ExperimentBench bench("sim:spi", "quadquad2drv", 0);
    for (const double duty : {0.2, -0.2}) {
        ExperimentPlan plan = stepTo(Mode::Duty, duty);
        plan.seconds = 0.5;
        const auto trial = bench.run(plan);
        ASSERT_TRUE(trial) << trial.error().text();
        EXPECT_EQ(trial->reason, tuning::EndReason::Done) << trial->detail;
    }
}

TEST(Experiment, IsTheSameEveryTime)
{
    const auto run = [] {
        ExperimentBench bench;
        return bench.run(stepTo(Mode::Velocity, 60'000.0)).value_or(Trial());
    };
    const Trial one = run();
    const Trial two = run();
    EXPECT_EQ(one.metrics, two.metrics);
    EXPECT_EQ(one.signals, two.signals);
    EXPECT_FALSE(one.signals.empty());
}

/// The error of a loop that follows a chirp swings too, and grows with the frequency.
TEST(Experiment, AChirpIsNoOscillationOfTheLoopOnAnyFamily)
{
    for (const Unit &unit :
        {Unit{"sim:can", "dmc60c", 7, Mode::Velocity, 40'000.0}, Unit{"sim:can", "dmc60c", 5, Mode::Position, 8000.0},
            Unit{"sim:can", "abstractdc", 3, Mode::Velocity, 4000.0},
            Unit{"sim:spi", "quadquad2drv", 0, Mode::Position, 1000.0},
            Unit{"sim:serial", "supermodified", 4, Mode::Position, 400.0}}) {
        ExperimentBench bench(unit.link, unit.family, unit.address);
        ExperimentPlan plan = stepTo(unit.mode, unit.to);
        plan.profile = Profile::Chirp;
        const auto trial = bench.run(plan);
        ASSERT_TRUE(trial) << trial.error().text();
        EXPECT_EQ(trial->reason, tuning::EndReason::Done) << unit.family << ": " << trial->detail;
    }
}

TEST(Experiment, RepeatsTellHowSureTheyAre)
{
    ExperimentBench bench;
    ExperimentPlan plan = stepTo(Mode::Velocity, 60'000.0);
    plan.repeat = 3;
    const auto trial = bench.run(plan);
    expectDone(trial);
    EXPECT_TRUE(trial->errors.rise);
    EXPECT_LT(trial->errors.overshoot.value_or(1.0), 0.05);
}

TEST(Experiment, EveryProfileRunsAndReturns)
{
    for (const Profile profile : {Profile::Square, Profile::Ramp, Profile::Sine, Profile::Chirp, Profile::Prbs}) {
        ExperimentBench bench;
        ExperimentPlan plan = stepTo(Mode::Velocity, 40'000.0);
        plan.profile = profile;
        if (profile != Profile::Chirp)
            plan.seconds = profile == Profile::Prbs ? 6.35 : 4.0;
        const auto trial = bench.run(plan);
        expectDone(trial);
        EXPECT_EQ(trial->metrics.rise.has_value(), profile == Profile::Square) << toString(profile);
        EXPECT_TRUE(trial->metrics.peakCurrent) << toString(profile);
    }
}

TEST(Experiment, GainsAreInForceWhileItRunsAndPutBackToTheBitAfterwards)
{
    ExperimentBench bench;
    const ParameterIndex p = bench.bench.index(*bench.device, "slot0.p");
    const auto before = test::run(bench.bench.clock, bench.device->read(p));
    ExperimentPlan plan = stepTo(Mode::Velocity, 60'000.0);
    plan.gains = {bench.change("slot0.p", 0.5)};
    const auto trial = bench.run(plan);
    expectDone(trial);
    const auto gain = std::find_if(
        trial->gains.begin(), trial->gains.end(), [](const auto &row) { return row.first == "slot0.p"; });
    ASSERT_NE(gain, trial->gains.end());
    EXPECT_NEAR(gain->second.value_or(0.0), 0.5, 1e-4);
    EXPECT_EQ(*test::run(bench.bench.clock, bench.device->read(p)), *before);
    EXPECT_EQ(bench.journal.log, (std::vector<std::string>{"begin", "owe", "settle", "complete"}));
}

TEST(Experiment, KeptGainsAreOwedToNobody)
{
    ExperimentBench bench;
    ExperimentPlan plan = stepTo(Mode::Velocity, 60'000.0);
    plan.gains = {bench.change("slot0.p", 0.5)};
    plan.keep = Keep::Always;
    expectDone(bench.run(plan));
    EXPECT_EQ(bench.journal.log, (std::vector<std::string>{"begin", "release", "complete"}));
    const auto now = test::run(bench.bench.clock, bench.device->read(plan.gains.front().index));
    EXPECT_EQ(*now, plan.gains.front().raw);
}

TEST(Experiment, WithoutANotebookGainsAreNotTriedButAPlainStepIs)
{
    ExperimentBench bench;
    bench.journal.isFull = true;
    ExperimentPlan plan = stepTo(Mode::Velocity, 60'000.0);
    expectDone(bench.run(plan));
    ASSERT_FALSE(bench.notes.empty());
    EXPECT_NE(bench.notes.front().find("the disk is full"), std::string::npos);
    plan.gains = {bench.change("slot0.p", 0.5)};
    EXPECT_FALSE(bench.run(plan));
}

TEST(Experiment, GainsThatNobodyCanReadAreRefusedWithTheRemedyUntilTheyWereWrittenHere)
{
    ExperimentBench bench("sim:can", "abstractdc", 3);
    ExperimentPlan plan = stepTo(Mode::Velocity, 4000.0);
    plan.gains = {bench.change("velocity.p", 100.0)};
    const auto refused = bench.run(plan);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().fault, Fault::OutOfRange);
    EXPECT_NE(refused.error().text().find("keep what is tried"), std::string::npos) << refused.error().detail;
    EXPECT_FALSE(bench.simulator()->isOutputOn());
    plan.gains = {bench.change("current.averaging", 1.0)};
    EXPECT_FALSE(bench.run(plan));
}

TEST(Experiment, ATargetIsJudgedByTheGainsThatItIsTriedWith)
{
    ExperimentBench bench("sim:can", "abstractdc", 5, "abstractdc:5,dialect=D,motor=rs775");
    for (const auto &[key, value] :
        {std::pair("velocity.p", 40'000.0), std::pair("velocity.d", 0.0), std::pair("velocity.divisor", 1.0)}) {
        const ParameterChange gain = bench.change(key, value);
        ASSERT_TRUE(run(bench.bench.clock, bench.device->write(gain.index, gain.raw))) << key;
    }
    const auto plain = bench.run(stepTo(Mode::Velocity, 4000.0));
    ASSERT_FALSE(plain) << "an error of 1 turns the output round";
    EXPECT_EQ(plain.error().fault, Fault::Unsafe);
    ExperimentPlan better = stepTo(Mode::Velocity, 4000.0);
    better.gains
        = {bench.change("velocity.p", 50.0), bench.change("velocity.i", 0.0), bench.change("velocity.divisor", 100.0)};
    better.keep = Keep::Always;
    const auto tried = bench.run(better);
    ASSERT_TRUE(tried) << tried.error().detail; // whatever its guards say of how it turns
    EXPECT_GT(tried->samples, 0);
    ExperimentPlan worse = stepTo(Mode::Velocity, 4000.0);
    worse.gains = {bench.change("velocity.p", 40'000.0), bench.change("velocity.divisor", 1.0)};
    worse.keep = Keep::Always;
    const auto refused = bench.run(worse);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().fault, Fault::Unsafe);
    EXPECT_FALSE(bench.simulator()->isOutputOn());
}

/// Its 16 bits wrap (abstractdc/README.md#wraps), so a target never leads by more than the gains allow; of unknown ones it begins near.
TEST(Experiment, AWeakLoopOfUnknownGainsIsLedFurtherAsItsOutputIsSeenToAllowIt)
{
    for (const double target : {40'000.0, -40'000.0, 150'000.0, -150'000.0}) {
        ExperimentBench bench("sim:can", "abstractdc", 5, "abstractdc:5,dialect=D,motor=rs775");
        const auto moved = bench.run(stepTo(Mode::Velocity, target));
        expectDone(moved);
        ASSERT_FALSE(bench.notes.empty());
        EXPECT_NE(bench.notes.back().find("goes further as its output"), std::string::npos) << bench.notes.back();
        EXPECT_FALSE(moved->has(flag::didNotMove)) << target;
        ASSERT_TRUE(moved->metrics.settle) << target;
        EXPECT_LE(moved->metrics.overshoot.value_or(1.0), 0.05) << target;
        EXPECT_NEAR(moved->metrics.sse.value_or(1.0), 0.0, 0.2) << target; // its integral counts whole units
        EXPECT_FALSE(bench.simulator()->isOutputOn());
    }
}

TEST(Experiment, ASlotOrAModeThatTheFamilyHasNotIsRefused)
{
    ExperimentBench servo("sim:serial", "supermodified", 4);
    const auto refused = servo.run(stepTo(Mode::Velocity, 100.0));
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().text().find("position"), std::string::npos) << refused.error().detail;
}

TEST(Experiment, AGainThatAUnitTakesWhenItStartsNeedsARestartWhereItChanges)
{
    ExperimentBench first("sim:serial", "supermodified", 4, "supermodified:4,dialect=D1");
    const ParameterIndex index = first.bench.index(*first.device, "gain.p");
    ASSERT_TRUE(test::run(first.bench.clock, first.device->read(index)));
    const auto present = first.device->parameters().entry(index).raw;
    ASSERT_TRUE(present);
    EXPECT_FALSE(needsRestart(*first.device, {{index, *present}}));
    EXPECT_TRUE(needsRestart(*first.device, {first.change("gain.d", 3.0), {index, *present + 1}}));
    EXPECT_FALSE(needsRestart(*first.device, {first.change("gain.d", 3.0)}));
    ExperimentBench third("sim:serial", "supermodified", 6, "supermodified:6,dialect=D3");
    EXPECT_FALSE(needsRestart(*third.device, {third.change("gain.p", 3.0)}));
}

TEST(Experiment, AStepOutsideTheEnvelopeIsRefusedWithBothNumbersBeforeAnythingMoves)
{
    ExperimentBench bench;
    ExperimentPlan plan = stepTo(Mode::Position, 8000.0);
    plan.limits.travel = 5000.0;
    const auto refused = bench.run(plan);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().fault, Fault::OutOfRange);
    EXPECT_NE(refused.error().text().find("8000"), std::string::npos) << refused.error().detail;
    EXPECT_NE(refused.error().text().find("5000"), std::string::npos) << refused.error().detail;
    EXPECT_TRUE(bench.journal.log.empty());
    EXPECT_FALSE(bench.simulator()->isOutputOn());
}

TEST(Experiment, AnInterruptionStopsAtOnceAndIsNoFault)
{
    ExperimentBench bench;
    auto task = bench.start(stepTo(Mode::Velocity, 60'000.0));
    task.start();
    ASSERT_TRUE(bench.bench.clock.runUntil([&] { return bench.simulator()->speed() > 50'000.0; }, 10s));
    bench.interruption.interrupt();
    bench.bench.clock.advance(20ms);
    EXPECT_FALSE(bench.simulator()->isOutputOn());
    ASSERT_TRUE(bench.bench.clock.runUntil([&] { return task.isFinished(); }, 20s));
    ASSERT_TRUE(task.result());
    EXPECT_EQ(task.result()->reason, tuning::EndReason::Interrupted);
    EXPECT_TRUE(task.result()->stopped);
    EXPECT_TRUE(task.result()->has(flag::aborted));
}

TEST(Experiment, DestroyedAtAnyMomentItLeavesTheMotorStopped)
{
    for (int moment = 0; moment < 40; ++moment) {
        ExperimentBench bench;
        auto task = bench.start(stepTo(Mode::Velocity, 60'000.0));
        task.start();
        bench.bench.clock.advance(moment * 100ms);
        task.cancel();
        bench.bench.clock.advance(200ms);
        EXPECT_FALSE(bench.simulator()->isOutputOn()) << moment;
    }
}

TEST(Experiment, TheDirectionIsCheckedOnceARunAndItsVerdictKept)
{
    ExperimentBench bench;
    expectDone(bench.run(stepTo(Mode::Velocity, 60'000.0)));
    EXPECT_EQ(bench.device->knowledge().profile().verdicts.at("direction"), DirectionVerdict::Agrees);
    EXPECT_TRUE(bench.directions.find(bench.device->selector(), 1));
    const auto first = bench.bench.clock.now();
    expectDone(bench.run(stepTo(Mode::Velocity, 60'000.0)));
    EXPECT_LT(bench.bench.clock.now() - first, 8s);
}

} // namespace
} // namespace mb::tuning
