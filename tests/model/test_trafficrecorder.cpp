// SPDX-License-Identifier: GPL-3.0-or-later
#include "async/virtualclock.h"
#include "support/freezingclock.h"
#include "support/temporaryfile.h"
#include "traffic/trafficrecorder.h"
#include "transport/canlink.h"

#include <gtest/gtest.h>

#include <thread>

namespace mb {
namespace {

/// A CAN link that loses frames when a test says so.
class LosingLink final : public CanLink {
public:
    explicit LosingLink(Clock &clock, const std::string &name = "can7")
        : CanLink(LinkAddress{"socketcan", name, {}}, clock)
    {
    }
    using CanLink::deliver;
    void loseInABatch(std::uint64_t frames)
    {
        countLost(frames);
        endBatch();
    }

private:
    Result<void> doOpen() override { return {}; }
    void doClose() override { }
    Result<void> doSend(const CanFrame &, Priority) override { return {}; }
    [[nodiscard]] std::size_t doBacklog() const override { return 0; }
    [[nodiscard]] int doBitrate() const override { return 0; }
};

TEST(TrafficRecorder, CountsWhatTheLinkLostSinceItsStartAlsoAfterItWasOpenedAgain)
{
    VirtualClock clock;
    LosingLink link(clock);
    ASSERT_TRUE(link.open());
    link.loseInABatch(10);
    test::TemporaryFolder folder;
    const auto recorder = TrafficRecorder::start(link, clock, Duration::zero(), folder.path("run.log"));
    ASSERT_TRUE(recorder);
    EXPECT_EQ((*recorder)->state().lost, 0U);
    link.loseInABatch(3);
    EXPECT_EQ((*recorder)->state().lost, 3U);
    link.close();
    ASSERT_TRUE(link.open());
    ASSERT_EQ(link.counters().lost, 0U);
    link.loseInABatch(5);
    EXPECT_EQ((*recorder)->state().lost, 8U);
    link.close();
    link.closedFor(say("unplugged"));
    ASSERT_TRUE(link.open());
    link.loseInABatch(20);
    EXPECT_EQ((*recorder)->state().lost, 28U);
    (*recorder)->stop();
    link.loseInABatch(1);
    EXPECT_EQ((*recorder)->state().lost, 28U);
}

TEST(TrafficRecorder, AddsWhatTheComputerHasSleptToTheTimeOfDay)
{
    test::FreezingClock clock;
    LosingLink link(clock);
    ASSERT_TRUE(link.open());
    test::TemporaryFolder folder;
    {
        const auto recorder
            = TrafficRecorder::start(link, clock, std::chrono::seconds(1'700'000'000), folder.path("run.log"));
        ASSERT_TRUE(recorder);
        ASSERT_TRUE(link.send(standardFrame(5, {})));
        clock.suspend(std::chrono::hours(2));
        clock.advance(std::chrono::seconds(1));
        ASSERT_TRUE(link.send(standardFrame(5, {})));
    } // is written to its end
    EXPECT_EQ(folder.read("run.log"), "(1700000001.000000) can7 005# T\n(1700007202.000000) can7 005# T\n");
}

TEST(TrafficRecorder, WhatCameBeforeTheComputerSleptAndIsReadAfterItKeepsItsTime)
{
    test::FreezingClock clock;
    LosingLink link(clock);
    ASSERT_TRUE(link.open());
    test::TemporaryFolder folder;
    {
        const auto recorder
            = TrafficRecorder::start(link, clock, std::chrono::seconds(1'700'000'000), folder.path("run.log"));
        ASSERT_TRUE(recorder);
        clock.advance(std::chrono::seconds(1));
        CanFrame frame = standardFrame(5, {});
        frame.time = clock.now() - std::chrono::milliseconds(1);
        clock.suspend(std::chrono::hours(2));
        clock.freeze(std::chrono::milliseconds(10));
        link.deliver(frame);
        frame.time = clock.now();
        link.deliver(frame);
    } // is written to its end
    EXPECT_EQ(folder.read("run.log"), "(1700000001.999000) can7 005# R\n(1700007202.010000) can7 005# R\n");
}

TEST(TrafficRecorder, EndsItsFileOnceHoweverOftenItIsStopped)
{
    VirtualClock clock;
    LosingLink link(clock);
    ASSERT_TRUE(link.open());
    test::TemporaryFolder folder;
    auto recorder = TrafficRecorder::start(link, clock, std::chrono::seconds(1'700'000'000), folder.path("run.asc"));
    ASSERT_TRUE(recorder);
    ASSERT_TRUE(link.send(standardFrame(5, {})));
    (*recorder)->stop();
    const std::uint64_t bytes = (*recorder)->state().bytes;
    ASSERT_TRUE(link.send(standardFrame(5, {}))); // too late
    (*recorder)->stop();
    EXPECT_EQ((*recorder)->state().bytes, bytes);
    EXPECT_EQ((*recorder)->state().frames, 1U);
    auto file = (*recorder)->end();
    recorder->reset(); // has nothing left to stop
    ASSERT_TRUE(file);
    file.reset(); // waits for what is written
    const std::string text = folder.read("run.asc");
    EXPECT_EQ(text.size(), bytes);
    EXPECT_EQ(text.find("End TriggerBlock"), text.rfind("End TriggerBlock"));
    EXPECT_NE(text.find("End TriggerBlock"), std::string::npos);
}

TEST(TrafficRecorder, TellsOnceThatItsFileIsWhole)
{
    VirtualClock clock;
    LosingLink link(clock);
    ASSERT_TRUE(link.open());
    test::TemporaryFolder folder;
    const auto recorder = TrafficRecorder::start(link, clock, Duration::zero(), folder.path("run.log"));
    ASSERT_TRUE(recorder);
    int told = 0;
    const auto listener = (*recorder)->changed().add([&told] { ++told; });
    (*recorder)->stop();
    while (!(*recorder)->state().finished)
        std::this_thread::yield(); // to the thread that writes
    EXPECT_EQ(told, 0);
    clock.advance(std::chrono::seconds(2));
    EXPECT_EQ(told, 1);
}

TEST(TrafficRecorder, WritesEachFrameOnceWithItsTimeItsLinkAndItsDirection)
{
    VirtualClock clock;
    LosingLink link(clock, "can 7");
    ASSERT_TRUE(link.open());
    test::TemporaryFolder folder;
    {
        const auto recorder
            = TrafficRecorder::start(link, clock, std::chrono::seconds(1'700'000'000), folder.path("run.log"));
        ASSERT_TRUE(recorder);
        clock.advance(std::chrono::milliseconds(1500));
        ASSERT_TRUE(link.send(standardFrame(5, {})));
        CanFrame heard = extendedFrame(6, {});
        heard.time = clock.now() + std::chrono::milliseconds(250);
        link.deliver(heard);
    } // is written to its end
    const std::string text = folder.read("run.log");
    EXPECT_EQ(text, "(1700000001.500000) can_7 005# T\n(1700000001.750000) can_7 00000006# R\n");
}

TEST(TrafficRecorder, WhoeverTakesItsFileHasAllOfItAndItIsLeftAlone)
{
    VirtualClock clock;
    LosingLink link(clock);
    ASSERT_TRUE(link.open());
    test::TemporaryFolder folder;
    const auto recorder = TrafficRecorder::start(link, clock, Duration::zero(), folder.path("run.asc"));
    ASSERT_TRUE(recorder);
    ASSERT_TRUE(link.send(standardFrame(5, {})));
    auto file = (*recorder)->end();
    clock.advance(std::chrono::seconds(1));
    file.reset();
    const std::string text = folder.read("run.asc");
    EXPECT_NE(text.find("End TriggerBlock"), std::string::npos);
    {
        const auto left = TrafficRecorder::start(link, clock, Duration::zero(), folder.path("left.asc"));
        ASSERT_TRUE(left);
        ASSERT_TRUE(link.send(standardFrame(5, {})));
    } // nobody has stopped it
    EXPECT_NE(folder.read("left.asc").find("End TriggerBlock"), std::string::npos);
}

} // namespace
} // namespace mb
