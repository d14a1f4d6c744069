// SPDX-License-Identifier: GPL-3.0-or-later
// SocketCanLink on the CAN socket of a played kernel: how it is opened, and what the kernel says of its interface meanwhile.
#include "cansocketbench.h"
#include "support/heldbackground.h"
#include "transport/linkdoctor.h"

#include <gtest/gtest.h>

#include <array>
#include <cerrno>
#include <string>
#include <utility>
#include <vector>

#include <linux/can.h>
#include <linux/can/error.h>
#include <linux/can/netlink.h>
#include <linux/can/raw.h>
#include <linux/if_link.h>
#include <linux/net_tstamp.h>
#include <net/if.h>
#include <sys/socket.h>

namespace mb {
namespace {

using namespace std::chrono_literals;
using test::attribute;
using test::CanSocket;
using test::rawBytes;
using Three = test::PlayedKernel::Three;

test::NetlinkBytes losses(std::uint64_t overruns, std::uint64_t dropped)
{
    rtnl_link_stats64 counted{};
    counted.rx_over_errors = overruns;
    counted.rx_dropped = dropped;
    return attribute(IFLA_STATS64, rawBytes(counted));
}

std::vector<test::NetlinkBytes> stateOf(std::uint32_t state, std::uint16_t transmitErrors, std::uint16_t receiveErrors)
{
    can_berr_counter errors{};
    errors.txerr = transmitErrors;
    errors.rxerr = receiveErrors;
    return {attribute(IFLA_CAN_STATE, rawBytes(state)), attribute(IFLA_CAN_BERR_COUNTER, rawBytes(errors))};
}

// Opening

TEST_F(CanSocket, IsMadeReadyBeforeItIsBoundToItsInterface)
{
    open();
    EXPECT_EQ(kernel.opened.back(), Three(PF_CAN, SOCK_RAW | SOCK_CLOEXEC | SOCK_NONBLOCK, CAN_RAW));
    EXPECT_EQ(kernel.settings,
        (std::vector<Three>{{SOL_SOCKET, SO_TIMESTAMPING,
                                SOF_TIMESTAMPING_RX_SOFTWARE | SOF_TIMESTAMPING_SOFTWARE | SOF_TIMESTAMPING_RX_HARDWARE
                                    | SOF_TIMESTAMPING_RAW_HARDWARE},
            {SOL_SOCKET, SO_RXQ_OVFL, 1}, {SOL_SOCKET, SO_RCVBUFFORCE, 16 * 1024 * 1024},
            {SOL_CAN_RAW, CAN_RAW_ERR_FILTER, static_cast<int>(CAN_ERR_MASK)}}));
    EXPECT_EQ(kernel.bound, std::vector<Three>({{AF_CAN, 7, 4}}));
    EXPECT_EQ(link->receiveCapacity(), 100);
    EXPECT_EQ(link->bitrate(), 500'000);
    EXPECT_FALSE(link->isListenOnly());
    EXPECT_EQ(link->outlet().form, Outlet::Form::CanSocket);
    EXPECT_EQ(link->outlet().descriptor, link->descriptor());
    link->close();
    EXPECT_TRUE(isSocketClosed());
    EXPECT_EQ(link->bitrate(), 0) << "nothing is known of what is not open";
}

TEST_F(CanSocket, TakesTheNextBestOfWhatItMayNotHave)
{
    kernel.refusedSettings = {SO_TIMESTAMPING, SO_RCVBUFFORCE};
    open();
    ASSERT_EQ(kernel.settings.size(), 6U);
    EXPECT_EQ(kernel.settings[1], Three(SOL_SOCKET, SO_TIMESTAMPNS, 1));
    EXPECT_EQ(kernel.settings[4], Three(SOL_SOCKET, SO_RCVBUF, 16 * 1024 * 1024));
}

TEST_F(CanSocket, BeginsWithWhatTheKernelSaysOfItsController)
{
    can_ctrlmode mode{};
    mode.flags = CAN_CTRLMODE_LISTENONLY;
    auto more = stateOf(CAN_STATE_ERROR_PASSIVE, 130, 5);
    more.push_back(attribute(IFLA_CAN_CTRLMODE, rawBytes(mode)));
    kernel.networks = {test::PlayedKernel::controller(7, "can0", true, more)};
    open();
    EXPECT_TRUE(link->isListenOnly());
    EXPECT_EQ(link->health().state, BusState::Passive);
    EXPECT_EQ(link->health().transmitErrors, 130);
    EXPECT_EQ(link->health().receiveErrors, 5);
    put(0x123, {1});
    loop.runReady();
    ASSERT_TRUE(link->send(standardFrame(1, {})));
    kernel.sendCauses = {ENOBUFS};
    ASSERT_TRUE(link->send(standardFrame(2, {})));
    clock.advance(200us);
    const LinkSymptoms seen = symptomsOf(*link, clock.now());
    EXPECT_EQ(seen.name, "can0");
    EXPECT_EQ(seen.scheme, "socketcan");
    EXPECT_EQ(seen.kind, LinkKind::Can);
    EXPECT_EQ(seen.state, LinkState::Open);
    EXPECT_TRUE(seen.loss.detail.empty());
    EXPECT_EQ(seen.counters.rx, 1U);
    EXPECT_EQ(seen.counters.tx, 2U);
    EXPECT_EQ(seen.health.state, BusState::Passive);
    EXPECT_EQ(seen.bitrate, 500'000);
    EXPECT_EQ(seen.load, 0.0) << "of the first second nothing is known";
    EXPECT_TRUE(seen.listenOnly);
    EXPECT_EQ(seen.receiveCapacity, 100);
    EXPECT_EQ(seen.backlog, 1U);
    clock.advance(2s);
    ASSERT_TRUE(link->send(standardFrame(3, {})));
    clock.advance(1s);
    EXPECT_EQ(symptomsOf(*link, clock.now()).load, link->load(clock.now()));
    EXPECT_GT(symptomsOf(*link, clock.now()).load, 0.0);
}

TEST_F(CanSocket, WhatCannotBeOpenedFailsWithTheCauseAndLeavesNoSocket)
{
    const auto causeOf = [this](const std::string &name) {
        SocketCanLink refused({"socketcan", name, {}}, clock);
        const auto opened = refused.open();
        EXPECT_FALSE(opened) << name;
        EXPECT_EQ(opened.error().fault, Fault::LinkLost);
        return opened ? Error{} : opened.error();
    };
    kernel.networks = {test::PlayedKernel::controller(7, "can0"), test::PlayedKernel::controller(8, "can1", false),
        {2, "eth0", test::interfaceMessage(IFF_UP, {test::named("eth0")}, ARPHRD_ETHER, 2)},
        {3, "fifteenletters1", test::interfaceMessage(IFF_UP, {test::named("fifteenletters1")}, ARPHRD_ETHER, 3)},
        {4, "sixteenletters16", test::interfaceMessage(IFF_UP, {test::named("sixteenletters16")}, ARPHRD_CAN, 4)}};
    EXPECT_EQ(causeOf("can9").text(), "there is no CAN interface can9");
    EXPECT_EQ(causeOf("can9").ailment, Ailment::NotThere);
    EXPECT_EQ(causeOf("sixteenletters16").text(), "there is no CAN interface sixteenletters16") << "no name is so long";
    EXPECT_EQ(causeOf("fifteenletters1").text(), "fifteenletters1 is a network interface, but not one for CAN");
    EXPECT_EQ(causeOf("eth0").text(), "eth0 is a network interface, but not one for CAN");
    EXPECT_EQ(causeOf("can1").text(), "can1 is switched off; bring it up: sudo ip link set can1 up");
    EXPECT_EQ(causeOf("can1").ailment, Ailment::Down);
    kernel.canCauses = {EAFNOSUPPORT};
    EXPECT_EQ(causeOf("can0").text(), "this kernel has no CAN support; load it: sudo modprobe can_raw");
    kernel.canCauses = {0, EMFILE};
    EXPECT_EQ(causeOf("can0").text(), "can0 failed: Too many open files");
    kernel.bindCauses = {ENODEV};
    EXPECT_EQ(causeOf("can0").text(), "can0 is gone") << "between the list and now";
    EXPECT_TRUE(isSocketClosed());
}

TEST_F(CanSocket, OpensAlsoWhereTheKernelDoesNotListItsInterfaces)
{
    kernel.routeCauses = {EPERM};
    open();
    EXPECT_EQ(link->bitrate(), 0);
    EXPECT_EQ(link->health().state, BusState::Active);
    kernel.questions.clear();
    clock.advance(2s);
    EXPECT_EQ(kernel.questions, std::vector<Three>{}) << "nor asks for one that it does not know";
}

TEST_F(CanSocket, IsOpenedInTheBackgroundWithAllThatTheKernelSays)
{
    test::HeldBackground background;
    link->settings().background = &background;
    for (const bool isThere : {false, true}) {
        kernel.networks.clear();
        if (isThere)
            kernel.networks = {test::PlayedKernel::controller(7, "can0")};
        Task<void> opening = link->openSoon();
        opening.start();
        clock.advance(4s);
        ASSERT_EQ(background.waiting(), 1U);
        EXPECT_EQ(background.lane(), "can:can0");
        EXPECT_EQ(link->state(), LinkState::Closed);
        background.release();
        clock.advance(1us);
        ASSERT_TRUE(opening.isFinished());
        if (isThere) {
            ASSERT_TRUE(opening.result());
        } else {
            EXPECT_EQ(opening.result().error().text(), "there is no CAN interface can0");
        }
    }
    EXPECT_EQ(link->state(), LinkState::Open);
    EXPECT_EQ(link->bitrate(), 500'000);
    EXPECT_EQ(link->receiveCapacity(), 100);
    put(0x123, {9});
    loop.runReady();
    ASSERT_EQ(frames.size(), 1U);
    EXPECT_EQ(toText(frames[0]), "123#09");
}

TEST(CanSocketGiven, IsClosedWithTheLinkThatNobodyOpened)
{
    std::array<int, 2> ends{-1, -1};
    ASSERT_EQ(::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()), 0);
    const Descriptor other(ends[1]);
    VirtualClock clock;
    {
        const SocketCanLink link({"socketcan", "pair0", {}}, clock, ends[0]);
    }
    char byte = 0;
    EXPECT_EQ(::recv(other.get(), &byte, 1, MSG_DONTWAIT), 0);
}

// What the interface says meanwhile

TEST_F(CanSocket, WhatTheInterfaceLosesCountsFromItsOpeningOnAndOverrunsOnce)
{
    const auto say = [this](std::uint64_t overruns, std::uint64_t dropped) {
        kernel.networks = {test::PlayedKernel::controller(7, "can0", true, {}, {losses(overruns, dropped)})};
    };
    const auto overrun = [this] {
        put(CAN_ERR_FLAG | CAN_ERR_CRTL, {0, CAN_ERR_CRTL_RX_OVERFLOW, 0, 0, 0, 0, 0, 0});
        loop.runReady();
        return link->counters().lost;
    };
    say(20, 300);
    open();
    clock.advance(499ms);
    say(23, 307);
    EXPECT_EQ(link->counters().lost, 0U);
    clock.advance(1ms);
    EXPECT_EQ(link->counters().lost, 10U) << "looked at twice a second";
    for (int told = 0; told < 3; ++told)
        EXPECT_EQ(overrun(), 10U) << "one of the three that the interface told already";
    EXPECT_EQ(overrun(), 11U);
    kernel.networks.clear();
    clock.advance(1s);
    EXPECT_EQ(link->counters().lost, 11U);
    EXPECT_EQ(link->bitrate(), 500'000) << "as last told";
}

TEST_F(CanSocket, TheStateOfItsControllerIsThatOfTheKernelAndBusOffLosesTheLink)
{
    const auto hear = [this](std::uint32_t state, std::uint16_t transmitErrors, std::uint16_t receiveErrors) {
        kernel.networks
            = {test::PlayedKernel::controller(7, "can0", true, stateOf(state, transmitErrors, receiveErrors))};
        clock.advance(500ms);
    };
    open();
    hear(CAN_STATE_ERROR_WARNING, 97, 3);
    EXPECT_EQ(link->health().state, BusState::Warning);
    EXPECT_EQ(link->health().transmitErrors, 97);
    EXPECT_EQ(link->health().receiveErrors, 3);
    EXPECT_EQ(link->state(), LinkState::Open);
    hear(CAN_STATE_BUS_OFF, 255, 0);
    EXPECT_EQ(link->state(), LinkState::Lost);
    EXPECT_EQ(link->loss().text(),
        "bus-off: can0 left the bus after too many errors; check wiring, termination and bit rate");
    EXPECT_EQ(link->loss().ailment, Ailment::BusOff);
    EXPECT_EQ(clock.armed(), 0U) << "of a lost link nothing is watched";
}

TEST_F(CanSocket, BusOffIsToldOnceWhereAnErrorFrameAndTheKernelBothTellIt)
{
    open();
    std::vector<LinkState> states;
    subscriptions.push_back(link->stateChanged().add([&states](LinkState state) { states.push_back(state); }));
    kernel.networks = {test::PlayedKernel::controller(7, "can0", true, stateOf(CAN_STATE_BUS_OFF, 255, 0))};
    put(CAN_ERR_FLAG | CAN_ERR_BUSOFF, {0, 0, 0, 0, 0, 0, 0, 0});
    loop.runReady();
    EXPECT_EQ(states, std::vector<LinkState>{LinkState::Lost});
    EXPECT_EQ(link->loss().ailment, Ailment::BusOff);
    EXPECT_EQ(link->health().state, BusState::BusOff);
}

TEST_F(CanSocket, FramesThatWaitUnreadComeBeforeABusOffThatOnlyTheKernelTells)
{
    open();
    for (std::uint32_t i = 0; i < 100; ++i)
        put(i);
    kernel.networks = {test::PlayedKernel::controller(7, "can0", true, stateOf(CAN_STATE_BUS_OFF, 255, 0))};
    link->recount();
    EXPECT_EQ(link->state(), LinkState::Open) << "who counts is not called back";
    clock.advance(1ms);
    EXPECT_EQ(link->state(), LinkState::Lost);
    EXPECT_EQ(link->counters().rx, 100U);
}

TEST_F(CanSocket, AVirtualInterfaceKnowsOfNoState)
{
    kernel.networks = {{7, "can0", test::interfaceMessage(IFF_UP, {test::named("can0"), test::kindOf("vcan")})}};
    open();
    put(CAN_ERR_FLAG | CAN_ERR_CRTL, {0, CAN_ERR_CRTL_TX_PASSIVE, 0, 0, 0, 0, 0, 0});
    loop.runReady();
    clock.advance(1s);
    EXPECT_EQ(link->health().state, BusState::Passive) << "as its frames told";
    EXPECT_EQ(link->state(), LinkState::Open);
}

TEST_F(CanSocket, InTheBackgroundTheKernelIsAskedOnceAtATimeAndNobodyWaitsForIt)
{
    test::HeldBackground background;
    open();
    link->settings().background = &background;
    kernel.questions.clear();
    kernel.networks = {test::PlayedKernel::controller(7, "can0", true, {}, {losses(0, 4)})};
    clock.advance(500ms);
    ASSERT_EQ(background.waiting(), 1U);
    EXPECT_EQ(background.lane(), "can:can0");
    clock.advance(1s);
    link->recount();
    EXPECT_EQ(background.waiting(), 1U) << "not again before the kernel has answered";
    EXPECT_EQ(kernel.questions, std::vector<Three>{});
    background.release();
    EXPECT_EQ(kernel.questions, std::vector<Three>({{RTM_GETLINK, NLM_F_REQUEST, 7}}));
    EXPECT_EQ(link->counters().lost, 4U);
    kernel.networks.clear();
    clock.advance(500ms);
    ASSERT_EQ(background.waiting(), 1U);
    background.release();
    EXPECT_EQ(link->bitrate(), 500'000) << "it is gone: nothing new";
    kernel.networks = {test::PlayedKernel::controller(7, "can0", true, {}, {losses(0, 9)})};
    link->recount();
    link->close();
    background.release();
    EXPECT_EQ(link->counters().lost, 4U) << "of a link that is closed";
}

} // namespace
} // namespace mb
