// SPDX-License-Identifier: GPL-3.0-or-later
// What an experiment says of its end, and what it leaves in force, when others than its guards end it.
#include "families/supermodifiedvectors.h"
#include "model/bench.h"
#include "tests/tuning/experimentbench.h"
#include "tests/tuning/realunit.h"
#include "transport/canlink.h"
#include "wire/canframe.h"

#include <atomic>
#include <cmath>

namespace mb::tuning {
namespace {

using namespace std::chrono_literals;
using test::ExperimentBench;
using test::run;
using test::stepTo;

/// A step with other gains, that stay where it is done.
struct StepWithGains {
    StepWithGains()
        : p(bench.bench.index(*bench.device, "slot0.p"))
        , before(run(bench.bench.clock, bench.device->read(p)).value_or(-1))
        , plan(stepTo(Mode::Velocity, 60'000.0))
    {
        plan.gains = {{p, before / 2}};
        plan.keep = Keep::WhenDone;
    }
    [[nodiscard]] Trial endedBy(const std::function<void()> &strike)
    {
        auto task = bench.start(plan);
        task.start();
        EXPECT_TRUE(bench.bench.clock.runUntil([&] { return bench.simulator()->speed() > 20'000.0; }, 20s));
        strike();
        EXPECT_TRUE(bench.bench.clock.runUntil([&] { return task.isFinished(); }, 30s));
        return task.result().value_or(Trial());
    }
    [[nodiscard]] std::int64_t inForce() { return run(bench.bench.clock, bench.device->read(p)).value_or(-1); }

    ExperimentBench bench;
    ParameterIndex p;
    std::int64_t before;
    ExperimentPlan plan;
};

TEST(Endings, StopThatIsPressedBeforeItsOrderArrivesIsNotDoneAndTheGainsAreAsBefore)
{
    std::atomic<bool> pressed = false;
    StepWithGains step;
    step.bench.device->gate().setStopGate(&pressed);
    const Trial trial = step.endedBy([&] {
        pressed = true;
        step.bench.bench.clock.advance(25ms);
        step.bench.bench.session.stopAll(StopCause::User);
        pressed = false;
    });
    EXPECT_EQ(trial.reason, tuning::EndReason::Interrupted);
    EXPECT_TRUE(trial.has(flag::aborted));
    EXPECT_EQ(step.inForce(), step.before);
}

TEST(Endings, WhatAStepThatIsCutShortDidNotShowIsNotTold)
{
    StepWithGains step;
    const Trial trial = step.endedBy([&] { step.bench.bench.session.stopAll(StopCause::User); });
    ASSERT_FALSE(trial.holds.empty());
    for (const auto metric : {&Metrics::rise, &Metrics::settle, &Metrics::overshoot, &Metrics::undershoot,
             &Metrics::sse, &Metrics::iae, &Metrics::itae, &Metrics::noise})
        EXPECT_FALSE(trial.metrics.*metric) << *(trial.metrics.*metric);
    EXPECT_TRUE(trial.metrics.peakCurrent); // it flowed
}

TEST(Endings, OfAStepThatIsCutShortSayNothingOfAMotorThatDidNotMove)
{
    ExperimentBench bench;
    ExperimentPlan plan = stepTo(Mode::Velocity, 40'000.0);
    ASSERT_TRUE(bench.run(plan)); // it knows which way its sensor counts
    auto task = bench.start(plan);
    task.start();
    ASSERT_TRUE(bench.bench.clock.runUntil([&] { return bench.simulator()->speed() > 500.0; }, 20s));
    bench.interruption.interrupt();
    ASSERT_TRUE(bench.bench.clock.runUntil([&] { return task.isFinished(); }, 30s));
    const Trial cut = task.result().value_or(Trial());
    EXPECT_EQ(cut.reason, tuning::EndReason::Interrupted);
    ASSERT_EQ(cut.holds.size(), 1U);
    EXPECT_FALSE(cut.has(flag::didNotMove));
}

TEST(Endings, ByAPeakOfCurrentRightAfterTheEdgeSayNothingOfAMotorThatDidNotMove)
{
    ExperimentBench bench;
    ExperimentPlan plan = stepTo(Mode::Velocity, 40'000.0);
    plan.limits.current = 12.0;
    const Result<Trial> trial = bench.run(plan);
    ASSERT_TRUE(trial) << trial.error().text();
    EXPECT_EQ(trial->reason, tuning::EndReason::Current);
    EXPECT_FALSE(trial->has(flag::didNotMove));
}

TEST(Endings, ByTheGuardThatMissesMotionAreOfAMotorThatDidNotMove)
{
    ExperimentBench bench;
    ExperimentPlan plan = stepTo(Mode::Velocity, 40'000.0);
    ASSERT_TRUE(bench.run(plan));
    bench.simulator()->disturb("stall", 1.0);
    const Result<Trial> trial = bench.run(plan);
    ASSERT_TRUE(trial) << trial.error().text();
    EXPECT_EQ(trial->reason, tuning::EndReason::NoMotion);
    EXPECT_TRUE(trial->has(flag::didNotMove));
}

TEST(Endings, ASquareThatIsCutInItsFirstHalfHasMoved)
{
    StepWithGains step;
    step.plan.profile = Profile::Square;
    const Trial trial = step.endedBy([&] { step.bench.bench.session.stopAll(StopCause::User); });
    ASSERT_GT(trial.holds.size(), 1U);
    EXPECT_TRUE(trial.has(flag::aborted));
    EXPECT_FALSE(trial.has(flag::didNotMove));
}

TEST(Endings, RepeatsThatWereWholeAreToldWithoutTheOneThatWasCutShort)
{
    StepWithGains step;
    step.plan.repeat = 3;
    step.plan.seconds = 1.0;
    auto task = step.bench.start(step.plan);
    task.start();
    auto &clock = step.bench.bench.clock;
    const auto rises = [&] { return step.bench.simulator()->speed() > 20'000.0; };
    ASSERT_TRUE(clock.runUntil(rises, 20s));
    ASSERT_TRUE(clock.runUntil([&] { return step.bench.simulator()->speed() < 10'000.0; }, 20s));
    ASSERT_TRUE(clock.runUntil(rises, 20s));
    step.bench.bench.session.stopAll(StopCause::User);
    ASSERT_TRUE(clock.runUntil([&] { return task.isFinished(); }, 30s));
    const Trial cut = task.result().value_or(Trial());
    ASSERT_EQ(cut.holds.size(), 2U);
    StepWithGains alone;
    alone.plan.seconds = 1.0;
    const auto whole = alone.bench.run(alone.plan);
    ASSERT_TRUE(whole) << whole.error().text();
    ASSERT_TRUE(whole->metrics.rise && cut.metrics.rise);
    EXPECT_NEAR(*cut.metrics.rise, *whole->metrics.rise, 0.1 * *whole->metrics.rise);
    EXPECT_NEAR(cut.metrics.sse.value_or(9.0), whole->metrics.sse.value_or(-9.0), 0.05);
    EXPECT_FALSE(cut.errors.rise); // of one run
}

TEST(Endings, WhoeverStopsTheMotorInterruptsTheTrial)
{
    StepWithGains step;
    const Trial trial = step.endedBy([&] { step.bench.bench.session.stream(*step.bench.device).stop(); });
    EXPECT_EQ(trial.reason, tuning::EndReason::Interrupted);
    EXPECT_EQ(step.inForce(), step.before);
}

TEST(Endings, GainsThatCouldNotBePutBackAreSaidAndOwed)
{
    StepWithGains step;
    step.plan.keep = Keep::Never;
    std::vector<std::string> warned;
    step.bench.surroundings.warn = [&](const Message &text) { warned.push_back(text.english()); };
    const Trial trial = step.endedBy([&] {
        step.bench.interruption.interrupt();
        step.bench.simulator()->setPowered(false);
    });
    EXPECT_FALSE(trial.notPutBack.empty());
    ASSERT_FALSE(warned.empty());
    EXPECT_NE(warned.front().find("the gains were not put back"), std::string::npos) << warned.front();
    EXPECT_FALSE(step.bench.journal.owed.empty());
}

TEST(Endings, OverALostLinkPutTheRatesBackWhenItIsThereAgain)
{
    StepWithGains step;
    Device &device = *step.bench.device;
    const ChannelIndex velocity = *device.telemetry()->find("velocity");
    const auto rate = [&] { return device.telemetry()->rate(velocity, device.clock().now()); };
    step.bench.bench.clock.advance(3s);
    const double own = rate();
    const Trial trial = step.endedBy([&] {
        EXPECT_GT(rate(), 1.5 * own);
        step.bench.bench.link->close();
    });
    EXPECT_NE(trial.reason, tuning::EndReason::Done);
    ASSERT_TRUE(step.bench.bench.link->open());
    step.bench.bench.clock.advance(5s);
    EXPECT_NEAR(rate(), own, 0.1 * own);
}

/// Their loop drives the motor: whoever changes them now changes what it does.
TEST(Endings, WhoseMotorIsNotSeenToStandOweTheGains)
{
    StepWithGains step;
    step.plan.keep = Keep::Never;
    const auto other = step.bench.bench.session.bench(*step.bench.bench.link)->hostLink();
    ASSERT_TRUE(other->open());
    Timer timer(step.bench.bench.clock);
    std::function<void()> again = [&] {
        ASSERT_TRUE(dynamic_cast<CanLink &>(*other).send(*canFrameFromText("02060005#0000000010270000")));
        timer.startIn(20ms, again);
    };
    const Trial trial = step.endedBy([&] { timer.startIn(1ms, again); });
    EXPECT_EQ(trial.reason, tuning::EndReason::ForeignMaster);
    EXPECT_EQ(trial.notPutBack.english(), "the motor was not seen to stand");
    EXPECT_EQ(step.inForce(), step.before / 2);
    EXPECT_FALSE(step.bench.journal.owed.empty());
}

TEST(Endings, BeforeItsMotionSayWhatIsNotPutBack)
{
    StepWithGains step;
    step.plan.keep = Keep::Never;
    auto task = step.bench.start(step.plan);
    task.start();
    ASSERT_TRUE(step.bench.bench.clock.runUntil(
        [&] { return !step.bench.journal.log.empty() && step.bench.journal.log.back() == "owe"; }, 20s));
    step.bench.simulator()->setPowered(false);
    ASSERT_TRUE(step.bench.bench.clock.runUntil([&] { return task.isFinished(); }, 30s));
    ASSERT_FALSE(task.result());
    EXPECT_NE(task.result().error().text().find("the gains were not put back"), std::string::npos)
        << task.result().error().text();
}

/// The motor was stopped for that; whatever became of the order, nobody leaves it without a stop behind it.
TEST(Endings, BetweenItsZeroAndItsFirstPushStopTheMotor)
{
    using supermodified::Command;
    ExperimentBench bench("sim:serial", "supermodified", 4);
    std::vector<std::uint8_t> sent;
    const auto find = [&sent](Command command, std::size_t from) {
        const auto frames = supermodified::test::framesIn(sent);
        while (from < frames.size() && !frames[from].is(command))
            ++from;
        return from < frames.size() ? std::optional(from) : std::nullopt;
    };
    const Subscription tap = bench.bench.link->traffic().add([&](const Traffic &traffic) {
        if (traffic.direction == Direction::Sent)
            sent.insert(sent.end(), traffic.bytes.begin(), traffic.bytes.end());
    });
    ExperimentPlan plan = stepTo(Mode::Position, 300.0);
    plan.slot = 0;
    auto task = bench.start(plan);
    task.start();
    ASSERT_TRUE(bench.bench.clock.runUntil([&] { return find(Command::ResetPosition, 0).has_value(); }, 20s));
    bench.simulator()->setPowered(false);
    ASSERT_TRUE(bench.bench.clock.runUntil([&] { return task.isFinished(); }, 30s));
    ASSERT_FALSE(task.result());
    EXPECT_TRUE(find(Command::Stop, *find(Command::ResetPosition, 0)));
}

/// Its targets reach farther than the device counts.
TEST(Endings, OfATargetThatTheDeviceRefusesAreARefusal)
{
    ExperimentBench bench("sim:serial", "supermodified", 4);
    ExperimentPlan plan = stepTo(Mode::Position, 1e10);
    plan.limits.travel = 1e11;
    const Result<Trial> trial = bench.run(plan);
    ASSERT_TRUE(!trial || trial->reason != tuning::EndReason::Done);
    if (trial) {
        EXPECT_EQ(trial->reason, tuning::EndReason::Refused);
        EXPECT_FALSE(trial->detail.empty());
    }
}

/// During the check of the direction, before anything else moves.
Trial endedAtTheFirstPush(ExperimentBench &bench, const std::function<void()> &strike)
{
    auto task = bench.start(stepTo(Mode::Velocity, 60'000.0));
    task.start();
    EXPECT_TRUE(bench.bench.clock.runUntil([&] { return bench.simulator()->isOutputOn(); }, 10s));
    bench.bench.clock.advance(20ms);
    strike();
    EXPECT_TRUE(bench.bench.clock.runUntil([&] { return task.isFinished(); }, 30s));
    const Result<Trial> trial = std::move(task.result());
    EXPECT_TRUE(trial) << trial.error().text();
    return trial.value_or(Trial());
}

void commandElsewhere(ExperimentBench &bench)
{
    const auto other = bench.bench.session.bench(*bench.bench.link)->hostLink();
    ASSERT_TRUE(other->open());
    ASSERT_TRUE(dynamic_cast<CanLink &>(*other).send(*canFrameFromText("02060005#0000000010270000")));
    bench.bench.clock.advance(1ms);
}

TEST(Endings, OfTheFirstPushByAnotherMasterAreNamed)
{
    ExperimentBench bench;
    bench.simulator()->disturb("stall", 1.0); // so it lasts
    const Trial trial = endedAtTheFirstPush(bench, [&] { commandElsewhere(bench); });
    EXPECT_EQ(trial.reason, tuning::EndReason::ForeignMaster) << trial.detail;
}

TEST(Endings, ByAnotherMasterAreNamedWhereItComesBetweenTwoPushes)
{
    ExperimentBench bench;
    const Trial trial = endedAtTheFirstPush(bench, [&] { commandElsewhere(bench); });
    EXPECT_EQ(trial.reason, tuning::EndReason::ForeignMaster) << trial.detail;
}

TEST(Endings, ByARestartAreNamedWhereItComesBetweenTwoPushes)
{
    ExperimentBench bench;
    const Trial trial = endedAtTheFirstPush(bench, [&] {
        ASSERT_TRUE(bench.bench.clock.runUntil([&] { return !bench.simulator()->isOutputOn(); }, 5s));
        bench.simulator()->setPowered(false);
        bench.bench.clock.advance(1ms);
        bench.simulator()->setPowered(true);
    });
    EXPECT_EQ(trial.reason, tuning::EndReason::DeviceRestarted) << trial.detail;
}

TEST(Endings, OfTheFirstPushByStopIsAnInterruption)
{
    std::atomic<bool> pressed = false;
    ExperimentBench bench;
    bench.device->gate().setStopGate(&pressed);
    bench.simulator()->disturb("stall", 1.0);
    const Trial trial = endedAtTheFirstPush(bench, [&] {
        pressed = true;
        bench.bench.clock.advance(25ms);
        bench.bench.session.stopAll(StopCause::User);
        pressed = false;
    });
    EXPECT_EQ(trial.reason, tuning::EndReason::Interrupted) << trial.detail;
}

TEST(Endings, AShaftThatStillTurnsTellsNobodyItsDirection)
{
    ExperimentBench bench;
    bench.simulator()->disturb("load-torque", -0.5);
    bench.bench.clock.advance(2s);
    ASSERT_GT(std::abs(bench.simulator()->speed()), 1000.0);
    const Result<Trial> trial = bench.run(stepTo(Mode::Velocity, 60'000.0));
    EXPECT_FALSE(bench.directions.find(bench.device->selector(), 1));
    const std::string why = trial ? trial->detail.english() : trial.error().text();
    EXPECT_NE(why.find("still turns"), std::string::npos) << why;
}

/// Everything else is heard: without its position travel, speed and direction are watched by nobody, and silence is no rest.
TEST(Endings, APositionThatIsSilentAloneEndsATrial)
{
    StepWithGains step;
    const Trial trial = step.endedBy([&] {
        const ParameterIndex encoderPeriod = step.bench.bench.index(*step.bench.device, "status.encoder.period");
        (void)run(step.bench.bench.clock, step.bench.device->write(encoderPeriod, 30'000));
        step.bench.simulator()->disturb("load-torque", -0.5);
    });
    EXPECT_EQ(trial.reason, tuning::EndReason::Link);
    EXPECT_NE(trial.detail.english().find("no position for"), std::string::npos) << trial.detail.english();
    EXPECT_EQ(trial.notPutBack.english(), "the motor was not seen to stand");
    EXPECT_EQ(step.inForce(), step.before / 2) << "its loop is not changed while the shaft may turn";
    EXPECT_FALSE(step.bench.journal.owed.empty());
}

TEST(Endings, AShaftThatALoadStillTurnsOwesTheGains)
{
    StepWithGains step;
    const Trial trial = step.endedBy([&] {
        step.bench.simulator()->disturb("load-torque", -2.0);
        step.bench.interruption.interrupt();
    });
    EXPECT_EQ(trial.reason, tuning::EndReason::Interrupted);
    EXPECT_TRUE(trial.stopped) << "nothing drives it";
    EXPECT_EQ(trial.notPutBack.english(), "the motor was not seen to stand");
    EXPECT_EQ(step.inForce(), step.before / 2);
    EXPECT_FALSE(step.bench.journal.owed.empty());
}

TEST(Endings, GainsThatReadBackDifferentAreStillOwed)
{
    StepWithGains step;
    test::SimulatedSession &session = step.bench.bench;
    Device &device = *step.bench.device;
    const auto link = session.session.bench(*session.link)->hostLink();
    ASSERT_TRUE(link->open());
    const auto elsewhere = device.family().open(*link, session.clock, device.identity());
    Task<std::int64_t> other;
    Timer insisting(session.clock);
    const std::function<void()> insist = [&] { // another program, again and again
        other = elsewhere->write(step.p, step.before + 7);
        other.start();
        insisting.startIn(300us, insist);
    };
    const Trial trial = step.endedBy([&] {
        insist();
        step.bench.interruption.interrupt();
    });
    EXPECT_TRUE(trial.notPutBack.english().starts_with("slot0.p was written as ")) << trial.notPutBack;
    EXPECT_FALSE(step.bench.journal.owed.empty());
}

TEST(Endings, WithoutAPositionNothingBegins)
{
    ExperimentBench bench;
    const ParameterIndex spacing = bench.bench.index(*bench.device, "status.encoder.period");
    ASSERT_TRUE(run(bench.bench.clock, bench.device->write(spacing, 30'000)));
    bench.bench.clock.advance(1s);
    const auto trial = bench.run(stepTo(Mode::Velocity, 60'000.0));
    ASSERT_FALSE(trial);
    EXPECT_EQ(trial.error().fault, Fault::Timeout);
    EXPECT_NE(trial.error().text().find("does not tell its position"), std::string::npos) << trial.error().text();
    EXPECT_TRUE(bench.journal.log.empty());
}

/// A program that is held up again and again looks late each time; what a guard says of the time is true all the same.
TEST(Endings, ByTheTimeComeWhereEveryLookIsLate)
{
    test::RealUnit unit;
    SetPointStream stream(*unit.device, unit.dated);
    TrialRecorder recorder(*unit.device, stream, Mode::Duty, 1);
    GuardPlan plan;
    plan.envelope.duty = 1.0;
    plan.longest = 1s;
    plan.telemetry = 100ms;
    SetPoint setPoint;
    setPoint.mode = Mode::Duty;
    setPoint.target = 0.1;
    recorder.guard(plan);
    ASSERT_TRUE(stream.start(setPoint, 10s));
    for (int i = 0; i < 100 && stream.isRunning(); ++i) {
        unit.clock.stall(22ms);
        unit.clock.advance(1ms);
    }
    ASSERT_TRUE(recorder.trip()) << stream.reason().english();
    EXPECT_EQ(recorder.trip()->guard, EndReason::Time) << recorder.trip()->detail;
}

/// What is told while the motor runs takes no longer because of the repeats before it.
TEST(Endings, OfAHoldTellWhatItsOwnRepeatHasMeasured)
{
    ExperimentBench bench;
    std::vector<std::size_t> holds;
    std::vector<std::size_t> samples;
    bench.surroundings.measured = [&](const Trial &trial) {
        holds.push_back(trial.holds.size());
        samples.push_back(trial.signals.empty() ? 0 : trial.signals.front().trace.size());
    };
    ExperimentPlan plan = stepTo(Mode::Velocity, 60'000.0);
    plan.repeat = 3;
    const Result<Trial> trial = bench.run(plan);
    ASSERT_TRUE(trial);
    EXPECT_EQ(holds, (std::vector<std::size_t>{1, 1, 1}));
    EXPECT_EQ(trial->holds.size(), 3U);
    ASSERT_EQ(samples.size(), 3U);
    EXPECT_GT(samples[0], 100U);
    EXPECT_LT(samples[2], samples[1] + samples[1] / 2);
    EXPECT_GT(trial->signals.front().trace.size(), 2 * samples[2]) << "all of it in the end";
}

/// Of a ramp, a sine, a chirp or bits nothing is a step response: what is read out of one is only looked for where there is one.
TEST(Endings, OfAProfileWithoutStepsTellNothingWhileTheMotorRuns)
{
    ExperimentBench bench;
    int told = 0;
    bench.surroundings.measured = [&](const Trial &) { ++told; };
    ExperimentPlan plan = stepTo(Mode::Velocity, 60'000.0);
    plan.profile = Profile::Ramp;
    plan.seconds = 3.0;
    const Result<Trial> trial = bench.run(plan);
    ASSERT_TRUE(trial);
    EXPECT_EQ(trial->reason, tuning::EndReason::Done);
    EXPECT_EQ(told, 0);
    EXPECT_EQ(trial->holds.size(), 1U);
    EXPECT_FALSE(trial->metrics.rise);
    EXPECT_TRUE(trial->metrics.peakCurrent);
    EXPECT_TRUE(trial->metrics.dutyChatter);
}

/// Its velocity tells that, not the duty.
TEST(Endings, OfAHoldOfADutyComeWhenTheMotorTurnsSteadily)
{
    ExperimentBench bench;
    const Result<Trial> trial = bench.run(stepTo(Mode::Duty, 0.2));
    ASSERT_TRUE(trial);
    EXPECT_EQ(trial->reason, tuning::EndReason::Done);
    ASSERT_EQ(trial->holds.size(), 1U);
    EXPECT_LT(trial->holds.front().to - trial->holds.front().from, 4.0);
}

} // namespace
} // namespace mb::tuning
