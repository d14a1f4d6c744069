// SPDX-License-Identifier: GPL-3.0-or-later
// Runs as root where vcan0 and vcan1 are up (tests/socketcan/run). Elsewhere every test is skipped, or fails when
// MOTORBENCH_REQUIRE_VCAN is set.
#include "support/eventloop.h"
#include "transport/backends/socketcan.h"
#include "transport/linkcatalog.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <set>
#include <thread>
#include <vector>

#include <linux/can.h>
#include <linux/can/error.h>
#include <linux/can/raw.h>
#include <net/if.h>
#include <sched.h>
#include <sys/socket.h>
#include <unistd.h>

using namespace mb;
using namespace std::chrono_literals;

namespace {

LinkAddress can(const std::string &name)
{
    return {"socketcan", name, {}};
}

/// A plain socket beside the link under test: another program on the bus.
class Peer {
public:
    explicit Peer(const char *interface)
        : m_descriptor(::socket(PF_CAN, SOCK_RAW | SOCK_CLOEXEC, CAN_RAW))
    {
        sockaddr_can where{};
        where.can_family = AF_CAN;
        where.can_ifindex = static_cast<int>(::if_nametoindex(interface));
        EXPECT_EQ(::bind(m_descriptor, reinterpret_cast<const sockaddr *>(&where), sizeof where), 0);
    }
    Peer(const Peer &) = delete;
    Peer &operator=(const Peer &) = delete;
    ~Peer() { ::close(m_descriptor); }

    void send(std::uint32_t id, std::initializer_list<std::uint8_t> bytes = {}) const
    {
        can_frame raw{};
        raw.can_id = id;
        raw.can_dlc = static_cast<std::uint8_t>(bytes.size());
        std::copy(bytes.begin(), bytes.end(), raw.data);
        while (::send(m_descriptor, &raw, sizeof raw, 0) < 0) {
            ASSERT_EQ(errno, ENOBUFS);
            ::sched_yield();
        }
    }

private:
    int m_descriptor;
};

void shell(const std::string &command)
{
    ASSERT_EQ(std::system(command.c_str()), 0) << command;
}

class SocketCan : public ::testing::Test {
protected:
    void SetUp() override
    {
        if (::if_nametoindex("vcan0") != 0 && ::if_nametoindex("vcan1") != 0)
            return;
        if (std::getenv("MOTORBENCH_REQUIRE_VCAN") != nullptr)
            FAIL() << "there are no interfaces vcan0 and vcan1 here";
        GTEST_SKIP() << "no vcan0 and vcan1 here; tests/socketcan/run BUILD_DIR runs this where they are";
    }
    std::unique_ptr<SocketCanLink> opened(const std::string &name)
    {
        auto link = std::make_unique<SocketCanLink>(can(name), loop.clock());
        const auto result = link->open();
        EXPECT_TRUE(result) << result.error().text();
        subscriptions.push_back(link->received().add([this](const CanFrame &frame) { frames.push_back(frame); }));
        return link;
    }

    test::EventLoop loop;
    std::vector<CanFrame> frames;
    std::vector<Subscription> subscriptions;
};

} // namespace

TEST_F(SocketCan, TwoLinksHearEachOtherAndNotThemselves)
{
    const auto a = opened("vcan0");
    const auto b = opened("vcan0");
    ASSERT_TRUE(a->send(extendedFrame(0x02061405, {1, 2, 3, 4, 5, 6, 7, 8})));
    ASSERT_TRUE(b->send(standardFrame(0x123, {})));
    ASSERT_TRUE(loop.runUntil([&] { return a->counters().rx + b->counters().rx == 2; }));
    loop.runReady();
    ASSERT_EQ(frames.size(), 2U);
    std::set<std::string> texts{toText(frames[0]), toText(frames[1])};
    EXPECT_EQ(texts, (std::set<std::string>{"02061405#0102030405060708", "123#"}));
    EXPECT_EQ(a->counters().rx, 1U);
    EXPECT_EQ(a->counters().tx, 1U);
}

