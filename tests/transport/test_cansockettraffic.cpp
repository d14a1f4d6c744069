// SPDX-License-Identifier: GPL-3.0-or-later
// SocketCanLink on the CAN socket of a played kernel: what comes beside its frames, what breaks, what is refused.
#include "cansocketbench.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <string>
#include <utility>
#include <vector>

#include <linux/can/raw.h>
#include <linux/errqueue.h>
#include <sys/socket.h>

namespace mb {
namespace {

using namespace std::chrono_literals;
using test::CanSocket;
using test::rawBytes;
using Three = test::PlayedKernel::Three;

// Receiving

TEST_F(CanSocket, FramesHaveTheKernelsStampAndThatOfTheAdapterIsPutOnItsTimeLine)
{
    open();
    const auto stamped = [&](Duration software, Duration hardware) {
        const auto spec = [](Duration time) { return timespec{time / 1s, (time % std::chrono::seconds(1)) / 1ns}; };
        scm_timestamping stamps{};
        if (software != Duration::zero())
            stamps.ts[0] = spec(dated.unixOffset() + software);
        stamps.ts[1] = spec(1s); // of old kernels
        stamps.ts[2] = spec(hardware);
        kernel.controls.push_back(
            {{SOL_CAN_RAW, SO_RXQ_OVFL, rawBytes(std::uint32_t{5})}, {SOL_SOCKET, SO_TIMESTAMPING, rawBytes(stamps)}});
        put(1);
        loop.runReady();
        return frames.back().time.time_since_epoch();
    };
    EXPECT_EQ(stamped(9'993ms, {}), 9'993ms);
    EXPECT_EQ(stamped(9'995ms, 3s), 9'995ms);
    EXPECT_EQ(stamped(9'996ms, 3s + 500us), 9'995ms + 500us + 100ns) << "100 ppm of the millisecond between";
    EXPECT_EQ(stamped(9'990ms, {}), 9'995ms + 500us + 100ns) << "never backwards";
    EXPECT_EQ(stamped(10'500ms, {}), 10s) << "never ahead";
    clock.advance(1s);
    EXPECT_EQ(stamped({}, {}), 11s) << "when it came";
    EXPECT_EQ(link->counters().lost, 0U) << "what another layer tells is not meant for the socket";
}

TEST_F(CanSocket, FramesThatTheKernelDroppedForItAreCountedOnce)
{
    open();
    const auto lostAfter = [&](std::uint32_t total) {
        kernel.controls.push_back(
            {{SOL_CAN_RAW, SO_RXQ_OVFL, rawBytes(std::uint32_t{99})}, {SOL_SOCKET, SO_RXQ_OVFL, rawBytes(total)}});
        put(1);
        loop.runReady();
        return link->counters().lost;
    };
    EXPECT_EQ(lostAfter(5), 5U);
    EXPECT_EQ(lostAfter(5), 5U);
    EXPECT_EQ(lostAfter(6), 6U);
    EXPECT_EQ(lostAfter(4), 6U) << "older than what is known";
    kernel.drops = 9;
    put(1);
    loop.runReady();
    EXPECT_EQ(link->counters().lost, 6U) << "what came was all there was";
    kernel.fullBatches = 1;
    put(1);
    loop.runReady();
    EXPECT_EQ(link->counters().lost, 9U) << "more had come than was read at once";
    kernel.drops = 12;
    link->recount();
    EXPECT_EQ(link->counters().lost, 12U);
    kernel.drops = 20;
    kernel.memoryBytes = 32;
    link->recount();
    EXPECT_EQ(link->counters().lost, 12U) << "an older kernel does not tell it";
    kernel.memoryBytes = 36;
    kernel.drops.reset();
    link->recount();
    EXPECT_EQ(link->counters().lost, 12U);
    for (const std::uint32_t total : {0x70000000U, 0xE0000000U, 7U})
        (void)lostAfter(total);
    EXPECT_EQ(link->counters().lost, 0x100000007U) << "its counter has 32 bits";
    link->close();
    ASSERT_TRUE(link->open());
    EXPECT_EQ(lostAfter(2), 2U) << "another socket counts anew";
}

TEST_F(CanSocket, OneLookTakesWhatWaitsAndAfterSixteenFullOnesOthersGetTheirTurn)
{
    open();
    put(1);
    put(2);
    loop.runReady();
    EXPECT_EQ(kernel.looks, 1);
    EXPECT_EQ(batches, 1);
    EXPECT_EQ(frames.size(), 2U);
    kernel.fullBatches = 100;
    put(3);
    while (batches < 2)
        loop.turn();
    EXPECT_EQ(batches, 1 + 16);
    clock.advance(1ms);
    link->catchUp();
    EXPECT_EQ(batches, 1 + 32) << "enough: they came in this moment";
    kernel.fullBatches = 3;
    loop.runReady();
    EXPECT_EQ(batches, 1 + 32 + 3 + 1);
    EXPECT_EQ(frames.back().id, 3U);
}

TEST_F(CanSocket, WhatBrokeIsToldOnceAfterTheFramesThatCameBefore)
{
    open();
    std::size_t before = 99;
    subscriptions.push_back(link->stateChanged().add([&](LinkState) { before = frames.size(); }));
    put(1);
    put(2);
    kernel.receiveCauses = {ENETDOWN, 0, EIO};
    loop.runReady();
    EXPECT_EQ(link->state(), LinkState::Lost);
    EXPECT_EQ(link->loss().text(), "can0 was switched off");
    EXPECT_EQ(before, 2U);
    EXPECT_EQ(kernel.looks, 3);
}

TEST_F(CanSocket, ALookThatWasInterruptedIsTakenAgain)
{
    open();
    clock.advance(1s);
    put(1);
    kernel.receiveCauses = {EINTR};
    link->catchUp();
    EXPECT_EQ(frames.size(), 1U);
    EXPECT_EQ(link->state(), LinkState::Open);
}

TEST_F(CanSocket, EachCauseHasItsWords)
{
    const auto text = [](int cause) {
        const Error error = socketFailure("can0", cause);
        EXPECT_EQ(error.fault, Fault::LinkLost);
        return std::pair(error.text(), error.ailment);
    };
    EXPECT_EQ(text(ENETDOWN), std::pair(std::string("can0 was switched off"), Ailment::Down));
    EXPECT_EQ(text(EPIPE), std::pair(std::string("the other end of can0 closed it"), Ailment::Gone));
    EXPECT_EQ(text(ECONNRESET), text(EPIPE));
    EXPECT_EQ(text(ENOTCONN), text(EPIPE));
    const std::pair forbidden(
        std::string("no permission to use can0; allow CAN sockets in the container or sandbox"), Ailment::NoPermission);
    EXPECT_EQ(text(EPERM), forbidden);
    EXPECT_EQ(text(EACCES), forbidden);
    EXPECT_EQ(text(EIO), std::pair(std::string("can0 failed: Input/output error"), Ailment::None));
    const std::pair gone(std::string("can0 is gone"), Ailment::Gone);
    EXPECT_EQ(text(ENODEV), gone);
    EXPECT_EQ(text(ENXIO), gone);
    kernel.networks.clear();
    EXPECT_EQ(text(ENETDOWN), gone) << "off, and no more there";
}

// Sending

TEST_F(CanSocket, FramesGoOutAsTheyAreAndUrgentOnesInTheFirstBand)
{
    open();
    kernel.settings.clear();
    CanFrame remote = standardFrame(0x7FF, {});
    remote.remote = true;
    ASSERT_TRUE(link->send(extendedFrame(0x02061405, {1, 2, 3, 4, 5, 6, 7, 8})));
    ASSERT_TRUE(link->send(remote));
    kernel.sendCauses = {EINTR, EINTR};
    ASSERT_TRUE(link->send(*canFrameFromText("7FF#09")));
    EXPECT_EQ(kernel.sends, 5);
    EXPECT_EQ(kernel.settings, std::vector<Three>{});
    ASSERT_TRUE(link->send(standardFrame(1, {}), Priority::Urgent));
    EXPECT_EQ(kernel.settings, (std::vector<Three>{{SOL_SOCKET, SO_PRIORITY, 6}, {SOL_SOCKET, SO_PRIORITY, 0}}));
    EXPECT_EQ(taken(), (std::vector<std::string>{"02061405#0102030405060708", "7FF#R", "7FF#09", "001#"}));
}

TEST_F(CanSocket, WhatAFullQueueRefusesIsOfferedAgainEveryHalfMillisecond)
{
    open();
    kernel.sendCauses = {ENOBUFS, ENOBUFS};
    const Instant begin = clock.now();
    ASSERT_TRUE(link->send(standardFrame(1, {})));
    ASSERT_TRUE(link->send(standardFrame(2, {})));
    EXPECT_EQ(link->backlog(), 2U);
    EXPECT_EQ(kernel.sends, 1) << "what comes later waits behind it";
    EXPECT_EQ(link->health().stuckSince, begin);
    clock.advance(500us - 1ns);
    EXPECT_EQ(kernel.sends, 1);
    clock.advance(1ns);
    EXPECT_EQ(kernel.sends, 2);
    EXPECT_EQ(link->health().stuckSince, begin);
    clock.advance(500us);
    EXPECT_EQ(taken(), (std::vector<std::string>{"001#", "002#"}));
    EXPECT_EQ(link->backlog(), 0U);
    EXPECT_EQ(link->health().stuckSince, std::nullopt);
    kernel.sends = 0;
    clock.advance(100ms);
    EXPECT_EQ(kernel.sends, 0) << "nothing waits any more";
}

TEST_F(CanSocket, AnInterfaceThatGoesWhileFramesWaitIsLostAfterWhatItHadReceived)
{
    open();
    std::size_t before = 99;
    subscriptions.push_back(link->stateChanged().add([&](LinkState) { before = frames.size(); }));
    kernel.sendCauses = {ENOBUFS, ENETDOWN};
    ASSERT_TRUE(link->send(standardFrame(1, {})));
    put(5);
    clock.advance(500us);
    EXPECT_EQ(link->state(), LinkState::Lost);
    EXPECT_EQ(link->loss().text(), "can0 was switched off");
    EXPECT_EQ(before, 1U);
    EXPECT_EQ(link->backlog(), 0U);
    EXPECT_EQ(clock.armed(), 0U);
}

TEST_F(CanSocket, AStopThatWaitsGetsItsLastChanceWhenTheLinkIsClosed)
{
    open();
    kernel.sendCauses = {ENOBUFS};
    ASSERT_TRUE(link->send(*canFrameFromText("001#07"), Priority::Urgent));
    link->close();
    EXPECT_EQ(taken(), std::vector<std::string>{"001#07"});
    EXPECT_TRUE(isSocketClosed());
    EXPECT_EQ(clock.armed(), 0U);
}

} // namespace
} // namespace mb
