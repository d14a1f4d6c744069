// SPDX-License-Identifier: GPL-3.0-or-later
// The descriptor half of SocketCanLink over a SOCK_SEQPACKET pair, where sanitizers run and no CAN is needed.
#include "support/eventloop.h"
#include "transport/backends/cansocket.h"
#include "transport/backends/socketcan.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <cstring>
#include <new>
#include <thread>
#include <vector>

#include <linux/can.h>
#include <linux/can/error.h>
#include <linux/capability.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <unistd.h>

using namespace mb;
using namespace std::chrono_literals;

namespace {

std::size_t allocations = 0;

} // namespace

void *operator new(std::size_t size)
{
    ++allocations;
    if (void *memory = std::malloc(size > 0 ? size : 1))
        return memory;
    std::abort();
}
void operator delete(void *memory) noexcept
{
    std::free(memory);
}
void operator delete(void *memory, std::size_t) noexcept
{
    std::free(memory);
}

namespace {

class SocketCanPair : public ::testing::Test {
protected:
    SocketCanPair()
    {
        int ends[2] = {-1, -1};
        if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends) != 0)
            std::abort();
        other = ends[1];
        link = std::make_unique<SocketCanLink>(LinkAddress{"socketcan", "pair0", {}}, loop.clock(), ends[0]);
        subscriptions.push_back(link->received().add([this](const CanFrame &frame) { frames.push_back(frame); }));
        subscriptions.push_back(link->errorFrames().add([this](const CanFrame &frame) { errors.push_back(frame); }));
        subscriptions.push_back(link->batchEnded().add([this] { ++batches; }));
        subscriptions.push_back(link->stateChanged().add([this](LinkState state) { states.push_back(state); }));
        frames.reserve(4096);
        if (!link->open())
            std::abort();
    }
    ~SocketCanPair() override { closeOther(); }

    void closeOther()
    {
        if (other >= 0)
            ::close(std::exchange(other, -1));
    }
    void put(const void *data, std::size_t size) const
    {
        ASSERT_EQ(::send(other, data, size, MSG_DONTWAIT), ssize_t(size));
    }
    void put(std::uint32_t id, std::initializer_list<std::uint8_t> bytes = {}) const
    {
        can_frame raw{};
        raw.can_id = id;
        raw.can_dlc = static_cast<std::uint8_t>(bytes.size());
        std::copy(bytes.begin(), bytes.end(), raw.data);
        put(&raw, sizeof raw);
    }
    /// What the link handed to the kernel; nothing left at the end.
    [[nodiscard]] std::vector<can_frame> taken() const
    {
        std::vector<can_frame> all;
        can_frame raw{};
        while (::recv(other, &raw, sizeof raw, MSG_DONTWAIT) == ssize_t(sizeof raw))
            all.push_back(raw);
        return all;
    }

    test::EventLoop loop;
    int other = -1;
    std::unique_ptr<SocketCanLink> link;
    std::vector<CanFrame> frames;
    std::vector<CanFrame> errors;
    std::vector<LinkState> states;
    int batches = 0;
    std::vector<Subscription> subscriptions;
};

} // namespace

TEST_F(SocketCanPair, ReceivesEveryKindOfFrame)
{
    put(0x123, {1, 2, 3});
    put(0x02061405U | CAN_EFF_FLAG, {8, 7, 6, 5, 4, 3, 2, 1});
    put(0x7FFU | CAN_RTR_FLAG);
    ASSERT_TRUE(loop.runUntil([this] { return frames.size() == 3; }));
    EXPECT_EQ(toText(frames[0]), "123#010203");
    EXPECT_EQ(toText(frames[1]), "02061405#0807060504030201");
    EXPECT_EQ(toText(frames[2]), "7FF#R");
    EXPECT_EQ(link->counters().rx, 3U);
    EXPECT_EQ(link->counters().errors, 0U);
}

TEST_F(SocketCanPair, SendsEveryKindOfFrame)
{
    CanFrame remote = standardFrame(0x7FF, {});
    remote.remote = true;
    ASSERT_TRUE(link->send(extendedFrame(0x1FFFFFFF, {1, 2})));
    ASSERT_TRUE(link->send(remote));
    const auto sent = taken();
    ASSERT_EQ(sent.size(), 2U);
    EXPECT_EQ(sent[0].can_id, 0x1FFFFFFFU | CAN_EFF_FLAG);
    EXPECT_EQ(sent[0].can_dlc, 2);
    EXPECT_EQ(sent[0].data[1], 2);
    EXPECT_EQ(sent[1].can_id, 0x7FFU | CAN_RTR_FLAG);
    EXPECT_EQ(link->counters().tx, 2U);
    EXPECT_EQ(link->backlog(), 0U);
}

