// SPDX-License-Identifier: GPL-3.0-or-later
// Stops that a line still owes: which of them stay, to whom they go, and for how long.
#include "async/virtualclock.h"
#include "model/owedstops.h"
#include "support/fakeguard.h"
#include "support/loosemotor.h"

#include <array>
#include <optional>

namespace mb {
namespace {

using namespace std::chrono_literals;

const std::string owedLine = "usb-1.2";
const std::string otherOwedLine = "usb-1.3";
const std::string owedStopFrame = "00000100#00";

StopScript owedScript(std::uint32_t id)
{
    return {{{extendedFrame(id, {0}), {}, {}, {}, 5ms, 1}}};
}

class Owed : public testing::Test {
protected:
    Owed()
    {
        for (test::LoggedLink *one : {&link, &otherLink})
            one->settings().identify
                = [one, this](const LinkAddress &) { return one == &link ? owedLine : otherOwedLine; };
        EXPECT_TRUE(link.open());
        EXPECT_TRUE(otherLink.open());
        clock.advance(1h);
    }
    /// A motor that was driven, told to stop, and not seen to stand.
    test::LooseMotor &make(const Family &family = test::looseFamily, bool driven = true)
    {
        motor.emplace(link, clock, family);
        if (driven)
            motor->stopping().driven();
        motor->stop();
        link.sent.clear();
        return *motor;
    }
    [[nodiscard]] OwedStop stopOf(std::string device, std::uint32_t id, std::string where = owedLine) const
    {
        return {std::move(where), std::move(device), owedScript(id), clock.now()};
    }
    std::vector<std::string> paid(test::LoggedLink &to)
    {
        to.sent.clear();
        owed.pay(to);
        return to.sent;
    }
    using Frames = std::vector<std::string>;

