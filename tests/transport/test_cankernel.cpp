// SPDX-License-Identifier: GPL-3.0-or-later
// What the kernel tells of its CAN interfaces, and when they come and go: asked in its own words, of a kernel that is played.
#include "async/virtualclock.h"
#include "playedkernel.h"
#include "support/eventloop.h"
#include "transport/backends/caninterface.h"
#include "transport/backends/cansocket.h"
#include "transport/linkcatalog.h"
#include "transport/linkwatch.h"

#include <gtest/gtest.h>

#include <array>
#include <cerrno>
#include <string>
#include <vector>

#include <linux/can.h>
#include <linux/can/netlink.h>
#include <linux/can/raw.h>
#include <net/if.h>
#include <sys/socket.h>

namespace mb {
namespace {

using namespace std::chrono_literals;
using Three = test::PlayedKernel::Three;

struct CanKernel : testing::Test {
    static test::PlayedKernel::Network ethernet()
    {
        return {2, "eth0", test::interfaceMessage(IFF_UP, {test::named("eth0")}, ARPHRD_ETHER, 2)};
    }
    static test::PlayedKernel::Network busOffOne(std::uint32_t restart)
    {
        return test::PlayedKernel::controller(9, "can2", true,
            {test::attribute(IFLA_CAN_STATE, test::rawBytes(std::uint32_t{CAN_STATE_BUS_OFF})),
                test::attribute(IFLA_CAN_RESTART_MS, test::rawBytes(restart))});
    }
    [[nodiscard]] static std::vector<std::string> canRows()
    {
        std::vector<std::string> rows;
        for (const LinkListing &row : listLinks()) {
            if (row.kind == LinkKind::Can)
                rows.push_back(row.link.text() + " | " + std::string(toString(row.state)) + " | " + row.detail.english()
                    + (row.openable ? " | openable" : "") + (row.diagnosis.isHealthy() ? "" : " | ill"));
        }
        return rows;
    }
    [[nodiscard]] static std::vector<std::string> names()
    {
        std::vector<std::string> all;
        for (const CanInterface &interface : canInterfaces().value_or(std::vector<CanInterface>{}))
            all.push_back(std::to_string(interface.index) + ' ' + interface.name);
        return all;
    }

