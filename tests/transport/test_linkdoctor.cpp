// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/backends/caninterface.h"
#include "transport/linkcatalog.h"

#include <gtest/gtest.h>

using namespace mb;
using namespace std::chrono_literals;

namespace {

constexpr Instant now{100s};

/// An open link that works.
LinkSymptoms working()
{
    LinkSymptoms link;
    link.name = "can0";
    link.scheme = "socketcan";
    link.state = LinkState::Open;
    link.bitrate = 1'000'000;
    link.receiveCapacity = 5000;
    link.health.lastReceived = now - 10ms;
    return link;
}

Ailment ailment(const LinkSymptoms &link)
{
    return diagnose(link, now, Diagnosis{}, true).ailment;
}

CanInterface controller()
{
    CanInterface interface;
    interface.name = "can0";
    interface.kind = CanInterface::Kind::Controller;
    interface.up = true;
    interface.bitrate = 500'000;
    return interface;
}

} // namespace

TEST(LinkDoctor, AWorkingLinkIsHealthy)
{
    EXPECT_EQ(diagnose(working(), now, Diagnosis{}, true), Diagnosis{});
    EXPECT_EQ(diagnose(working(), now, Diagnosis{}, true).text(), "");
}

TEST(LinkDoctor, AnInterfaceThatIsOffNamesTheCommandThatBringsItUp)
{
    CanInterface interface = controller();
    interface.up = false;
    EXPECT_EQ(diagnose(interface).text(), "can0 is switched off; bring it up: sudo ip link set can0 up");
    interface.bitrate = 0;
    const Diagnosis found = diagnose(interface);
    EXPECT_EQ(found.ailment, Ailment::Down);
    EXPECT_EQ(found.command, "sudo ip link set can0 up type can bitrate 1000000");
    interface.kind = CanInterface::Kind::Virtual;
    EXPECT_EQ(diagnose(interface).command, "sudo ip link set can0 up") << "it has no bit rate";
}

TEST(LinkDoctor, BusOffIsRestartedByHandUnlessTheInterfaceDoesItItself)
{
    CanInterface interface = controller();
    interface.state = BusState::BusOff;
    EXPECT_EQ(diagnose(interface).ailment, Ailment::BusOff);
    EXPECT_EQ(diagnose(interface).command, "sudo ip link set can0 type can restart");
    interface.restarts = true;
    EXPECT_EQ(diagnose(interface).ailment, Ailment::BusOff);
    EXPECT_EQ(diagnose(interface).command, "");
    interface.state = BusState::Passive;
    EXPECT_TRUE(diagnose(interface).isHealthy()) << "it can be opened";
}

TEST(LinkDoctor, OfALostLinkTheInterfaceSaysWhy)
{
    LinkSymptoms link = working();
    link.state = LinkState::Lost;
    link.loss.detail = say("can0 was switched off");
    CanInterface off = controller();
    off.up = false;
    EXPECT_EQ(diagnose(link, now, diagnose(off), false).ailment, Ailment::Down);
    EXPECT_EQ(diagnose(link, now, std::nullopt, false).ailment, Ailment::Gone);
    EXPECT_EQ(diagnose(link, now, Diagnosis{}, false).ailment, Ailment::Failed) << "it is up again: open it";
    EXPECT_EQ(diagnose(link, now, Diagnosis{}, false).cause, "can0 was switched off");
    link.health.state = BusState::BusOff;
    EXPECT_EQ(diagnose(link, now, Diagnosis{}, false).ailment, Ailment::BusOff);
    link.scheme = "sim";
    EXPECT_EQ(diagnose(link, now, std::nullopt, false).ailment, Ailment::BusOff);
    EXPECT_EQ(diagnose(link, now, std::nullopt, false).command, "") << "no command reaches a simulated bus";
}

