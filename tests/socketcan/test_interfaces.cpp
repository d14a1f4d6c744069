// SPDX-License-Identifier: GPL-3.0-or-later
// What the kernel tells of its CAN interfaces. Runs where vcan0 and vcan1 are up (tests/socketcan/run).
#include "support/eventloop.h"
#include "support/heldbackground.h"
#include "transport/backends/caninterface.h"
#include "transport/backends/socketcan.h"
#include "transport/linkcatalog.h"
#include "transport/linkwatch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include <arpa/inet.h>
#include <linux/can.h>
#include <linux/if_ether.h>
#include <linux/if_packet.h>
#include <net/if.h>
#include <sys/socket.h>
#include <unistd.h>

using namespace mb;
using namespace std::chrono_literals;

namespace {

void shell(const std::string &command)
{
    ASSERT_EQ(std::system(command.c_str()), 0) << command;
}

std::optional<CanInterface> interfaceOf(const std::string &name)
{
    const auto all = canInterfaces();
    if (!all)
        return std::nullopt;
    const auto found
        = std::find_if(all->begin(), all->end(), [&name](const CanInterface &i) { return i.name == name; });
    return found == all->end() ? std::nullopt : std::optional(*found);
}

class Interfaces : public ::testing::Test {
protected:
    void SetUp() override
    {
        if (::if_nametoindex("vcan0") != 0 && ::if_nametoindex("vcan1") != 0)
            return;
        if (std::getenv("MOTORBENCH_REQUIRE_VCAN") != nullptr)
            FAIL() << "there are no interfaces vcan0 and vcan1 here";
        GTEST_SKIP() << "no vcan0 and vcan1 here; tests/socketcan/run BUILD_DIR runs this where they are";
    }

    test::EventLoop loop;
};

} // namespace

TEST_F(Interfaces, AreListedWithKindAndState)
{
    const auto virtualOne = interfaceOf("vcan0");
    ASSERT_TRUE(virtualOne);
    EXPECT_EQ(virtualOne->kind, CanInterface::Kind::Virtual);
    EXPECT_EQ(virtualOne->driver, "vcan");
    EXPECT_TRUE(virtualOne->up);
    EXPECT_EQ(virtualOne->state, BusState::Active);
    const auto alone = canInterface(virtualOne->index);
    ASSERT_TRUE(alone);
    EXPECT_EQ(alone->name, "vcan0");
    EXPECT_FALSE(canInterface(1'000'000));
    EXPECT_FALSE(interfaceOf("lo")) << "not for CAN";
}

TEST_F(Interfaces, ComingGoingAndSwitchingIsToldByTheKernel)
{
    LinkWatch watch(loop.clock());
    int told = 0;
    const Subscription subscription = watch.changed().add([&told] { ++told; });
    const auto tellsOf = [&](const char *command) {
        const int before = told;
        shell(command);
        const Instant at = loop.clock().now();
        EXPECT_TRUE(loop.runUntil([&] { return told > before; }, 5s)) << command;
        return loop.clock().now() - at;
    };
    EXPECT_LT(tellsOf("ip link add vcan9 type vcan"), 1s);
    tellsOf("ip link set vcan9 up");
    tellsOf("ip link set vcan9 down");
    tellsOf("ip link del vcan9");
    loop.runReady();
    told = 0;
    shell("ip link add mbdummy type dummy 2>/dev/null && ip link del mbdummy || ip link set lo up");
    Timer wait(loop.clock());
    bool over = false;
    wait.startIn(200ms, [&over] { over = true; });
    loop.runUntil([&over] { return over; });
    EXPECT_EQ(told, 0) << "what is not CAN is not told";
}

/// No frame: the driver takes it from the queue, and drops it.
void dropInDriver(int count, const char *interface = "vcan0")
{
    const int packets = ::socket(AF_PACKET, SOCK_RAW | SOCK_CLOEXEC, htons(0x000C));
    ASSERT_GE(packets, 0);
    sockaddr_ll where{};
    where.sll_family = AF_PACKET;
    where.sll_protocol = htons(0x000C); // ETH_P_CAN
    where.sll_ifindex = static_cast<int>(::if_nametoindex(interface));
    can_frame broken{};
    broken.can_dlc = 15;
    for (int i = 0; i < count; ++i)
        ASSERT_EQ(::sendto(packets, &broken, sizeof broken, 0, reinterpret_cast<sockaddr *>(&where), sizeof where),
            ssize_t(sizeof broken));
    ::close(packets);
}

TEST_F(Interfaces, WhatADriverDropsIsCountedAsLost)
{
    SocketCanLink link({"socketcan", "vcan0", {}}, loop.clock());
    ASSERT_TRUE(link.open());
    dropInDriver(3);
    link.recount();
    EXPECT_EQ(link.counters().lost, 3U);
    link.recount();
    EXPECT_EQ(link.counters().lost, 3U) << "counted once";
    EXPECT_EQ(link.counters().rx, 0U);
}