    test::PlayedKernel kernel;
};

using Rows = std::vector<std::string>;

TEST_F(CanKernel, ListsItsInterfacesOfCanAndNoOthersWithWhyOneCannotBeUsed)
{
    kernel.networks = {ethernet(), test::PlayedKernel::controller(7, "can0"),
        test::PlayedKernel::controller(8, "can1", false), busOffOne(0)};
    EXPECT_EQ(canRows(),
        (Rows{"socketcan:can0 | up | can, 500 kbit/s, sample point 87.5 % | openable",
            "socketcan:can1 | down | can1 is switched off; bring it up: sudo ip link set can1 up | ill",
            "socketcan:can2 | bus-off | can2 is bus-off; check wiring, termination and bit rate, then: sudo ip link "
            "set "
            "can2 type can restart | ill"}));
}

TEST_F(CanKernel, HasOneRowWhereItHasNoInterfaceAndWhereItDoesNotListThem)
{
    kernel.networks = {ethernet()};
    EXPECT_EQ(canRows(), Rows{"socketcan: | absent | there is no CAN interface; plug in an adapter | ill"});
    kernel.routeCauses = {EMFILE};
    EXPECT_EQ(
        canRows(), Rows{"socketcan: | absent | the kernel does not list its interfaces: Too many open files | ill"});
}

TEST_F(CanKernel, WithoutCanSocketsSaysWhyAndWhatHelps)
{
    const auto because = [this](int cause) {
        kernel.canCauses = {cause};
        return whyNoCan();
    };
    EXPECT_EQ(because(0), std::nullopt);
    const Diagnosis forbidden{Ailment::NoPermission, say("no permission to open CAN sockets here"),
        say("allow them in the container or sandbox"), {}};
    const Diagnosis without{
        Ailment::NoCan, say("this kernel has no CAN support"), say("load it"), "sudo modprobe can_raw"};
    EXPECT_EQ(because(EPERM), forbidden);
    EXPECT_EQ(because(EACCES), forbidden);
    EXPECT_EQ(because(EAFNOSUPPORT), without);
    EXPECT_EQ(because(EPROTONOSUPPORT), without);
    EXPECT_EQ(because(EMFILE),
        (Diagnosis{Ailment::Failed, say("CAN sockets cannot be opened: %1", "Too many open files"), {}, {}}));
    EXPECT_EQ(kernel.opened, std::vector<Three>(6, {PF_CAN, SOCK_RAW | SOCK_CLOEXEC, CAN_RAW}));
    kernel.canCauses = {EACCES, EAFNOSUPPORT};
    EXPECT_EQ(canRows(),
        Rows{"socketcan: | no-permission | no permission to open CAN sockets here; allow them in the container or "
             "sandbox | ill"});
    EXPECT_EQ(
        canRows(), Rows{"socketcan: | absent | this kernel has no CAN support; load it: sudo modprobe can_raw | ill"});
    EXPECT_EQ(kernel.questions, std::vector<Three>{}) << "there is nothing to ask for";
}

TEST_F(CanKernel, IsAskedForAllOfThemOnceAndForOneByItsIndex)
{
    kernel.networks = {test::PlayedKernel::controller(7, "can0"), test::PlayedKernel::controller(8, "can1")};
    EXPECT_EQ(names(), (Rows{"7 can0", "8 can1"}));
    EXPECT_EQ(canInterface(8).value_or(CanInterface{}).name, "can1");
    EXPECT_FALSE(canInterface(9));
    EXPECT_EQ(kernel.opened.front(), Three(AF_NETLINK, SOCK_RAW | SOCK_CLOEXEC, NETLINK_ROUTE));
    EXPECT_EQ(kernel.questions[0], Three(RTM_GETLINK, NLM_F_REQUEST | NLM_F_DUMP, 0));
    EXPECT_EQ(kernel.questions[1], Three(RTM_GETLINK, NLM_F_REQUEST, 8));
    kernel.questions.clear();
    EXPECT_FALSE(canInterface(0)) << "no interface has that index";
    EXPECT_FALSE(canInterface(-1));
    kernel.routeCauses = {EMFILE};
    EXPECT_FALSE(canInterface(7));
    EXPECT_EQ(kernel.questions, std::vector<Three>{});
}

TEST_F(CanKernel, AnswersInSeveralDatagramsUntilOneOfThemEndsTheList)
{
    const auto interface = [](int index) {
        return test::netlinkMessage(
            RTM_NEWLINK, test::PlayedKernel::controller(index, "can" + std::to_string(index)).message);
    };
    const auto done = test::netlinkMessage(NLMSG_DONE, test::rawBytes(0));
    const auto error = test::netlinkMessage(NLMSG_ERROR, test::rawBytes(nlmsgerr{}));
    const auto address = test::netlinkMessage(
        RTM_NEWADDR, test::interfaceMessage(IFF_UP, {test::named("can6")}, ARPHRD_CAN, 6)); // of something else
    auto cut = interface(5);
    cut.resize(cut.size() - 4);
    auto empty = test::rawBytes(nlmsghdr{}); // of length 0
    const auto listed = [this](std::vector<test::NetlinkBytes> datagrams) {
        kernel.datagrams = std::move(datagrams);
        return names();
    };
    EXPECT_EQ(listed({test::joined({interface(1), address, interface(2)}), interface(3),
                  test::joined({interface(4), done, interface(5)}), interface(6)}),
        (Rows{"1 can1", "2 can2", "3 can3", "4 can4"}));
    EXPECT_EQ(listed({test::joined({interface(1), error, interface(2)}), interface(3)}), Rows{"1 can1"});
    EXPECT_EQ(listed({test::joined({interface(1), cut}), interface(3)}), Rows{"1 can1"});
    EXPECT_EQ(listed({test::joined({interface(1), empty}), interface(3)}), Rows{"1 can1"});
    EXPECT_EQ(listed({interface(1), {std::byte{1}}, interface(2)}), (Rows{"1 can1", "2 can2"}))
        << "less than a head is no message";
    EXPECT_EQ(listed({}), Rows{});
}

// Coming and going

struct CanNotices : CanKernel {
    CanNotices()
        : heard(watch.changed().add([this] { ++told; }))
    {
    }
    void notify(int type, int hardware = ARPHRD_CAN)
    {
        const auto bytes = test::netlinkMessage(type, test::interfaceMessage(IFF_UP, {test::named("can0")}, hardware));
        ASSERT_EQ(::send(kernel.notices, bytes.data(), bytes.size(), 0), ssize_t(bytes.size()));
        loop.runReady();
    }
    /// How often it was told once all has settled.
    int toldLater()
    {
        clock.advance(1s);
        return std::exchange(told, 0);
    }