TEST(LinkDoctor, ALostLinkOfWhichNothingElseIsKnownIsOpenedAgainOrBroughtUp)
{
    LinkSymptoms link = working();
    link.state = LinkState::Lost;
    link.loss = Error{Fault::LinkLost};
    EXPECT_EQ(diagnose(link, now, Diagnosis{}, false),
        (Diagnosis{Ailment::Failed, say("can0 is not open"), say("reconnect"), {}}));
    link.loss = {Fault::LinkLost, say("can0 was switched off"), {}, {}, Ailment::Down};
    EXPECT_EQ(diagnose(link, now, Diagnosis{}, false),
        (Diagnosis{Ailment::Down, say("can0 was switched off"), say("bring it up"), "sudo ip link set can0 up"}))
        << "it was up, so it has its bit rate";
    link.loss.command = "sudo ifup can0";
    link.loss.remedy = say("ask who set it up");
    EXPECT_EQ(diagnose(link, now, Diagnosis{}, false),
        (Diagnosis{Ailment::Down, say("can0 was switched off"), say("ask who set it up"), "sudo ifup can0"}));
    link.loss = {Fault::LinkLost, say("can0 is gone"), {}, {}, Ailment::Gone};
    EXPECT_EQ(
        diagnose(link, now, Diagnosis{}, false), (Diagnosis{Ailment::Gone, say("can0 is gone"), say("reconnect"), {}}));
    link.health.state = BusState::BusOff;
    link.kind = LinkKind::Serial;
    EXPECT_EQ(diagnose(link, now, Diagnosis{}, false).ailment, Ailment::Gone) << "no bus, no state of one";
}

TEST(LinkDoctor, OfALinkThatIsClosedOrNotOfCanNothingIsWrong)
{
    LinkSymptoms link = working();
    link.listenOnly = true;
    EXPECT_EQ(ailment(link), Ailment::ListenOnly);
    link.state = LinkState::Closed;
    EXPECT_EQ(ailment(link), Ailment::None);
    link.state = LinkState::Open;
    link.kind = LinkKind::Serial;
    EXPECT_EQ(ailment(link), Ailment::None);
}

TEST(LinkDoctor, WhatWasThreeSecondsAgoIsOverAndASecondIsTooLongToBeStuck)
{
    LinkSymptoms link = working();
    link.health.lastReceived = now - 10s;
    link.health.lastAcknowledgeError = now - 3s + 1ns;
    EXPECT_EQ(ailment(link), Ailment::NobodyAcknowledges);
    link.health.lastAcknowledgeError = now - 3s;
    EXPECT_EQ(ailment(link), Ailment::None);
    link.health.lastProtocolError = now - 3s + 1ns;
    EXPECT_EQ(ailment(link), Ailment::WrongBitrate);
    link.health.lastReceived = now - 3s;
    EXPECT_EQ(ailment(link), Ailment::WrongBitrate);
    link.health.lastReceived = now - 3s + 1ns;
    EXPECT_EQ(ailment(link), Ailment::None);
    link.health.lastReceived = now;
    link.backlog = 1;
    link.health.stuckSince = now - 1s;
    EXPECT_EQ(ailment(link), Ailment::Busy);
    link.health.stuckSince = now - 1s + 1ns;
    EXPECT_EQ(ailment(link), Ailment::None);
    link.counters.lost = 1;
    link.receiveCapacity = 2000;
    EXPECT_EQ(ailment(link), Ailment::None);
    link.receiveCapacity = 1999;
    EXPECT_EQ(ailment(link), Ailment::Losing);
    link.receiveCapacity = 0;
    EXPECT_EQ(ailment(link), Ailment::None) << "it is not known";
}

TEST(LinkDoctor, NobodyAcknowledgesUntilSomebodyIsHeard)
{
    LinkSymptoms link = working();
    link.health.lastAcknowledgeError = now - 100ms;
    link.health.lastReceived = now - 200ms;
    EXPECT_EQ(ailment(link), Ailment::NobodyAcknowledges);
    EXPECT_NE(diagnose(link, now, Diagnosis{}, true).remedy.english().find("1 Mbit/s"), std::string::npos);
    link.health.lastReceived = now - 50ms;
    EXPECT_EQ(ailment(link), Ailment::None) << "who sends also acknowledges";
    link.health.lastReceived.reset();
    link.health.lastAcknowledgeError = now - 4s;
    EXPECT_EQ(ailment(link), Ailment::None) << "that is long ago";
}

