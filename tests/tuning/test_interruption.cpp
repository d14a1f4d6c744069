// SPDX-License-Identifier: GPL-3.0-or-later
// STOP, cancel and a signal while nothing runs that they could stop: nothing moves and no gain is written after them.
#include "async/sleep.h"
#include "tests/tuning/tuningbench.h"

#include <algorithm>

namespace mb::tuning {
namespace {

using namespace std::chrono_literals;
using namespace test;

/// Whether the motor was driven before the task has ended.
template <class T> bool drives(ExperimentBench &bench, Task<T> &task)
{
    bool driven = false;
    EXPECT_TRUE(bench.bench.clock.runUntil(
        [&] {
            driven = driven || bench.simulator()->isOutputOn();
            return task.isFinished();
        },
        5min));
    return driven;
}

TEST(Interruption, BeforeTheFirstPushLeavesTheMotorAlone)
{
    for (const Duration moment : {0ms, 50ms, 100ms, 200ms}) {
        ExperimentBench bench;
        auto task = bench.start(stepTo(Mode::Velocity, 60'000.0));
        task.start();
        ASSERT_TRUE(bench.bench.clock.runUntil([&] { return !bench.journal.log.empty(); }, 10s));
        Timer timer(bench.bench.clock);
        timer.startIn(moment, [&bench] { bench.interruption.interrupt(); });
        EXPECT_FALSE(drives(bench, task)) << moment / 1ms << " ms";
        ASSERT_TRUE(task.result()) << task.result().error().text();
        EXPECT_EQ(task.result()->reason, tuning::EndReason::Interrupted);
        EXPECT_TRUE(task.result()->stopped);
    }
}

TEST(Interruption, WhileTheShaftIsWaitedForLeavesTheMotorAlone)
{
    ExperimentBench bench;
    bench.simulator()->disturb("load-torque", -0.5);
    bench.bench.clock.advance(2s);
    auto task = bench.start(stepTo(Mode::Velocity, 60'000.0));
    task.start();
    bench.bench.clock.advance(1s);
    ASSERT_FALSE(task.isFinished());
    bench.interruption.interrupt();
    bench.simulator()->disturb("load-torque", 0.0);
    EXPECT_FALSE(drives(bench, task));
    ASSERT_TRUE(task.result()) << task.result().error().text();
    EXPECT_EQ(task.result()->reason, tuning::EndReason::Interrupted);
}

TEST(Interruption, BeforeTheGainsOfAnExperimentLeavesThemAsTheyAre)
{
    ExperimentBench bench;
    const std::int64_t before = rawOf(bench, "slot0.p");
    ExperimentPlan plan = stepTo(Mode::Velocity, 60'000.0);
    plan.gains = {{bench.bench.index(*bench.device, "slot0.p"), before / 2}};
    plan.keep = Keep::Always;
    bench.surroundings.before = [&bench]() -> Task<void> {
        bench.interruption.interrupt();
        co_return {};
    };
    const auto trial = bench.run(plan);
    ASSERT_TRUE(trial) << trial.error().text();
    EXPECT_EQ(trial->reason, tuning::EndReason::Interrupted);
    EXPECT_EQ(rawOf(bench, "slot0.p"), before);
    EXPECT_TRUE(bench.journal.owed.empty());
}

TEST(Interruption, BeforeTheGainsAreWrittenOwesNothingWhateverTheMotorDoes)
{
    ExperimentBench bench;
    const std::int64_t before = rawOf(bench, "slot0.p");
    ExperimentPlan plan = stepTo(Mode::Velocity, 60'000.0);
    plan.gains = {{bench.bench.index(*bench.device, "slot0.p"), before / 2}};
    bench.journal.whenOwed = [&bench] {
        bench.interruption.interrupt();
        bench.simulator()->setPowered(false);
    };
    const auto trial = bench.run(plan);
    ASSERT_TRUE(trial) << trial.error().text();
    EXPECT_EQ(trial->reason, tuning::EndReason::Interrupted);
    EXPECT_FALSE(trial->stopped) << "nobody hears it";
    EXPECT_TRUE(trial->notPutBack.empty()) << trial->notPutBack.english();
    EXPECT_TRUE(bench.journal.owed.empty());
}

/// Its board begins the zero of a position with an order that gives its motor a current.
TEST(Interruption, BeforeAPositionIsZeroedLeavesTheMotorAlone)
{
    ExperimentBench bench("sim:serial", "supermodified", 4);
    bench.surroundings.before = [&bench]() -> Task<void> {
        bench.interruption.interrupt();
        co_return {};
    };
    ExperimentPlan plan = stepTo(Mode::Position, 200.0);
    plan.slot = 0;
    auto task = bench.start(plan);
    task.start();
    EXPECT_FALSE(drives(bench, task));
    ASSERT_TRUE(task.result()) << task.result().error().text();
    EXPECT_EQ(task.result()->reason, tuning::EndReason::Interrupted);
}

/// The board's search for its scales begins with what no stream tells of.
TEST(Interruption, BeforeASearchForScalesEndsTheTuningAtOnce)
{
    for (const Duration moment : {0ms, 11ms, 13ms, 20ms}) {
        ExperimentBench bench("sim:spi", "quadquad2drv", 0);
        TunePlan plan = planOf(Mode::Velocity);
        plan.keep = true;
        Timer timer(bench.bench.clock);
        bench.surroundings.before = [&]() -> Task<void> {
            timer.startIn(moment, [&bench] { bench.interruption.interrupt(); });
            co_await Sleep(bench.bench.clock, 10ms);
            co_return {};
        };
        const Instant begin = bench.bench.clock.now();
        auto task = autotune(*bench.device, bench.bench.session.stream(*bench.device), plan, bench.surroundings);
        task.start();
        EXPECT_FALSE(drives(bench, task)) << moment / 1ms << " ms";
        ASSERT_TRUE(task.result()) << task.result().error().text();
        EXPECT_EQ(task.result()->result, TuneResult::Stopped);
        EXPECT_EQ(task.result()->stopReason, tuning::EndReason::Interrupted);
        EXPECT_TRUE(task.result()->stopped);
        EXPECT_LT(bench.bench.clock.now() - begin, 10s);
    }
}

TEST(Interruption, WhileAProposalIsOnlyComputedEndsTheTuningToo)
{
    TunePlan plan = planOf(Mode::Velocity);
    plan.propose = true;
    ExperimentBench whole;
    const auto report = tune(whole, plan);
    ASSERT_TRUE(report) << report.error().text();
    ASSERT_EQ(report->result, TuneResult::Proposed);
    ExperimentBench bench;
    auto task = autotune(*bench.device, bench.bench.session.stream(*bench.device), plan, bench.surroundings);
    task.start();
    ASSERT_TRUE(bench.bench.clock.runUntil(
        [&] { return bench.journal.completed.size() == whole.journal.completed.size(); }, 2min));
    ASSERT_FALSE(task.isFinished());
    bench.interruption.interrupt();
    EXPECT_FALSE(drives(bench, task));
    ASSERT_TRUE(task.result()) << task.result().error().text();
    EXPECT_EQ(task.result()->result, TuneResult::Stopped);
    EXPECT_EQ(task.result()->stopReason, tuning::EndReason::Interrupted);
    EXPECT_TRUE(task.result()->stopped);
    EXPECT_TRUE(task.result()->proposed.changes.empty());
}

/// A tuning whose second proof has just stopped its motor.
struct Proven {
    Proven()
    {
        plan.aim = Aim::Calm;
        task = autotune(*bench.device, stream, plan, bench.surroundings);
        task.start();
        EXPECT_TRUE(bench.bench.clock.runUntil([this] { return proofs() == 2 && stream.isRunning(); }, 2min));
        EXPECT_TRUE(bench.bench.clock.runUntil([this] { return !stream.isRunning(); }, 2min));
    }
    [[nodiscard]] long proofs() const
    {
        return std::count_if(bench.notes.begin(), bench.notes.end(),
            [](const std::string &note) { return note.starts_with("proving"); });
    }

    ExperimentBench bench{"sim:can", "dmc60c", 7};
    SetPointStream &stream = bench.bench.session.stream(*bench.device);
    std::int64_t p = rawOf(bench, "slot0.p");
    std::int64_t other = rawOf(bench, "slot1.p");
    TunePlan plan = planOf(Mode::Velocity);
    Task<TuneReport> task;
};

TEST(Interruption, AfterTheLastStepOfTheLastProofKeepsNoGains)
{
    Proven proven;
    proven.bench.interruption.interrupt();
    ASSERT_TRUE(proven.bench.bench.clock.runUntil([&] { return proven.task.isFinished(); }, 2min));
    ASSERT_TRUE(proven.task.result()) << proven.task.result().error().text();
    EXPECT_EQ(proven.task.result()->result, TuneResult::Stopped) << proven.task.result()->evidence;
    EXPECT_EQ(proven.task.result()->stopReason, tuning::EndReason::Interrupted);
    EXPECT_TRUE(proven.task.result()->stopped);
    EXPECT_EQ(rawOf(proven.bench, "slot0.p"), proven.p);
    EXPECT_EQ(rawOf(proven.bench, "slot1.p"), proven.other);
    EXPECT_TRUE(proven.bench.journal.owed.empty());
}

TEST(Interruption, WhileWhatWasProvenIsWrittenTakesItBack)
{
    Proven proven;
    const ParameterIndex p = proven.bench.bench.index(*proven.bench.device, "slot0.p");
    const auto known = [&] { return proven.bench.device->parameters().entry(p).raw.value_or(-1); };
    ASSERT_TRUE(proven.bench.bench.clock.runUntil([&] { return known() != proven.p; }, 2min));
    ASSERT_FALSE(proven.task.isFinished());
    proven.bench.interruption.interrupt();
    ASSERT_TRUE(proven.bench.bench.clock.runUntil([&] { return proven.task.isFinished(); }, 2min));
    ASSERT_TRUE(proven.task.result()) << proven.task.result().error().text();
    EXPECT_EQ(proven.task.result()->result, TuneResult::Stopped) << proven.task.result()->evidence;
    EXPECT_EQ(proven.task.result()->stopReason, tuning::EndReason::Interrupted);
    EXPECT_TRUE(proven.task.result()->notPutBack.empty());
    EXPECT_EQ(rawOf(proven.bench, "slot0.p"), proven.p);
    EXPECT_TRUE(proven.bench.journal.owed.empty());
}

} // namespace
} // namespace mb::tuning