    VirtualClock clock;
    test::FakeGuard guard;
    std::array<const Family *, 1> families{&test::looseFamily};
    LinkBook links{clock, families};
    SessionMemory memory{clock};
    DeviceBook devices{clock, links, memory, &guard};
    test::LoggedLink link{clock, {Outlet::Form::CanSocket, 7}};
    test::LoggedLink otherLink{clock, {Outlet::Form::CanSocket, 7}};
    std::optional<test::LooseMotor> motor;
    OwedStops owed{clock, devices, &guard};
};

TEST_F(Owed, AMotorThatNobodySawStandIsOwedItsStop)
{
    owed.add(make());
    ASSERT_EQ(owed.unseen().size(), 1U);
    EXPECT_EQ(owed.unseen().front().line, owedLine);
    EXPECT_EQ(owed.unseen().front().device, motor->selector());
    EXPECT_EQ(owed.unseen().front().since, clock.now());
    EXPECT_EQ(owed.unseen().front().script.steps.size(), 1U);
}

TEST_F(Owed, WhatStandsOrNobodyMovedOrStopsByItselfIsOwedNothing)
{
    static constexpr Family watched = [] {
        Family family = test::looseFamily;
        family.capabilities.watchdog = true;
        return family;
    }();
    owed.add(make(watched));
    EXPECT_TRUE(owed.unseen().empty()) << "a watchdog";
    owed.add(make(test::looseFamily, false));
    EXPECT_TRUE(owed.unseen().empty()) << "no motion";
    make().script = {};
    owed.add(*motor);
    EXPECT_TRUE(owed.unseen().empty()) << "no script";
    make().seenStopped = true;
    clock.advance(1s);
    owed.add(*motor);
    EXPECT_TRUE(owed.unseen().empty()) << "it stands";
}

TEST_F(Owed, GoesOutOnItsOwnLineOnlyAndAgainWithEachOpening)
{
    owed.add(make());
    EXPECT_EQ(paid(otherLink), Frames{});
    EXPECT_EQ(paid(link), Frames{owedStopFrame});
    EXPECT_EQ(paid(link), Frames{owedStopFrame}) << "until the device takes it over";
}

TEST_F(Owed, ForTenMinutesAndNotLonger)
{
    owed.add(make());
    clock.advance(DeviceStop::debtLimit - 1ns);
    EXPECT_EQ(paid(link), Frames{owedStopFrame});
    clock.advance(1ns);
    EXPECT_EQ(paid(link), Frames{});
    EXPECT_EQ(owed.unseen().size(), 1U) << "nobody has seen it stand";
    motor.emplace(link, clock);
    link.sent.clear();
    owed.passTo(*motor);
    EXPECT_TRUE(motor->stopping().mayTurn()) << "shown with its device";
    clock.advance(5s);
    EXPECT_TRUE(link.sent.empty());
    motor->seenStopped = true;
    clock.advance(1s);
    EXPECT_EQ(motor->stopping().state(), StopState::Seen);
}

TEST_F(Owed, TheTimeCountsFromWhenTheMotorWasToldNotFromWhenItsLinkWasClosed)
{
    make();
    clock.advance(9min);
    owed.add(*motor);
    clock.advance(1min - 1ns);
    EXPECT_EQ(paid(link), Frames{owedStopFrame});
    clock.advance(1ns);
    EXPECT_EQ(paid(link), Frames{});
}

TEST_F(Owed, AMotorThatMayStillTurnStaysShownWhenItsLinkIsClosedAfterTenMinutes)
{
    make();
    link.lose({Fault::LinkLost, say("cut")});
    clock.advance(DeviceStop::debtLimit + 1min);
    ASSERT_TRUE(motor->stopping().mayTurn());
    owed.add(*motor);
    EXPECT_EQ(owed.unseen().size(), 1U);
    ASSERT_TRUE(link.open());
    EXPECT_EQ(paid(link), Frames{}) << "it is not sent any more";
    EXPECT_EQ(owed.unseen().size(), 1U);
}

TEST_F(Owed, EndsWhenAGuardianHasStoppedItAndNotWhenItIsGivenUp)
{
    owed.add(make());
    int told = 0;
    const auto listening = devices.changed().add([&told] { ++told; });
    clock.advance(1h);
    EXPECT_EQ(owed.unseen().size(), 1U);
    EXPECT_EQ(told, 0);
    guard.book.clear();
    clock.advance(1s);
    EXPECT_TRUE(owed.unseen().empty());
    EXPECT_EQ(told, 1);
}

TEST_F(Owed, WhatEarlierProgramsOweIsSentOnItsLine)
{
    guard.book = {stopOf("socketcan:can0/loose:3", 0x300), stopOf("socketcan:can0/loose:4", 0x400, otherOwedLine),
        stopOf("socketcan:can1/loose:5", 0x500), stopOf("socketcan:can1/loose:3", 0x302, "usb-1.4")};
    EXPECT_EQ(paid(link), (Frames{"00000300#00", "00000500#00"})) << "whatever the line was called";
    EXPECT_EQ(owed.unseen().size(), 4U);
}

TEST_F(Owed, OnALineThatAGuardianHadWhenItWasOpenedIsTakenOverAsSoonAsThatLetsGo)
{
    guard.book = {stopOf("socketcan:can0/loose:3", 0x300)};
    guard.isWithOthers = true;
    EXPECT_EQ(paid(link), Frames{});
    clock.advance(5s);
    EXPECT_EQ(link.sent, Frames{});
    guard.isWithOthers = false;
    clock.advance(1s);
    EXPECT_EQ(link.sent, Frames{"00000300#00"});
    EXPECT_EQ(owed.unseen().size(), 1U);
    const int asked = guard.asked;
    clock.advance(5s);
    EXPECT_EQ(guard.asked, asked) << "once";
    EXPECT_EQ(link.sent, Frames{"00000300#00"}) << "once";
}

TEST_F(Owed, WhatIsWrittenDownWhileItsLineIsOpenHereIsSentWithinASecond)
{
    guard.book = {stopOf("socketcan:can0/loose:3", 0x300)};
    EXPECT_EQ(paid(link), Frames{"00000300#00"});
    EXPECT_EQ(paid(otherLink), Frames{});
    link.sent.clear();
    clock.advance(3s);
    guard.book.push_back(stopOf("socketcan:can0/loose:4", 0x400, otherOwedLine));
    guard.book.push_back(stopOf("socketcan:can0/loose:5", 0x500));
    clock.advance(1s);
    EXPECT_EQ(otherLink.sent, Frames{"00000400#00"});
    EXPECT_EQ(link.sent, Frames{"00000500#00"});
    EXPECT_EQ(owed.unseen().size(), 3U);
    clock.advance(5s);
    EXPECT_EQ(link.sent.size() + otherLink.sent.size(), 2U) << "once";
    guard.book.front().since = clock.now(); // it was driven again, and its stop failed again
    clock.advance(1s);
    EXPECT_EQ(link.sent, (Frames{"00000500#00", "00000300#00"}));
}

TEST_F(Owed, TheFirstThatIsWrittenDownWhileItsLineIsOpenHereIsSentWithinASecond)
{
    EXPECT_EQ(paid(link), Frames{});
    clock.advance(1h);
    guard.book = {stopOf("socketcan:can0/loose:3", 0x300)};
    clock.advance(1s);
    EXPECT_EQ(link.sent, Frames{"00000300#00"}) << "the guardian that wrote it leaves it to whoever has the line";
    EXPECT_EQ(owed.unseen().size(), 1U);
    owed.leave(link);
    guard.book = {stopOf("socketcan:can0/loose:4", 0x400)};
    clock.advance(5s);
    EXPECT_EQ(link.sent.size(), 1U) << "a line that was left is the guardians'";
}

TEST_F(Owed, OnALineThatIsLeftAgainIsNotAskedFor)
{
    guard.isWithOthers = true;
    (void)paid(link);
    owed.leave(link);
    const int asked = guard.asked;
    clock.advance(5s);
    EXPECT_EQ(guard.asked, asked);
}

TEST_F(Owed, IsPassedToItsDeviceWhichIsToldAtOnce)
{
    owed.add(make());
    motor.emplace(link, clock);
    link.sent.clear();
    test::LooseMotor other(otherLink, clock);
    owed.passTo(other);
    EXPECT_TRUE(otherLink.sent.empty()) << "that is another motor";
    EXPECT_EQ(other.stopping().state(), StopState::None);
    owed.passTo(*motor);
    EXPECT_EQ(link.sent, Frames{owedStopFrame});
    EXPECT_TRUE(motor->stopping().isForMotion());
    link.sent.clear();
    owed.passTo(*motor);
    EXPECT_TRUE(link.sent.empty()) << "once";
    owed.settle(*motor);
    EXPECT_TRUE(owed.unseen().empty());
}

TEST_F(Owed, IsNotPassedToAnotherUnitOrToOneThatMayNotBeTold)
{
    guard.book = {stopOf("socketcan:can7/loose:3", 0x300)};
    (void)paid(link);
    motor.emplace(link, clock);
    link.sent.clear();
    owed.passTo(*motor);
    EXPECT_TRUE(link.sent.empty()) << "number 0 is not number 3";
    EXPECT_EQ(owed.unseen().size(), 1U);

    guard.book.push_back(stopOf(motor->selector(), 0x100));
    (void)paid(link);
    motor->gate().setBusy(say("its firmware is written"));
    link.sent.clear();
    owed.passTo(*motor);
    EXPECT_TRUE(link.sent.empty());
    EXPECT_EQ(owed.unseen().size(), 2U) << "it stays owed";
}

TEST_F(Owed, TheGuardiansHearWhatIsSettledAndWhatIsLeftToThem)
{
    owed.settle(make());
    EXPECT_EQ(guard.settled, Frames{owedLine + ' ' + motor->selector()});
    owed.leave(otherLink);
    EXPECT_EQ(guard.left, Frames{otherOwedLine});
    guard.settled.clear();
    owed.add(*motor);
    guard.settled.clear();
    owed.dismiss();
    EXPECT_EQ(guard.settled, Frames{owedLine + ' ' + motor->selector()});
    EXPECT_TRUE(owed.unseen().empty());
}

TEST_F(Owed, WithoutGuardiansEverythingElseIsTheSame)
{
    OwedStops alone(clock, devices, nullptr);
    alone.add(make());
    alone.pay(link);
    EXPECT_EQ(link.sent, Frames{owedStopFrame});
    alone.leave(link);
    EXPECT_EQ(alone.unseen().size(), 1U);
    alone.settle(*motor);
    EXPECT_TRUE(alone.unseen().empty());
    alone.add(*motor);
    alone.add(*motor);
    EXPECT_EQ(alone.unseen().size(), 1U);
    alone.dismiss();
    EXPECT_TRUE(alone.unseen().empty());
}

} // namespace
} // namespace mb
