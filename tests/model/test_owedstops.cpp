// SPDX-License-Identifier: GPL-3.0-or-later
// Stops that a line still owes: which of them stay, to whom they go, and for how long.
#include "async/virtualclock.h"
#include "model/owedstops.h"
#include "support/fakeguard.h"
#include "support/loosemotor.h"

#include <optional>

namespace mb {
namespace {

using namespace std::chrono_literals;

const std::string line = "usb-1.2";
const std::string otherLine = "usb-1.3";
const std::string stopFrame = "00000100#00";

StopScript scriptOf(std::uint32_t id)
{
    return {{{extendedFrame(id, {0}), {}, {}, {}, 5ms, 1}}};
}

class Owed : public testing::Test {
protected:
    Owed()
    {
        EXPECT_TRUE(link.open());
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
    [[nodiscard]] OwedStop stopOf(std::string device, std::uint32_t id, std::string where = line) const
    {
        return {std::move(where), std::move(device), scriptOf(id), clock.now()};
    }
    std::vector<std::string> paid(const std::string &where)
    {
        link.sent.clear();
        owed.pay(link, where);
        return link.sent;
    }
    using Frames = std::vector<std::string>;

    VirtualClock clock;
    test::FakeGuard guard;
    test::LoggedLink link{clock, {Outlet::Form::CanSocket, 7}};
    std::optional<test::LooseMotor> motor;
    OwedStops owed{clock, &guard};
};

TEST_F(Owed, AMotorThatNobodySawStandIsOwedItsStop)
{
    owed.add(make(), line);
    ASSERT_EQ(owed.all().size(), 1U);
    EXPECT_EQ(owed.all().front().line, line);
    EXPECT_EQ(owed.all().front().device, motor->selector());
    EXPECT_EQ(owed.all().front().since, clock.now());
    EXPECT_EQ(owed.all().front().script.steps.size(), 1U);
}

TEST_F(Owed, WhatStandsOrNobodyMovedOrStopsByItselfIsOwedNothing)
{
    static constexpr Family watched = [] {
        Family family = test::looseFamily;
        family.capabilities.watchdog = true;
        return family;
    }();
    owed.add(make(watched), line);
    EXPECT_TRUE(owed.all().empty()) << "a watchdog";
    owed.add(make(test::looseFamily, false), line);
    EXPECT_TRUE(owed.all().empty()) << "no motion";
    make().script = {};
    owed.add(*motor, line);
    EXPECT_TRUE(owed.all().empty()) << "no script";
    make().seenStopped = true;
    clock.advance(1s);
    owed.add(*motor, line);
    EXPECT_TRUE(owed.all().empty()) << "it stands";
}

TEST_F(Owed, GoesOutOnItsOwnLineOnlyAndAgainWithEachOpening)
{
    owed.add(make(), line);
    EXPECT_EQ(paid(otherLine), Frames{});
    EXPECT_EQ(paid(line), Frames{stopFrame});
    EXPECT_EQ(paid(line), Frames{stopFrame}) << "until the device takes it over";
}

TEST_F(Owed, ForTenMinutesAndNotLonger)
{
    owed.add(make(), line);
    clock.advance(DeviceStop::debtLimit - 1ns);
    EXPECT_EQ(paid(line), Frames{stopFrame});
    clock.advance(1ns);
    EXPECT_EQ(paid(line), Frames{});
    EXPECT_TRUE(owed.all().empty());
}

TEST_F(Owed, WhatEarlierProgramsOweIsTakenOverOnce)
{
    guard.owing = {stopOf("socketcan:can0/loose:3", 0x300), stopOf("socketcan:can0/loose:4", 0x400, otherLine)};
    EXPECT_EQ(paid(line), Frames{"00000300#00"});
    EXPECT_EQ(owed.all().size(), 2U);
    guard.owing = {stopOf("socketcan:can1/loose:3", 0x301)}; // the same unit behind another name
    EXPECT_EQ(paid(line), Frames{"00000300#00"});
    EXPECT_EQ(owed.all().size(), 2U);
    guard.owing = {stopOf("socketcan:can1/loose:5", 0x500), stopOf("socketcan:can1/loose:3", 0x302, "usb-1.4")};
    EXPECT_EQ(paid(line), (Frames{"00000300#00", "00000500#00"})) << "another unit, and one of this number elsewhere";
    EXPECT_EQ(owed.all().size(), 4U);
}

TEST_F(Owed, IsPassedToItsDeviceWhichIsToldAtOnce)
{
    owed.add(make(), line);
    motor.emplace(link, clock);
    link.sent.clear();
    owed.passTo(*motor, otherLine);
    EXPECT_TRUE(link.sent.empty()) << "that is another motor";
    EXPECT_EQ(motor->stopping().state(), StopState::None);
    owed.passTo(*motor, line);
    EXPECT_EQ(link.sent, Frames{stopFrame});
    EXPECT_TRUE(motor->stopping().isForMotion());
    EXPECT_TRUE(owed.all().empty());
    link.sent.clear();
    owed.passTo(*motor, line);
    EXPECT_TRUE(link.sent.empty()) << "once";
}

TEST_F(Owed, IsNotPassedToAnotherUnitOrToOneThatMayNotBeTold)
{
    guard.owing = {stopOf("socketcan:can7/loose:3", 0x300)};
    (void)paid(line);
    motor.emplace(link, clock);
    link.sent.clear();
    owed.passTo(*motor, line);
    EXPECT_TRUE(link.sent.empty()) << "number 0 is not number 3";
    EXPECT_EQ(owed.all().size(), 1U);

    guard.owing = {stopOf(motor->selector(), 0x100)};
    (void)paid(line);
    motor->gate().setBusy(say("its firmware is written"));
    link.sent.clear();
    owed.passTo(*motor, line);
    EXPECT_TRUE(link.sent.empty());
    EXPECT_EQ(owed.all().size(), 2U) << "it stays owed";
}

TEST_F(Owed, TheGuardiansHearWhatIsSettledAndWhatIsLeftToThem)
{
    owed.settle(make(), line);
    EXPECT_EQ(guard.settled, Frames{line + ' ' + motor->selector()});
    owed.leave(otherLine);
    EXPECT_EQ(guard.left, Frames{otherLine});
    guard.settled.clear();
    owed.add(*motor, line);
    owed.dismiss();
    EXPECT_EQ(guard.settled, Frames{line + ' ' + motor->selector()});
    EXPECT_TRUE(owed.all().empty());
}

TEST_F(Owed, WithoutGuardiansEverythingElseIsTheSame)
{
    OwedStops alone(clock, nullptr);
    alone.add(make(), line);
    alone.pay(link, line);
    EXPECT_EQ(link.sent, Frames{stopFrame});
    alone.settle(*motor, line);
    alone.leave(line);
    alone.dismiss();
    EXPECT_TRUE(alone.all().empty());
}

} // namespace
} // namespace mb