TEST(LinkDoctor, FramesThatWaitTellOfNobodyWhereTheControllerDoesNot)
{
    LinkSymptoms link = working();
    link.backlog = 3;
    link.health.stuckSince = now - 2s;
    link.health.lastReceived = now - 5s;
    EXPECT_EQ(ailment(link), Ailment::NobodyAcknowledges);
    link.health.lastReceived = now;
    EXPECT_EQ(ailment(link), Ailment::Busy) << "the bus is alive, and has no room";
    link.backlog = 0;
    EXPECT_EQ(ailment(link), Ailment::None) << "nothing waits any more";
    link.backlog = 3;
    link.health.stuckSince.reset();
    EXPECT_EQ(ailment(link), Ailment::None) << "it has not been stuck";
    link.health.stuckSince = now - 300ms;
    EXPECT_EQ(ailment(link), Ailment::None) << "a full queue for a moment is normal";
}

TEST(LinkDoctor, OnlyDisturbedFramesMeanAnotherBitRate)
{
    LinkSymptoms link = working();
    link.health.lastReceived.reset();
    link.health.lastProtocolError = now - 100ms;
    const Diagnosis found = diagnose(link, now, Diagnosis{}, true);
    EXPECT_EQ(found.ailment, Ailment::WrongBitrate);
    EXPECT_NE(found.cause.english().find("1 Mbit/s"), std::string::npos);
    EXPECT_NE(found.command.find("listen-only on"), std::string::npos);
    const Diagnosis deaf = diagnose(link, now, Diagnosis{}, false);
    EXPECT_EQ(deaf.command.find("listen-only on"), std::string::npos) << "an adapter without the mode would disturb";
    EXPECT_NE(deaf.remedy.english().find("cannot listen"), std::string::npos);
    link.health.lastReceived = now - 100ms;
    link.health.state = BusState::Passive;
    EXPECT_EQ(ailment(link), Ailment::Disturbed) << "good frames arrive too";
}

TEST(LinkDoctor, AnErrorPassiveControllerIsDisturbed)
{
    LinkSymptoms link = working();
    link.health.state = BusState::Passive;
    link.health.transmitErrors = 136;
    link.health.receiveErrors = 2;
    EXPECT_EQ(
        diagnose(link, now, Diagnosis{}, true).cause, "can0 is error-passive with 136 transmit and 2 receive errors");
}

TEST(LinkDoctor, AControllerThatOnlyListensCannotSend)
{
    LinkSymptoms link = working();
    link.listenOnly = true;
    link.bitrate = 250'000;
    EXPECT_EQ(ailment(link), Ailment::ListenOnly);
    EXPECT_EQ(diagnose(link, now, Diagnosis{}, true).command,
        "sudo ip link set can0 down; sudo ip link set can0 up type can bitrate 250000 listen-only off");
}

TEST(LinkDoctor, LossForLackOfRoomNamesTheSetting)
{
    LinkSymptoms link = working();
    link.counters.lost = 12;
    EXPECT_EQ(ailment(link), Ailment::None) << "the buffer is large";
    link.receiveCapacity = 554;
    const Diagnosis found = diagnose(link, now, Diagnosis{}, true);
    EXPECT_EQ(found.ailment, Ailment::Losing);
    EXPECT_EQ(found.command, "sudo sysctl -w net.core.rmem_max=16777216");
}