TEST_F(SocketCan, TheKernelStampsEachFrameOfABatchByItself)
{
    const auto link = opened("vcan0");
    const Peer peer("vcan0");
    const Instant before = loop.clock().now();
    for (std::uint32_t i = 0; i < 64; ++i)
        peer.send(i);
    ASSERT_TRUE(loop.runUntil([this] { return frames.size() == 64; }));
    std::set<Instant> stamps;
    Instant last = before - 1s;
    for (const CanFrame &frame : frames) {
        EXPECT_GE(frame.time, last);
        last = frame.time;
        stamps.insert(frame.time);
    }
    EXPECT_LE(last, loop.clock().now());
    EXPECT_GT(stamps.size(), 32U) << "one stamp for the batch is not the kernel's";
}

TEST_F(SocketCan, AStallLosesNothingWhileTheReceiveBufferLasts)
{
    const auto link = opened("vcan0");
    const Peer peer("vcan0");
    ASSERT_GE(link->receiveBufferFrames(), 3000) << "as root the kernel gives what is asked for";
    for (std::uint32_t i = 0; i < 3000; ++i)
        peer.send(i | CAN_EFF_FLAG, {1, 2, 3, 4, 5, 6, 7, 8});
    ASSERT_TRUE(loop.runUntil([this] { return frames.size() == 3000; }));
    for (std::uint32_t i = 0; i < 3000; ++i)
        ASSERT_EQ(frames[i].id, i);
    EXPECT_EQ(link->counters().lost, 0U);
}

TEST_F(SocketCan, AFloodArrivesCompleteAndInOrder)
{
    constexpr std::uint32_t count = 30'000;
    const auto link = opened("vcan0");
    frames.reserve(count);
    std::thread sender([] {
        const Peer peer("vcan0");
        for (std::uint32_t i = 0; i < count; ++i)
            peer.send(i | CAN_EFF_FLAG, {1, 2, 3, 4, 5, 6, 7, 8});
    });
    const bool complete = loop.runUntil([this] { return frames.size() == count; }, 60s);
    sender.join();
    EXPECT_TRUE(complete) << frames.size();
    EXPECT_EQ(link->counters().lost, 0U);
    for (std::uint32_t i = 0; i < frames.size(); ++i)
        ASSERT_EQ(frames[i].id, i);
}

TEST_F(SocketCan, WhatWaitsUnreadIsDeliveredBeforeALogEnds)
{
    const auto link = opened("vcan0");
    const Peer peer("vcan0");
    for (std::uint32_t i = 0; i < 3000; ++i)
        peer.send(i | CAN_EFF_FLAG);
    ASSERT_EQ(frames.size(), 0U) << "no event loop ran";
    link->catchUp();
    EXPECT_EQ(frames.size(), 3000U);
    link->close();
    link->catchUp();
    EXPECT_EQ(frames.size(), 3000U);
}

TEST_F(SocketCan, CatchingUpEndsOnABusThatNeverRests)
{
    const auto link = opened("vcan0");
    std::atomic<bool> isEnding = false;
    std::thread sender([&isEnding] {
        const Peer peer("vcan0");
        while (!isEnding)
            peer.send(1);
    });
    EXPECT_TRUE(loop.runUntil([this] { return frames.size() > 1000; }));
    link->catchUp();
    isEnding = true;
    sender.join();
}

TEST_F(SocketCan, WhatTheKernelDropsIsCounted)
{
    constexpr std::uint64_t count = 2000;
    const auto link = opened("vcan0");
    const int small = 60'000;
    ASSERT_EQ(::setsockopt(link->descriptor(), SOL_SOCKET, SO_RCVBUFFORCE, &small, sizeof small), 0);
    const Peer peer("vcan0");
    for (std::uint32_t i = 0; i < count; ++i)
        peer.send(i & CAN_SFF_MASK);
    loop.runReady();
    EXPECT_GT(link->counters().lost, 0U);
    EXPECT_EQ(link->counters().rx + link->counters().lost, count) << "drops after the last frame count at once";
    peer.send(1);
    ASSERT_TRUE(loop.runUntil([&] { return link->counters().rx + link->counters().lost == count + 1; }));
}

