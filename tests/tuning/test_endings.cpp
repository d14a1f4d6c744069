// SPDX-License-Identifier: GPL-3.0-or-later
// What an experiment says of its end, and what it leaves in force, when others than its guards end it.
#include "model/bench.h"
#include "tests/tuning/experimentbench.h"
#include "transport/canlink.h"
#include "wire/canframe.h"

#include <atomic>

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
    EXPECT_EQ(trial.reason, "interrupted");
    EXPECT_TRUE(trial.has(flag::aborted));
    EXPECT_EQ(step.inForce(), step.before);
}

TEST(Endings, WhoeverStopsTheMotorInterruptsTheTrial)
{
    StepWithGains step;
    const Trial trial = step.endedBy([&] { step.bench.bench.session.stream(*step.bench.device).stop(); });
    EXPECT_EQ(trial.reason, "interrupted");
    EXPECT_EQ(step.inForce(), step.before);
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
    EXPECT_EQ(trial.reason, "foreign master") << trial.detail;
}

TEST(Endings, ByAnotherMasterAreNamedWhereItComesBetweenTwoPushes)
{
    ExperimentBench bench;
    const Trial trial = endedAtTheFirstPush(bench, [&] { commandElsewhere(bench); });
    EXPECT_EQ(trial.reason, "foreign master") << trial.detail;
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
    EXPECT_EQ(trial.reason, "interrupted") << trial.detail;
}

} // namespace
} // namespace mb::tuning