    test::EventLoop loop;
    VirtualClock clock;
    LinkWatch watch{clock};
    int told = 0;
    Subscription heard;
};

TEST_F(CanNotices, AreToldOnceTwentyMillisecondsAfterTheFirst)
{
    EXPECT_EQ(
        kernel.opened, std::vector<Three>({{AF_NETLINK, SOCK_RAW | SOCK_CLOEXEC | SOCK_NONBLOCK, NETLINK_ROUTE}}));
    EXPECT_EQ(kernel.bound, std::vector<Three>({{AF_NETLINK, RTMGRP_LINK, 0}}));
    notify(RTM_NEWLINK);
    clock.advance(15ms);
    notify(RTM_NEWLINK);
    clock.advance(5ms - 1us);
    EXPECT_EQ(told, 0);
    clock.advance(1us);
    EXPECT_EQ(told, 1);
    clock.advance(1s);
    EXPECT_EQ(told, 1);
    notify(RTM_DELLINK);
    clock.advance(20ms);
    EXPECT_EQ(told, 2);
}

TEST_F(CanNotices, OfOtherNetworksAndOfOtherThingsAreNotTold)
{
    notify(RTM_NEWLINK, ARPHRD_ETHER);
    notify(RTM_DELLINK, ARPHRD_ETHER);
    notify(RTM_NEWADDR);
    EXPECT_EQ(toldLater(), 0);
    const auto other = test::netlinkMessage(RTM_NEWLINK, test::interfaceMessage(IFF_UP, {}, ARPHRD_ETHER));
    const auto can = test::netlinkMessage(RTM_NEWLINK, test::interfaceMessage(IFF_UP, {}));
    const auto both = test::joined({can, other});
    ASSERT_EQ(::send(kernel.notices, both.data(), both.size(), 0), ssize_t(both.size()));
    loop.runReady();
    EXPECT_EQ(toldLater(), 1) << "one of CAN among them";
}

TEST_F(CanNotices, ThatWereLostAreToldBecauseNobodyKnowsWhatTheyWere)
{
    kernel.noticeCauses = {ENOBUFS};
    notify(RTM_NEWADDR);
    EXPECT_EQ(toldLater(), 1);
    kernel.noticeCauses = {EINTR};
    notify(RTM_NEWADDR);
    EXPECT_EQ(toldLater(), 0);
}

TEST_F(CanNotices, OneWhoIsGoneLeavesNoSocketAndOneWithoutNoticesTellsNothing)
{
    const auto isClosed = [this] {
        std::byte byte{};
        return ::recv(kernel.notices, &byte, 1, MSG_DONTWAIT) == 0;
    };
    const int first = kernel.notices;
    {
        const LinkWatch second(clock);
        EXPECT_NE(kernel.notices, first);
        EXPECT_FALSE(isClosed());
    }
    EXPECT_TRUE(isClosed());
    kernel.bindCauses = {EPERM};
    {
        const LinkWatch deaf(clock);
        EXPECT_FALSE(isClosed()) << "kept until its end, unheard";
    }
    EXPECT_TRUE(isClosed());
    kernel.routeCauses = {EAFNOSUPPORT};
    kernel.bound.clear();
    const LinkWatch none(clock);
    EXPECT_EQ(kernel.bound, std::vector<Three>{});
}

} // namespace
} // namespace mb