TEST_F(SocketCan, AFullTransmitQueueDelaysAndNeitherLosesNorReorders)
{
    constexpr std::uint32_t count = 400;
    shell("tc qdisc add dev vcan1 root tbf rate 100kbit burst 200 limit 1000");
    const auto receiver = opened("vcan1");
    SocketCanLink sender(can("vcan1"), loop.clock());
    ASSERT_TRUE(sender.open());
    for (std::uint32_t i = 0; i < count; ++i)
        ASSERT_TRUE(sender.send(extendedFrame(i, {1, 2, 3, 4, 5, 6, 7, 8})));
    EXPECT_GT(sender.backlog(), 0U) << "this queue was to be full";
    ASSERT_TRUE(sender.send(extendedFrame(0x1000001, {}), Priority::Urgent));
    EXPECT_TRUE(loop.runUntil([this] { return frames.size() == count + 1; }));
    shell("tc qdisc del dev vcan1 root");
    EXPECT_EQ(sender.backlog(), 0U);
    const auto urgent = std::find_if(frames.begin(), frames.end(), [](const CanFrame &f) { return f.id == 0x1000001; });
    ASSERT_NE(urgent, frames.end());
    EXPECT_LT(urgent - frames.begin(), 300);
    frames.erase(urgent);
    for (std::uint32_t i = 0; i < count; ++i)
        ASSERT_EQ(frames[i].id, i);
}

TEST_F(SocketCan, AnInterfaceThatIsSwitchedOffIsLostAndComesBack)
{
    const auto link = opened("vcan1");
    shell("ip link set vcan1 down");
    EXPECT_TRUE(loop.runUntil([&] { return link->state() == LinkState::Lost; }));
    EXPECT_EQ(link->loss().message(), "vcan1 was switched off");
    const auto sent = link->send(standardFrame(1, {}));
    ASSERT_FALSE(sent);
    EXPECT_EQ(sent.error().fault, Fault::LinkLost);
    EXPECT_EQ(sent.error().detail, "vcan1 was switched off");
    const auto refused = link->open();
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().text(), "vcan1 is switched off; bring it up: sudo ip link set vcan1 up");
    shell("ip link set vcan1 up");
    const auto again = link->open();
    ASSERT_TRUE(again) << again.error().text();
    Peer("vcan1").send(7);
    EXPECT_TRUE(loop.runUntil([this] { return frames.size() == 1; }));
}

TEST_F(SocketCan, SendingOnAnInterfaceThatWasJustSwitchedOffFails)
{
    const auto link = opened("vcan1");
    shell("ip link set vcan1 down");
    const auto sent = link->send(standardFrame(1, {}));
    shell("ip link set vcan1 up");
    ASSERT_FALSE(sent);
    EXPECT_EQ(sent.error().fault, Fault::LinkLost);
    EXPECT_TRUE(loop.runUntil([&] { return link->state() == LinkState::Lost; }));
}

TEST_F(SocketCan, AnInterfaceThatIsUnpluggedIsGone)
{
    shell("ip link add vcan9 type vcan && ip link set vcan9 up");
    const auto link = opened("vcan9");
    shell("ip link del vcan9");
    EXPECT_TRUE(loop.runUntil([&] { return link->state() == LinkState::Lost; }));
    EXPECT_EQ(link->loss().message(), "vcan9 is gone");
    const auto again = link->open();
    ASSERT_FALSE(again);
    EXPECT_EQ(again.error().text(), "there is no CAN interface vcan9");
}