TEST_F(Interfaces, AreAskedForInTheBackgroundWhileALinkIsOpen)
{
    test::HeldBackground background;
    SocketCanLink link({"socketcan", "vcan0", {}}, loop.clock());
    link.settings().background = &background;
    ASSERT_TRUE(link.open());
    ASSERT_TRUE(loop.runUntil([&] { return background.waiting() == 1; }));
    Timer wait(loop.clock());
    bool over = false;
    wait.startIn(1200ms, [&over] { over = true; });
    loop.runUntil([&over] { return over; });
    EXPECT_EQ(background.waiting(), 1U) << "not asked again while the kernel hangs";
    background.release();
    EXPECT_TRUE(loop.runUntil([&] { return background.waiting() == 1; }));
    link.close();
    background.release();
}

/// A driver may hold the kernel up, and an experiment counts again and again while its motor turns.
TEST_F(Interfaces, AreAskedForInTheBackgroundAlsoWhereLossesAreCountedNow)
{
    test::HeldBackground background;
    SocketCanLink link({"socketcan", "vcan0", {}}, loop.clock());
    link.settings().background = &background;
    ASSERT_TRUE(link.open());
    dropInDriver(3);
    link.recount();
    EXPECT_EQ(link.counters().lost, 0U) << "nobody has asked yet";
    EXPECT_EQ(background.waiting(), 1U);
    link.recount();
    EXPECT_EQ(background.waiting(), 1U) << "not asked again while the kernel hangs";
    background.release();
    EXPECT_EQ(link.counters().lost, 3U);
    link.recount();
    link.close();
    background.release();
    EXPECT_EQ(link.counters().lost, 3U);
}

TEST_F(Interfaces, WhatWasDroppedBeforeALinkIsLostIsCountedWhenTheKernelHasAnswered)
{
    test::HeldBackground background;
    SocketCanLink link({"socketcan", "vcan1", {}}, loop.clock());
    link.settings().background = &background;
    ASSERT_TRUE(link.open());
    dropInDriver(2, "vcan1");
    shell("ip link set vcan1 down");
    ASSERT_TRUE(loop.runUntil([&] { return link.state() == LinkState::Lost; }));
    EXPECT_EQ(background.waiting(), 1U);
    background.release();
    EXPECT_EQ(link.counters().lost, 2U);
    shell("ip link set vcan1 up");
}

TEST_F(Interfaces, LossesSurviveTheReturnOfAnInterface)
{
    SocketCanLink link({"socketcan", "vcan1", {}}, loop.clock());
    ASSERT_TRUE(link.open());
    const int small = 4000;
    ASSERT_EQ(::setsockopt(link.descriptor(), SOL_SOCKET, SO_RCVBUFFORCE, &small, sizeof small), 0);
    shell("cangen vcan1 -g 0 -n 500");
    link.recount();
    const std::uint64_t seen = link.counters().lost;
    EXPECT_GT(seen, 0U);
    shell("ip link set vcan1 down");
    ASSERT_TRUE(loop.runUntil([&] { return link.state() == LinkState::Lost; }));
    EXPECT_EQ(link.counters().rx + link.counters().lost, 500U);
    shell("ip link set vcan1 up");
    ASSERT_TRUE(link.open());
    EXPECT_EQ(link.counters().rx + link.counters().lost, 500U);
}

TEST_F(Interfaces, TheDoctorKnowsALostLinkFromItsInterface)
{
    shell("ip link add vcan9 type vcan && ip link set vcan9 up");
    SocketCanLink link({"socketcan", "vcan9", {}}, loop.clock());
    ASSERT_TRUE(link.open());
    const auto finding = [&] {
        const Instant now = loop.clock().now();
        return diagnose(symptomsOf(link, now), now, listLinks());
    };
    EXPECT_TRUE(finding().isHealthy());
    shell("ip link set vcan9 down");
    ASSERT_TRUE(loop.runUntil([&] { return link.state() == LinkState::Lost; }));
    EXPECT_EQ(finding().ailment, Ailment::Down);
    EXPECT_EQ(finding().command, "sudo ip link set vcan9 up");
    shell("ip link del vcan9");
    EXPECT_EQ(finding().ailment, Ailment::Gone);
}

TEST_F(Interfaces, EveryPluginOfQtSerialBusHasARow)
{
    const auto rows = listPluginLinks();
    const auto has = [&rows](const std::string &text, bool openable) {
        return std::any_of(rows.begin(), rows.end(),
            [&](const LinkListing &row) { return row.link.text() == text && row.openable == openable; });
    };
    EXPECT_TRUE(has("qtcan:socketcan:vcan0", true));
    EXPECT_TRUE(has("qtcan:peakcan", false)) << "its vendor's library is not here";
    for (const LinkListing &row : rows)
        EXPECT_EQ(row.openable, row.diagnosis.isHealthy()) << row.link.text();
}
