// SPDX-License-Identifier: GPL-3.0-or-later
#include "async/sleep.h"
#include "async/virtualclock.h"
#include "model/operation.h"
#include "model/snapshot.h"

#include <gtest/gtest.h>

#include <optional>
#include <utility>

namespace mb {
namespace {

using namespace std::chrono_literals;

struct Job {
    VirtualClock clock;
    std::unique_ptr<Operation> operation = std::make_unique<Operation>(clock, say("Work"));
    std::optional<Result<int>> result;
    int alive = 0;

    [[nodiscard]] OperationStatus::State state() const { return operation->status().state; }
    void start(Task<int> task)
    {
        operation->run<int>(std::move(task), [this](Result<int> ended) { result = std::move(ended); });
    }
};

struct Alive {
    explicit Alive(int &number)
        : count(number)
    {
        ++count;
    }
    Alive(const Alive &) = delete;
    Alive &operator=(const Alive &) = delete;
    ~Alive() { --count; }
    int &count;
};

Task<int> work(Clock &clock, Progress &progress, int &alive, bool critical)
{
    const Alive here(alive);
    progress.step(say("first"), 0, 2);
    if (critical)
        progress.mayInterrupt(false);
    co_await Sleep(clock, 1s);
    progress.mayInterrupt(true);
    progress.part(3, PartState::Done);
    progress.step(say("second"), 1, 2);
    co_await Sleep(clock, 1s);
    progress.log(Severity::Good, say("finished"));
    co_return 42;
}

Task<int> broken(Clock &clock)
{
    co_await Sleep(clock, 1s);
    co_return fail(Fault::Refused, say("no"));
}

Task<int> holding(Clock &clock, int &alive)
{
    const Alive here(alive);
    co_return co_await broken(clock);
}

TEST(Operation, HoldsNothingMoreWhenItAnswersAlsoWhereItFailedInTheMiddle)
{
    Job job;
    job.start(holding(job.clock, job.alive));
    ASSERT_EQ(job.alive, 1);
    job.clock.advance(2s);
    ASSERT_TRUE(job.result);
    EXPECT_EQ(job.result->error().fault, Fault::Refused);
    EXPECT_EQ(job.alive, 0);
}

TEST(Operation, AnswersWhenItIsDismissedEvenInAPartThatMustNotBeCut)
{
    Job job;
    job.start(work(job.clock, *job.operation, job.alive, true));
    job.clock.advance(500ms);
    EXPECT_FALSE(job.operation->cancel());
    job.operation->dismiss({Fault::LinkLost, say("the device is gone")});
    EXPECT_EQ(job.state(), OperationStatus::State::Failed);
    EXPECT_EQ(job.alive, 0);
    ASSERT_TRUE(job.result);
    ASSERT_FALSE(*job.result);
    EXPECT_EQ(job.result->error().detail, "the device is gone");
    job.operation->dismiss({Fault::Refused, say("again")});
    EXPECT_EQ(job.operation->status().error.detail, "the device is gone");
}

TEST(Operation, TellsHowFarItIsAndHowItEnded)
{
    Job job;
    job.start(work(job.clock, *job.operation, job.alive, false));
    EXPECT_TRUE(job.operation->isRunning());
    job.clock.advance(1500ms);
    EXPECT_EQ(job.operation->status().step, "second");
    EXPECT_EQ(job.operation->status().done, 1);
    EXPECT_EQ(job.operation->status().parts.at(3), PartState::Done);
    const auto revision = job.operation->revision();
    job.clock.advance(1s);
    EXPECT_GT(job.operation->revision(), revision);
    EXPECT_EQ(job.state(), OperationStatus::State::Done);
    EXPECT_EQ(job.operation->status().endedAt, Instant{} + 2s);
    ASSERT_TRUE(job.result);
    EXPECT_EQ(*job.result, 42);
    ASSERT_EQ(job.operation->status().log.size(), 1U);
    EXPECT_EQ(job.operation->status().log[0].time, Instant{} + 2s);
}

TEST(Operation, KeepsTheErrorOfAFailure)
{
    Job job;
    job.start(broken(job.clock));
    job.clock.advance(2s);
    EXPECT_EQ(job.state(), OperationStatus::State::Failed);
    EXPECT_EQ(job.operation->status().error.fault, Fault::Refused);
    EXPECT_EQ(job.operation->status().error.text(), "no");
    EXPECT_FALSE(*job.result);
}

TEST(Operation, EndsACancelledJobLaterAndOnce)
{
    Job job;
    job.start(work(job.clock, *job.operation, job.alive, false));
    job.clock.advance(500ms);
    EXPECT_TRUE(job.operation->cancel());
    EXPECT_EQ(job.alive, 1) << "cancelling is posted";
    job.clock.advance(0s);
    EXPECT_EQ(job.alive, 0);
    EXPECT_EQ(job.state(), OperationStatus::State::Cancelled);
    ASSERT_TRUE(job.result);
    EXPECT_EQ(job.result->error().fault, Fault::Cancelled);
    job.result.reset();
    EXPECT_FALSE(job.operation->cancel()) << "it has ended";
    job.clock.advance(10s);
    EXPECT_FALSE(job.result);
}

TEST(Operation, DoesNotCutWhatMustNotBeCut)
{
    Job job;
    job.start(work(job.clock, *job.operation, job.alive, true));
    EXPECT_FALSE(job.operation->cancel());
    job.clock.advance(500ms);
    EXPECT_FALSE(job.operation->cancel());
    EXPECT_EQ(job.state(), OperationStatus::State::Running);
    job.clock.advance(1s);
    EXPECT_TRUE(job.operation->cancel());
    job.clock.advance(0s);
    EXPECT_EQ(job.state(), OperationStatus::State::Cancelled);
}

TEST(Operation, MayBeDestroyedByItsOwnCallback)
{
    Job job;
    bool called = false;
    job.operation->run<int>(work(job.clock, *job.operation, job.alive, false), [&](const Result<int> &) {
        job.operation.reset();
        called = true;
    });
    job.clock.advance(3s);
    EXPECT_TRUE(called);
    EXPECT_FALSE(job.operation);
}

TEST(Operation, EndsItsTaskWithItself)
{
    Job job;
    job.start(work(job.clock, *job.operation, job.alive, false));
    job.clock.advance(500ms);
    job.operation.reset();
    EXPECT_EQ(job.alive, 0);
    EXPECT_EQ(job.clock.armed(), 0U);
    job.clock.advance(10s);
    EXPECT_FALSE(job.result);
}

TEST(Snapshot, TellsTheNewestOperationOfADevice)
{
    Snapshot shot;
    for (const auto &[id, device] : {std::pair(1U, 7U), {2U, 8U}, {3U, 7U}, {4U, 8U}, {5U, 9U}})
        shot.operations.push_back({{id}, {device}, {}, {}});
    ASSERT_TRUE(shot.operation({7}));
    EXPECT_EQ(shot.operation({7})->id, OperationId{3});
    EXPECT_EQ(shot.operation({8})->id, OperationId{4});
    EXPECT_EQ(shot.operation({10}), nullptr);
}

TEST(Snapshot, FindsDevicesByTheirIdAndLinksByTheirAddressAndNobodyElse)
{
    Snapshot snapshot;
    EXPECT_EQ(snapshot.device({1}), nullptr);
    EXPECT_EQ(snapshot.link("sim:can"), nullptr);
    snapshot.devices.resize(2);
    snapshot.devices[0].id = {3};
    snapshot.devices[1].id = {1};
    snapshot.links.resize(2);
    snapshot.links[0].address = "sim:spi";
    snapshot.links[1].address = "sim:can";
    EXPECT_EQ(snapshot.device({1}), &snapshot.devices[1]);
    EXPECT_EQ(snapshot.device({3}), &snapshot.devices[0]);
    EXPECT_EQ(snapshot.device({2}), nullptr);
    EXPECT_EQ(snapshot.link("sim:can"), &snapshot.links[1]);
    EXPECT_EQ(snapshot.link("sim:serial"), nullptr);
}

} // namespace
} // namespace mb