TEST(LinkDoctor, ListingsAreMatchedByTheirInterface)
{
    LinkSymptoms link = working();
    link.state = LinkState::Lost;
    const Diagnosis down{Ailment::Down, say("can0 is switched off"), say("bring it up"), "x"};
    const Diagnosis other{Ailment::Down, say("can1 is switched off"), say("bring it up"), "y"};
    std::vector<LinkListing> rows{
        {{"socketcan", "can1", {}}, LinkKind::Can, ListingState::Down, Message(), false, other, false},
        {{"socketcan", "can0", {}}, LinkKind::Can, ListingState::Down, Message(), false, down, false}};
    EXPECT_EQ(diagnose(link, now, rows), down);
    rows.pop_back();
    EXPECT_EQ(diagnose(link, now, rows).ailment, Ailment::Gone);
    const Diagnosis none{Ailment::NotThere, say("there is no CAN interface"), say("plug in an adapter"), ""};
    EXPECT_EQ(diagnose(link, now,
                  {{{"socketcan", "", {}}, LinkKind::Can, ListingState::Absent, Message(), false, none, false}})
                  .ailment,
        Ailment::Gone);
    const Diagnosis kernel{
        Ailment::NoCan, say("this kernel has no CAN support"), say("load it"), "sudo modprobe can_raw"};
    EXPECT_EQ(diagnose(link, now,
                  {{{"socketcan", "", {}}, LinkKind::Can, ListingState::Absent, Message(), false, kernel, false}}),
        kernel);
}

TEST(LinkDoctor, AFailedOpeningHasItsPartsFromWhereItFailed)
{
    const Diagnosis port = diagnose(Error{Fault::LinkLost, say("no permission to use /dev/ttyUSB0"),
        say("become a member of its group"), "sudo usermod -aG dialout $USER", Ailment::NoPermission});
    EXPECT_EQ(port,
        (Diagnosis{Ailment::NoPermission, say("no permission to use /dev/ttyUSB0"), say("become a member of its group"),
            "sudo usermod -aG dialout $USER"}));
    EXPECT_EQ(
        port.text(), "no permission to use /dev/ttyUSB0; become a member of its group: sudo usermod -aG dialout $USER");
    EXPECT_EQ(diagnose(errorOf(port)), port);
    EXPECT_EQ(diagnose(Error{Fault::LinkLost, say("there is no permission in these words")}).ailment, Ailment::Failed)
        << "no word decides it";
}

TEST(LinkDoctor, ItsCommandsAreThoseOfIproute2)
{
    EXPECT_EQ(bringUpCommand("can0", false, 1), "sudo ip link set can0 up");
    EXPECT_EQ(bringUpCommand("can0", true, 125'000), "sudo ip link set can0 up type can bitrate 125000");
    EXPECT_EQ(findBitrateCommand("can0"),
        "for r in 1000000 500000 250000 125000 800000 100000 50000 20000; do sudo ip link set can0 down; sudo ip link "
        "set "
        "can0 up type can bitrate $r listen-only on; timeout 2 candump -n 3 can0 >/dev/null && { echo \"the bit rate "
        "is "
        "$r\"; break; }; done; sudo ip link set can0 down; sudo ip link set can0 up type can bitrate $r listen-only "
        "off");
    LinkSymptoms link = working();
    link.health.lastReceived.reset();
    link.health.lastProtocolError = now;
    EXPECT_EQ(diagnose(link, now, Diagnosis{}, false).command,
        "sudo ip link set can0 down; sudo ip link set can0 up type can bitrate 500000");
    link.bitrate = 0;
    EXPECT_EQ(diagnose(link, now, Diagnosis{}, false).cause,
        "only disturbed frames arrive on can0, the bus has another bit rate");
    link.listenOnly = true;
    EXPECT_EQ(diagnose(link, now, Diagnosis{}, true).command,
        "sudo ip link set can0 down; sudo ip link set can0 up type can bitrate 1000000 listen-only off");
}

TEST(LinkDoctor, BitRatesReadWell)
{
    EXPECT_EQ(bitrateText(1'000'000), "1 Mbit/s");
    EXPECT_EQ(bitrateText(125'000), "125 kbit/s");
    EXPECT_EQ(bitrateText(83'333), "83.333 kbit/s");
    EXPECT_EQ(bitrateText(33'300), "33.3 kbit/s");
}