TEST_F(SocketCan, ErrorFramesArriveAndBusOffLosesTheLink)
{
    const auto link = opened("vcan0");
    std::vector<CanFrame> errors;
    subscriptions.push_back(link->errorFrames().add([&errors](const CanFrame &frame) { errors.push_back(frame); }));
    const Peer peer("vcan0");
    peer.send(CAN_ERR_FLAG | CAN_ERR_CRTL, {0, CAN_ERR_CRTL_TX_PASSIVE, 0, 0, 0, 0, 0, 0});
    ASSERT_TRUE(loop.runUntil([&errors] { return errors.size() == 1; }));
    EXPECT_EQ(errors[0].id, CAN_ERR_CRTL);
    EXPECT_EQ(link->state(), LinkState::Open);
    link->recount();
    EXPECT_EQ(link->health().state, BusState::Passive) << "a virtual interface knows of none";
    peer.send(CAN_ERR_FLAG | CAN_ERR_BUSOFF, {0, 0, 0, 0, 0, 0, 0, 0});
    ASSERT_TRUE(loop.runUntil([&] { return link->state() == LinkState::Lost; }));
    EXPECT_EQ(link->loss().message().english().substr(0, 15), "bus-off: vcan0 ");
    EXPECT_EQ(link->counters().errors, 2U);
    EXPECT_TRUE(link->open());
}

TEST_F(SocketCan, TheCatalogTellsWhatCanBeOpenedAndWhyNot)
{
    shell("ip link set vcan1 down");
    const auto rows = listLinks();
    shell("ip link set vcan1 up");
    const auto row = [&rows](const char *text) {
        const auto found
            = std::find_if(rows.begin(), rows.end(), [text](const LinkListing &r) { return r.link.text() == text; });
        return found == rows.end() ? LinkListing{} : *found;
    };
    EXPECT_EQ(row("socketcan:vcan0").state, ListingState::Up);
    EXPECT_TRUE(row("socketcan:vcan0").openable);
    EXPECT_EQ(row("socketcan:vcan1").state, ListingState::Down);
    EXPECT_FALSE(row("socketcan:vcan1").openable);
    EXPECT_EQ(row("socketcan:vcan1").detail, "vcan1 is switched off; bring it up: sudo ip link set vcan1 up");
}

TEST_F(SocketCan, OpeningNamesTheCause)
{
    for (const auto &[name, cause] : std::initializer_list<std::pair<const char *, const char *>>{
             {"can7", "there is no CAN interface can7"},
             {"averyveryverylongname", "there is no CAN interface averyveryverylongname"},
             {"lo", "lo is a network interface, but not one for CAN"},
         }) {
        SocketCanLink link(can(name), loop.clock());
        const auto result = link.open();
        ASSERT_FALSE(result) << name;
        EXPECT_EQ(result.error().fault, Fault::LinkLost) << name;
        EXPECT_EQ(result.error().text(), cause);
    }
}

TEST_F(SocketCan, QtPluginsCarryFramesBothWays)
{
    auto made = createLink(LinkAddress::parse("qtcan:socketcan:vcan0").value(), loop.clock());
    ASSERT_TRUE(made);
    auto &link = static_cast<CanLink &>(**made);
    const auto result = link.open();
    ASSERT_TRUE(result) << result.error().text();
    const auto native = opened("vcan0");
    std::vector<CanFrame> heard;
    subscriptions.push_back(link.received().add([&heard](const CanFrame &frame) { heard.push_back(frame); }));
    ASSERT_TRUE(native->send(extendedFrame(0x02061405, {1, 2, 3})));
    ASSERT_TRUE(native->send(standardFrame(0x77, {})));
    ASSERT_TRUE(link.send(extendedFrame(0x00000240, {})));
    ASSERT_TRUE(loop.runUntil([&] { return heard.size() == 2 && frames.size() == 1; }));
    EXPECT_EQ(toText(heard[0]), "02061405#010203");
    EXPECT_EQ(toText(heard[1]), "077#");
    EXPECT_LE(heard[0].time, loop.clock().now());
    EXPECT_EQ(toText(frames[0]), "00000240#");
    EXPECT_EQ(link.state(), LinkState::Open);
    link.close();
    EXPECT_EQ(link.state(), LinkState::Closed);
}

TEST_F(SocketCan, QtPluginsThatAreNotThereAreNamed)
{
    auto made = createLink(LinkAddress::parse("qtcan:nosuch:can0").value(), loop.clock());
    ASSERT_TRUE(made);
    const auto result = (*made)->open();
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().fault, Fault::LinkLost);
    EXPECT_EQ(result.error().text().substr(0, 51), "there is no CAN plugin nosuch; installed are: passt");
}