TEST_F(SocketCanPair, RefusesWhatIsNoFrame)
{
    CanFrame wide = extendedFrame(0x20000000, {});
    CanFrame tall = standardFrame(0x800, {});
    CanFrame longer;
    longer.size = 9;
    for (const CanFrame &frame : {wide, tall, longer}) {
        const auto sent = link->send(frame);
        ASSERT_FALSE(sent);
        EXPECT_EQ(sent.error().fault, Fault::OutOfRange);
    }
    EXPECT_TRUE(taken().empty());
    EXPECT_EQ(link->counters().tx, 0U);
}

TEST_F(SocketCanPair, ReadsInBatchesOf64InOrder)
{
    for (std::uint32_t i = 0; i < 200; ++i)
        put(i);
    ASSERT_TRUE(loop.runUntil([this] { return frames.size() == 200; }));
    for (std::uint32_t i = 0; i < 200; ++i)
        ASSERT_EQ(frames[i].id, i);
    EXPECT_EQ(batches, 4);
}

TEST_F(SocketCanPair, ReceivingDoesNotAllocate)
{
    std::size_t before = 0;
    std::size_t during = ~std::size_t(0);
    subscriptions.push_back(link->received().add([&](const CanFrame &frame) {
        if (frame.id == 0)
            before = allocations;
    }));
    subscriptions.push_back(link->batchEnded().add([&] { during = allocations - before; }));
    for (std::uint32_t i = 0; i < 64; ++i)
        put(i);
    ASSERT_TRUE(loop.runUntil([this] { return frames.size() == 64; }));
    EXPECT_EQ(batches, 1);
    EXPECT_EQ(during, 0U);
}

TEST_F(SocketCanPair, ErrorFramesDoNotAllocateEither)
{
    std::size_t before = 0;
    std::size_t during = ~std::size_t(0);
    subscriptions.clear(); // the fixture keeps the frames
    subscriptions.push_back(link->received().add([&](const CanFrame &) { before = allocations; }));
    subscriptions.push_back(link->batchEnded().add([&] { during = allocations - before; }));
    put(1);
    for (int i = 0; i < 63; ++i)
        put(CAN_ERR_FLAG | CAN_ERR_PROT | CAN_ERR_CRTL,
            {0, CAN_ERR_CRTL_RX_PASSIVE, CAN_ERR_PROT_STUFF, 0, 0, 0, 0, 200});
    ASSERT_TRUE(loop.runUntil([this] { return link->counters().errors == 63; }));
    EXPECT_EQ(during, 0U);
    EXPECT_EQ(link->health().protocolErrors, 63U);
}

TEST_F(SocketCanPair, ErrorFramesBecomeTheHealthOfTheBus)
{
    put(CAN_ERR_FLAG | CAN_ERR_CRTL, {0, CAN_ERR_CRTL_TX_WARNING, 0, 0, 0, 0, 100, 3});
    put(CAN_ERR_FLAG | CAN_ERR_ACK, {0, 0, 0, 0, 0, 0, 0, 0});
    put(CAN_ERR_FLAG | CAN_ERR_LOSTARB, {7, 0, 0, 0, 0, 0, 0, 0});
    ASSERT_TRUE(loop.runUntil([this] { return errors.size() == 3; }));
    const BusHealth &health = link->health();
    EXPECT_EQ(health.state, BusState::Warning);
    EXPECT_EQ(health.transmitErrors, 100);
    EXPECT_EQ(health.receiveErrors, 3);
    EXPECT_EQ(health.acknowledgeErrors, 1U);
    EXPECT_EQ(health.arbitrationLosses, 1U);
    EXPECT_EQ(health.last.arbitrationBit, 7);
    EXPECT_TRUE(health.lastAcknowledgeError);
    EXPECT_FALSE(health.lastReceived);
    put(CAN_ERR_FLAG | CAN_ERR_CRTL, {0, CAN_ERR_CRTL_ACTIVE, 0, 0, 0, 0, 0, 0});
    put(0x123);
    ASSERT_TRUE(loop.runUntil([this] { return frames.size() == 1; }));
    EXPECT_EQ(health.state, BusState::Active);
    EXPECT_TRUE(health.lastReceived);
}

