// SPDX-License-Identifier: GPL-3.0-or-later
// What the kernel says of a CAN interface (RTM_NEWLINK, linux/can/netlink.h), made here byte by byte, so that no CAN is needed.
#include "netlinkbytes.h"
#include "transport/backends/caninterface.h"
#include "transport/linkcatalog.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include <linux/can/netlink.h>
#include <linux/if_link.h>
#include <net/if.h>
#include <net/if_arp.h>

namespace mb {
namespace {

using test::attribute;
using test::interfaceMessage;
using test::joined;
using test::kindOf;
using test::named;
using test::NetlinkBytes;
using test::rawBytes;

CanInterface interfaceOf(const std::vector<NetlinkBytes> &attributes, unsigned flags = IFF_UP)
{
    const auto interface = canInterfaceFrom(interfaceMessage(flags, attributes));
    EXPECT_TRUE(interface);
    return interface.value_or(CanInterface{});
}

TEST(CanInterfaceMessage, TellsEverythingOfAController)
{
    can_bittiming timing{};
    timing.bitrate = 500'000;
    timing.sample_point = 875;
    can_ctrlmode mode{};
    mode.flags = CAN_CTRLMODE_LISTENONLY;
    can_berr_counter counters{};
    counters.txerr = 131;
    counters.rxerr = 9;
    rtnl_link_stats64 counted{};
    counted.rx_over_errors = 1;
    counted.rx_fifo_errors = 20;
    counted.rx_dropped = 300;
    counted.rx_missed_errors = 4000;
    counted.tx_dropped = 50'000;
    const CanInterface interface = interfaceOf({named("mbcan7"), attribute(IFLA_STATS64, rawBytes(counted)),
        kindOf("can",
            {attribute(IFLA_CAN_BITTIMING, rawBytes(timing)),
                attribute(IFLA_CAN_STATE, rawBytes(std::uint32_t{CAN_STATE_ERROR_PASSIVE})),
                attribute(IFLA_CAN_RESTART_MS, rawBytes(std::uint32_t{1})),
                attribute(IFLA_CAN_CTRLMODE, rawBytes(mode)), attribute(IFLA_CAN_BERR_COUNTER, rawBytes(counters)),
                attribute(IFLA_CAN_CTRLMODE_EXT,
                    attribute(IFLA_CAN_CTRLMODE_SUPPORTED, rawBytes(std::uint32_t{CAN_CTRLMODE_LISTENONLY})))})});
    EXPECT_EQ(interface.index, 7);
    EXPECT_EQ(interface.name, "mbcan7");
    EXPECT_TRUE(interface.up);
    EXPECT_EQ(interface.kind, CanInterface::Kind::Controller);
    EXPECT_EQ(interface.driver, "can") << "nothing in sysfs names it";
    EXPECT_EQ(interface.bitrate, 500'000);
    EXPECT_EQ(interface.samplePoint, 0.875);
    EXPECT_EQ(interface.state, BusState::Passive);
    EXPECT_TRUE(interface.restarts);
    EXPECT_TRUE(interface.listenOnly);
    EXPECT_TRUE(interface.canListenOnly);
    EXPECT_EQ(interface.transmitErrors, 131);
    EXPECT_EQ(interface.receiveErrors, 9);
    EXPECT_EQ(interface.overruns, 21U);
    EXPECT_EQ(interface.dropped, 54'300U);
}

TEST(CanInterfaceMessage, SaysNothingThatTheKernelDoesNot)
{
    can_ctrlmode mode{};
    mode.flags = CAN_CTRLMODE_LOOPBACK;
    const CanInterface interface = interfaceOf(
        {named("mbcan7"),
            kindOf("can",
                {attribute(IFLA_CAN_RESTART_MS, rawBytes(std::uint32_t{0})),
                    attribute(IFLA_CAN_CTRLMODE, rawBytes(mode)),
                    attribute(IFLA_CAN_CTRLMODE_EXT,
                        attribute(IFLA_CAN_CTRLMODE_SUPPORTED, rawBytes(std::uint32_t{CAN_CTRLMODE_LOOPBACK})))})},
        0);
    EXPECT_FALSE(interface.up);
    EXPECT_EQ(interface.bitrate, 0);
    EXPECT_EQ(interface.samplePoint, 0.0);
    EXPECT_EQ(interface.state, BusState::Active);
    EXPECT_FALSE(interface.restarts);
    EXPECT_FALSE(interface.listenOnly);
    EXPECT_FALSE(interface.canListenOnly);
    EXPECT_FALSE(interface.transmitErrors);
    EXPECT_FALSE(interface.receiveErrors);
}

TEST(CanInterfaceMessage, EveryStateOfTheControllerHasItsName)
{
    for (const auto &[kernel, state] :
        std::vector<std::pair<std::uint32_t, BusState>>{{CAN_STATE_ERROR_ACTIVE, BusState::Active},
            {CAN_STATE_ERROR_WARNING, BusState::Warning}, {CAN_STATE_ERROR_PASSIVE, BusState::Passive},
            {CAN_STATE_BUS_OFF, BusState::BusOff}, {CAN_STATE_STOPPED, BusState::Active}})
        EXPECT_EQ(
            interfaceOf({named("mbcan7"), kindOf("can", {attribute(IFLA_CAN_STATE, rawBytes(kernel))})}).state, state)
            << kernel;
}

TEST(CanInterfaceMessage, TellsControllersFromAdaptersOnSerialLinesAndFromMemory)
{
    const auto rates = attribute(IFLA_CAN_BITRATE_CONST, rawBytes(std::uint32_t{500'000}));
    const auto timing = attribute(IFLA_CAN_BITTIMING_CONST, rawBytes(can_bittiming_const{}));
    const auto text = [](const CanInterface &interface) {
        return std::to_string(static_cast<int>(interface.kind)) + ' ' + interface.driver;
    };
    const auto kind = [](CanInterface::Kind value) { return std::to_string(static_cast<int>(value)); };
    using Kind = CanInterface::Kind;
    EXPECT_EQ(text(interfaceOf({named("mbv0"), kindOf("vcan")})), kind(Kind::Virtual) + " vcan");
    EXPECT_EQ(text(interfaceOf({named("mbv0"), kindOf("vxcan")})), kind(Kind::Virtual) + " vxcan");
    EXPECT_EQ(text(interfaceOf({named("slcan7"), kindOf("can")})), kind(Kind::SerialLine) + " slcan");
    EXPECT_EQ(text(interfaceOf({named("mbcan7"), kindOf("can", {rates})})), kind(Kind::SerialLine) + " slcan");
    EXPECT_EQ(text(interfaceOf({named("mbcan7"), kindOf("can", {rates, timing})})), kind(Kind::Controller) + " can");
    EXPECT_EQ(text(interfaceOf({named("mbcan7"), kindOf("can", {timing})})), kind(Kind::Controller) + " can");
    EXPECT_EQ(text(interfaceOf({named("mbx0"), kindOf("tunnel", {rates})})), kind(Kind::Other) + " tunnel")
        << "rates are told of controllers only";
    EXPECT_EQ(text(interfaceOf({named("mbx0")})), kind(Kind::Other) + " ");
}

TEST(CanInterfaceMessage, OtherNetworksAndHalfAMessageAreNoInterface)
{
    EXPECT_FALSE(canInterfaceFrom(interfaceMessage(IFF_UP, {named("eth0")}, ARPHRD_ETHER)));
    EXPECT_FALSE(canInterfaceFrom({}));
    NetlinkBytes half = interfaceMessage(IFF_UP, {named("mbcan7")});
    EXPECT_EQ(canInterfaceFrom(half)->name, "mbcan7");
    half.resize(sizeof(ifinfomsg) + 6);
    EXPECT_EQ(canInterfaceFrom(half)->name, "") << "an attribute that is cut";
    half.resize(sizeof(ifinfomsg) - 1);
    EXPECT_FALSE(canInterfaceFrom(half));
}

std::string rowText(const CanInterface &interface)
{
    const LinkListing row = listed(interface);
    return row.link.text() + " | " + std::string(toString(row.state)) + " | " + row.detail.english()
        + (row.openable ? " | openable" : "") + (row.listenable ? " | listenable" : "");
}

TEST(CanListing, DescribesAnInterfaceThatCanBeUsed)
{
    CanInterface interface;
    interface.name = "can0";
    interface.kind = CanInterface::Kind::Controller;
    interface.driver = "gs_usb";
    interface.up = true;
    EXPECT_EQ(rowText(interface), "socketcan:can0 | up | gs_usb | openable");
    interface.bitrate = 1'000'000;
    interface.samplePoint = 0.8752;
    interface.canListenOnly = true;
    EXPECT_EQ(
        rowText(interface), "socketcan:can0 | up | gs_usb, 1 Mbit/s, sample point 87.5 % | openable | listenable");
    interface.bitrate = 83'333;
    interface.samplePoint = 0.0;
    interface.listenOnly = true;
    interface.state = BusState::Warning;
    EXPECT_EQ(rowText(interface),
        "socketcan:can0 | up | gs_usb, 83.333 kbit/s, listen-only: nothing can be sent, error-warning | openable | "
        "listenable");
    interface.listenOnly = interface.canListenOnly = false;
    interface.bitrate = 12'500;
    interface.state = BusState::Passive;
    EXPECT_EQ(rowText(interface), "socketcan:can0 | up | gs_usb, 12.5 kbit/s, error-passive | openable");
    interface.kind = CanInterface::Kind::Virtual;
    EXPECT_EQ(rowText(interface), "socketcan:can0 | up | virtual | openable");
    CanInterface unknown;
    unknown.name = "can1";
    unknown.up = true;
    unknown.bitrate = 125'000;
    EXPECT_EQ(rowText(unknown), "socketcan:can1 | up | 125 kbit/s | openable");
}

TEST(CanListing, NamesWhyAnInterfaceCannotBeUsed)
{
    CanInterface interface;
    interface.name = "can0";
    interface.kind = CanInterface::Kind::Controller;
    interface.up = false;
    LinkListing row = listed(interface);
    EXPECT_EQ(row.state, ListingState::Down);
    EXPECT_FALSE(row.openable);
    EXPECT_EQ(row.diagnosis.ailment, Ailment::Down);
    EXPECT_NE(row.diagnosis.command.find("bitrate"), std::string::npos) << row.diagnosis.command;
    interface.bitrate = 500'000;
    EXPECT_EQ(listed(interface).diagnosis.command.find("bitrate"), std::string::npos) << "it has one";
    interface.up = true;
    interface.state = BusState::BusOff;
    row = listed(interface);
    EXPECT_EQ(row.state, ListingState::BusOff);
    EXPECT_FALSE(row.openable);
    EXPECT_EQ(row.detail.english(), row.diagnosis.message().english());
    EXPECT_FALSE(row.diagnosis.command.empty()) << "somebody must bring it back";
    interface.restarts = true;
    EXPECT_TRUE(listed(interface).diagnosis.command.empty()) << "it comes back by itself";
    EXPECT_EQ(listed(interface).state, ListingState::BusOff);
}

} // namespace
} // namespace mb