TEST_F(SocketCanPair, AQueueThatNobodyEmptiesIsTold)
{
    EXPECT_FALSE(link->health().stuckSince);
    while (link->backlog() == 0)
        ASSERT_TRUE(link->send(extendedFrame(1, {})));
    EXPECT_TRUE(link->health().stuckSince);
    Result<void> sent;
    for (int i = 0; sent && i < 20'000; ++i)
        sent = link->send(extendedFrame(2, {}));
    ASSERT_FALSE(sent) << "what waits has an end";
    EXPECT_EQ(sent.error().fault, Fault::LinkLost);
    EXPECT_EQ(link->backlog(), 8192U);
    EXPECT_EQ(link->state(), LinkState::Open);
    EXPECT_TRUE(link->send(extendedFrame(3, {}), Priority::Urgent)) << "a stop always has room";
    ASSERT_TRUE(loop.runUntil([this] {
        (void)taken();
        return link->backlog() == 0;
    }));
    EXPECT_FALSE(link->health().stuckSince);
}

TEST_F(SocketCanPair, CountsMalformedMessagesAndCarriesOn)
{
    const std::vector<std::uint8_t> bytes(72, 0);
    put(bytes.data(), 1);
    put(bytes.data(), 15);
    put(bytes.data(), 17);
    put(bytes.data(), 72);
    can_frame raw{};
    raw.can_dlc = 9;
    put(&raw, sizeof raw);
    put(0x42);
    ASSERT_TRUE(loop.runUntil([this] { return !frames.empty(); }));
    EXPECT_EQ(frames.size(), 1U);
    EXPECT_EQ(frames[0].id, 0x42U);
    EXPECT_EQ(link->counters().errors, 5U);
    EXPECT_EQ(link->state(), LinkState::Open);
}

TEST_F(SocketCanPair, StampsNeverRunBackwardsOrAhead)
{
    const Instant before = loop.clock().now();
    std::vector<Instant> seen;
    subscriptions.push_back(link->received().add([&](const CanFrame &) { seen.push_back(loop.clock().now()); }));
    for (std::uint32_t i = 0; i < 100; ++i)
        put(i);
    ASSERT_TRUE(loop.runUntil([this] { return frames.size() == 100; }));
    for (std::size_t i = 0; i < 100; ++i) {
        EXPECT_LE(frames[i].time, seen[i]);
        EXPECT_GE(frames[i].time, i == 0 ? before - 1s : frames[i - 1].time);
    }
}

TEST_F(SocketCanPair, SentFramesCarryTheTimeTheyWereAccepted)
{
    std::vector<Instant> sent;
    subscriptions.push_back(link->traffic().add([&sent](const Traffic &traffic) {
        EXPECT_EQ(traffic.direction, Direction::Sent);
        EXPECT_EQ(traffic.time, traffic.can->time);
        sent.push_back(traffic.time);
    }));
    const Instant before = loop.clock().now();
    ASSERT_TRUE(link->send(standardFrame(1, {})));
    ASSERT_EQ(sent.size(), 1U);
    EXPECT_GE(sent[0], before);
    EXPECT_LE(sent[0], loop.clock().now());
}

TEST_F(SocketCanPair, ErrorFramesAreTheirOwnKindAndOverrunsCountAsLost)
{
    put(CAN_ERR_FLAG | CAN_ERR_CRTL, {0, CAN_ERR_CRTL_RX_OVERFLOW, 0, 0, 0, 0, 0, 0});
    put(CAN_ERR_FLAG | CAN_ERR_ACK, {0, 0, 0, 0, 0, 0, 0, 0});
    put(CAN_ERR_FLAG | CAN_ERR_PROT, {0, CAN_ERR_CRTL_RX_OVERFLOW, 0, 0, 0, 0, 0, 0}); // says nothing in this class
    ASSERT_TRUE(loop.runUntil([this] { return errors.size() == 3; }));
    EXPECT_TRUE(frames.empty());
    EXPECT_TRUE(errors[0].error);
    EXPECT_EQ(errors[0].id, CAN_ERR_CRTL);
    EXPECT_EQ(errors[0].data[1], CAN_ERR_CRTL_RX_OVERFLOW);
    EXPECT_EQ(errors[1].id, CAN_ERR_ACK);
    EXPECT_EQ(link->counters().errors, 3U);
    EXPECT_EQ(link->counters().lost, 1U);
    EXPECT_EQ(link->state(), LinkState::Open);
}

TEST_F(SocketCanPair, BusOffLosesTheLinkAfterItsErrorFrame)
{
    put(1);
    put(CAN_ERR_FLAG | CAN_ERR_BUSOFF, {0, 0, 0, 0, 0, 0, 0, 0});
    put(2);
    ASSERT_TRUE(loop.runUntil([this] { return link->state() == LinkState::Lost; }));
    EXPECT_EQ(frames.size(), 1U);
    EXPECT_EQ(errors.size(), 1U);
    EXPECT_EQ(link->loss().message().english().substr(0, 7), "bus-off");
    const auto sent = link->send(standardFrame(1, {}));
    ASSERT_FALSE(sent);
    EXPECT_EQ(sent.error(), link->loss());
    loop.runReady();
    EXPECT_EQ(frames.size(), 1U);
}

TEST_F(SocketCanPair, FramesThatDoNotFitTheKernelWaitInOrderAndUrgentOnesGoFirst)
{
    constexpr std::uint32_t count = 2000;
    for (std::uint32_t i = 0; i < count; ++i)
        ASSERT_TRUE(link->send(extendedFrame(i, {})));
    const std::size_t waiting = link->backlog();
    ASSERT_GT(waiting, 2U);
    ASSERT_TRUE(link->send(extendedFrame(0x1000001, {}), Priority::Urgent));
    ASSERT_TRUE(link->send(extendedFrame(0x1000002, {}), Priority::Urgent));
    EXPECT_EQ(link->backlog(), waiting + 2);
    std::vector<std::uint32_t> ids;
    ASSERT_TRUE(loop.runUntil([&] {
        for (const can_frame &raw : taken())
            ids.push_back(raw.can_id & CAN_EFF_MASK);
        return ids.size() == count + 2;
    }));
    EXPECT_EQ(link->backlog(), 0U);
    EXPECT_EQ(link->counters().tx, count + 2U);
    std::vector<std::uint32_t> expected;
    for (std::uint32_t i = 0; i < count; ++i) {
        if (i == count - waiting)
            expected.insert(expected.end(), {0x1000001U, 0x1000002U});
        expected.push_back(i);
    }
    EXPECT_EQ(ids, expected);
}

TEST_F(SocketCanPair, WhatNobodyTookForHalfASecondIsNotCarriedOutLaterAndAStopIs)
{
    while (link->backlog() == 0)
        ASSERT_TRUE(link->send(extendedFrame(1, {})));
    ASSERT_TRUE(link->send(extendedFrame(2, {7}))); // an order that its task gives up meanwhile
    ASSERT_TRUE(link->send(extendedFrame(3, {}), Priority::Urgent));
    ASSERT_TRUE(link->send(extendedFrame(3, {}), Priority::Urgent));
    ASSERT_TRUE(link->send(extendedFrame(3, {}))); // behind a set-point that the kernel may hold
    ASSERT_TRUE(loop.runUntil([this] { return link->backlog() == 2; })) << "the stop, once of each";
    const Instant later = loop.clock().now() + std::chrono::milliseconds(600);
    ASSERT_TRUE(loop.runUntil([&] { return loop.clock().now() >= later; }));
    EXPECT_EQ(link->backlog(), 2U);
    EXPECT_GE(link->counters().lost, 2U);
    EXPECT_TRUE(link->health().stuckSince);
    std::vector<std::uint32_t> ids;
    ASSERT_TRUE(loop.runUntil([&] {
        for (const can_frame &raw : taken())
            ids.push_back(raw.can_id & CAN_EFF_MASK);
        return link->backlog() == 0;
    }));
    for (const can_frame &raw : taken())
        ids.push_back(raw.can_id & CAN_EFF_MASK);
    EXPECT_EQ(std::count(ids.begin(), ids.end(), 2U), 0);
    EXPECT_EQ(std::count(ids.begin(), ids.end(), 3U), 2);
    EXPECT_EQ(ids.back(), 3U);
    EXPECT_FALSE(link->health().stuckSince);
}

TEST_F(SocketCanPair, WhatWaitedThroughAStallOfItsThreadIsNotCarriedOutAfterItAndAStopIs)
{
    while (link->backlog() == 0)
        ASSERT_TRUE(link->send(extendedFrame(1, {})));
    ASSERT_TRUE(link->send(extendedFrame(2, {7})));
    ASSERT_TRUE(link->send(extendedFrame(3, {}), Priority::Urgent));
    for (const Instant free = loop.clock().now() + CanQueue::mostPatience + 50ms; loop.clock().now() < free;) { }
    (void)taken(); // the cable is back
    ASSERT_TRUE(loop.runUntil([this] { return link->backlog() == 0; }));
    const std::vector<can_frame> after = taken();
    ASSERT_EQ(after.size(), 1U);
    EXPECT_EQ(after[0].can_id & CAN_EFF_MASK, 3U);
    EXPECT_GE(link->counters().lost, 2U);
}

TEST_F(SocketCanPair, APeerThatClosesLosesTheLink)
{
    put(1);
    closeOther();
    ASSERT_TRUE(loop.runUntil([this] { return link->state() == LinkState::Lost; }));
    EXPECT_EQ(frames.size(), 1U);
    EXPECT_EQ(link->loss().message(), "the other end of pair0 closed it");
    EXPECT_EQ(states, (std::vector{LinkState::Open, LinkState::Lost}));
}

TEST_F(SocketCanPair, SendingToAClosedPeerFailsAndTellsOfTheLossFromTheClock)
{
    closeOther();
    const auto sent = link->send(standardFrame(1, {}));
    ASSERT_FALSE(sent);
    EXPECT_EQ(sent.error().fault, Fault::LinkLost);
    EXPECT_EQ(link->state(), LinkState::Open);
    ASSERT_TRUE(loop.runUntil([this] { return link->state() == LinkState::Lost; }));
    EXPECT_EQ(states, (std::vector{LinkState::Open, LinkState::Lost}));
}

TEST_F(SocketCanPair, MayBeClosedWhileItDelivers)
{
    subscriptions.push_back(link->received().add([this](const CanFrame &frame) {
        if (frame.id == 2)
            link->close();
    }));
    for (std::uint32_t i = 0; i < 100; ++i)
        put(i);
    ASSERT_TRUE(loop.runUntil([this] { return link->state() == LinkState::Closed; }));
    EXPECT_EQ(frames.size(), 3U);
    EXPECT_EQ(link->descriptor(), -1);
    const auto sent = link->send(standardFrame(1, {}));
    ASSERT_FALSE(sent);
    EXPECT_EQ(sent.error().text(), "pair0 is not open");
}

TEST_F(SocketCanPair, ClosingLeavesNoTimerAndNoFrameThatTheNextOpeningWouldSend)
{
    for (std::uint32_t i = 0; i < 2000; ++i)
        ASSERT_TRUE(link->send(extendedFrame(i, {})));
    ASSERT_TRUE(link->send(extendedFrame(0x1000001, {}), Priority::Urgent));
    link->close();
    EXPECT_EQ(link->backlog(), 0U);
    EXPECT_EQ(loop.clock().armed(), 0U);
}

TEST_F(SocketCanPair, CatchingUpDeliversWhatWaitsUnread)
{
    for (std::uint32_t i = 0; i < 200; ++i)
        put(i);
    EXPECT_TRUE(frames.empty()) << "no event loop ran";
    link->catchUp();
    EXPECT_EQ(frames.size(), 200U);
    link->close();
    link->catchUp();
    EXPECT_EQ(frames.size(), 200U);
}

TEST_F(SocketCanPair, TellsHowManyFramesTheKernelKeeps)
{
    EXPECT_GE(link->receiveBufferFrames(), 64);
}

TEST_F(SocketCanPair, WhoMayNotForceTheReceiveBufferGetsTheLargestThatEveryUserMayHave)
{
    int usual = 0;
    socklen_t size = sizeof usual;
    ASSERT_EQ(::getsockopt(other, SOL_SOCKET, SO_RCVBUF, &usual, &size), 0);
    int given = 0;
    std::thread([&given, this] { // without rights, which each thread has for itself
        __user_cap_header_struct head{_LINUX_CAPABILITY_VERSION_3, 0};
        const std::array<__user_cap_data_struct, _LINUX_CAPABILITY_U32S_3> none{};
        EXPECT_EQ(::syscall(SYS_capset, &head, none.data()), 0);
        given = prepareCanSocket(other);
    })
        .join();
    EXPECT_GT(given, usual);
}
