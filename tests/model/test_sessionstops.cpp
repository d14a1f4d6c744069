// SPDX-License-Identifier: GPL-3.0-or-later
// Which motors of a session are stopped when its links come and go, and what each line still owes. The lines are pseudo terminals.
#include "sessionlines.h"

#include <algorithm>

namespace mb {
namespace {

using namespace std::chrono_literals;
using test::Bytes;
using test::driveByte;
using test::releaseByte;
using test::scriptByte;
using test::SessionLines;
using test::stopByte;
using test::WiredMotor;

TEST_F(SessionLines, AClosedLinkStopsItsOwnMotorsOnlyAndOwesWhatWasNotSeen)
{
    run(motorOn(*links[0]));
    WiredMotor &other = motorOn(*links[1]);
    run(other);
    std::array<Bytes, 2> sent;
    const std::array<Subscription, 2> taps{tap(0, sent[0]), tap(1, sent[1])};
    close(*links[0]);
    EXPECT_EQ(sent[0], Bytes{stopByte});
    EXPECT_EQ(stops.owed().size(), 1U);
    EXPECT_EQ(guard.left.size(), 1U);
    EXPECT_TRUE(devices.stream(other).isRunning());
    clock.advance(100ms);
    EXPECT_EQ(sent[1], Bytes(5, driveByte));
}

TEST_F(SessionLines, AClosedLinkLeavesAloneWhatThisProgramHasNotMovedAndOwesItNothing)
{
    WiredMotor &motor = motorOn(*links[0]);
    (void)devices.stream(motor); // as every picture of the window makes one
    motor.turn();
    bool sent = false;
    const auto tap = links[0]->traffic().add([&sent](const Traffic &) { sent = true; });
    close(*links[0]);
    EXPECT_FALSE(sent) << "another master drives it";
    EXPECT_TRUE(stops.owed().empty());
    EXPECT_TRUE(guard.book.empty());
}

TEST_F(SessionLines, AStopThatWasGivenUpIsNotToldAnewByAClosedLink)
{
    WiredMotor &motor = motorOn(*links[0]);
    run(motor);
    const Instant told = clock.now();
    lose(0);
    clock.advance(11min);
    ASSERT_EQ(motor.stopping().state(), StopState::Unconfirmed);
    close(*links[0]);
    ASSERT_EQ(guard.book.size(), 1U);
    EXPECT_EQ(guard.book.front().since, told) << "it is shown, and not sent for ten minutes more";
}

TEST_F(SessionLines, WhatIsOwedIsTheFirstOnTheLineWhenItIsOpenedAgainAndItsDeviceTakesItOver)
{
    run(motorOn(*links[0]));
    close(*links[0]);
    EXPECT_EQ(heard(0, 2), (Bytes{driveByte, stopByte}));
    links[0] = openLine(0);
    EXPECT_EQ(heard(0, 1), Bytes{scriptByte});
    clock.advance(1ms);
    WiredMotor &found = motorOn(*links[0]);
    EXPECT_EQ(heard(0, 1), Bytes{stopByte});
    EXPECT_TRUE(stops.owed().empty());
    EXPECT_TRUE(found.stopping().isForMotion());
    found.seen = true;
    clock.advance(1s);
    EXPECT_EQ(found.stopping().state(), StopState::Seen);
    ASSERT_FALSE(guard.settled.empty()) << "the guardians hear of it";
    EXPECT_NE(guard.settled.back().find("wired:3"), std::string::npos);
}

TEST_F(SessionLines, WhatIsTakenOverLateStillReachesADeviceThatWasFoundBefore)
{
    close(*links[0]);
    guard.isWithOthers = true;
    links[0] = openLine(0);
    WiredMotor &found = motorOn(*links[0]);
    guard.isWithOthers = false;
    guard.book = {owedTo(found)};
    clock.advance(1100ms);
    EXPECT_EQ(heard(0, 2), (Bytes{scriptByte, stopByte}));
    EXPECT_TRUE(found.stopping().isForMotion());
    EXPECT_TRUE(stops.owed().empty());
}

TEST_F(SessionLines, WhatIsOwedToADeviceThatMayNotBeToldReachesItOnceItMay)
{
    guard.book = {owedTo(motorOn(*links[0]))};
    close(*links[0]);
    links[0] = openLine(0);
    WiredMotor &found = motorOn(*links[0], 3, DeviceState::Bootloader);
    clock.advance(2s);
    EXPECT_EQ(heard(0, 1), Bytes{scriptByte});
    EXPECT_EQ(stops.owed().size(), 1U);
    (void)motorOn(*links[0]); // it has its power now
    clock.advance(1s);
    EXPECT_TRUE(found.stopping().isForMotion());
    EXPECT_TRUE(stops.owed().empty()) << "its device shows it";
    EXPECT_EQ(heard(0, 1), Bytes{stopByte});
    found.seen = true;
    clock.advance(1s);
    EXPECT_TRUE(guard.book.empty());
}

TEST_F(SessionLines, WhatIsTakenOverLateIsNotSentIntoAMotionOfThisProgramWhoseOwnStopSettlesIt)
{
    close(*links[0]);
    guard.isWithOthers = true;
    links[0] = openLine(0);
    WiredMotor &found = motorOn(*links[0]);
    run(found);
    guard.isWithOthers = false;
    guard.book = {owedTo(found)};
    Bytes sent;
    const Subscription tapped = tap(0, sent);
    clock.advance(2s);
    EXPECT_EQ(std::count(sent.begin(), sent.end(), driveByte), std::ssize(sent));
    EXPECT_TRUE(devices.stream(found).isRunning());
    EXPECT_TRUE(stops.owed().empty()) << "it is seen to turn, and driven";
    EXPECT_EQ(guard.book.size(), 1U) << "as long as nobody has seen it stand";
    devices.stream(found).stop();
    found.seen = true;
    clock.advance(1s);
    EXPECT_TRUE(guard.book.empty());
}

TEST_F(SessionLines, AnAgedDebtIsShownWithItsDeviceUntilThatIsSeenToStand)
{
    clock.advance(1h);
    WiredMotor &found = motorOn(*links[0]);
    guard.book = {owedTo(found, 11min)};
    close(*links[0]);
    links[0] = openLine(0);
    EXPECT_EQ(stops.owed().size(), 1U);
    WiredMotor &again = motorOn(*links[0]);
    clock.advance(5s);
    EXPECT_TRUE(again.stopping().mayTurn());
    EXPECT_TRUE(stops.owed().empty()) << "its device shows it";
    EXPECT_EQ(guard.book.size(), 1U);
    again.seen = true;
    clock.advance(1s);
    EXPECT_FALSE(again.stopping().mayTurn());
    EXPECT_TRUE(guard.book.empty()) << "it does not come again";
}

TEST_F(SessionLines, AnAgedDebtOfADeviceThatWasFoundIsDismissedForGood)
{
    clock.advance(1h);
    guard.book = {owedTo(motorOn(*links[0]), 11min)};
    close(*links[0]);
    links[0] = openLine(0);
    WiredMotor &found = motorOn(*links[0]);
    ASSERT_TRUE(found.stopping().mayTurn());
    stops.dismiss();
    EXPECT_FALSE(found.stopping().mayTurn());
    clock.advance(5s);
    close(*links[0]);
    links[0] = openLine(0);
    EXPECT_FALSE(motorOn(*links[0]).stopping().mayTurn());
    EXPECT_TRUE(stops.owed().empty());
}

TEST_F(SessionLines, TheUserDismissesWhatIsOwedAndWhatMayTurn)
{
    run(motorOn(*links[0]));
    close(*links[0]);
    WiredMotor &other = motorOn(*links[1]);
    run(other);
    lose(1);
    clock.advance(20ms);
    ASSERT_TRUE(other.stopping().mayTurn());
    int told = 0;
    const auto listening = devices.changed().add([&told] { ++told; });
    guard.settled.clear();
    stops.dismiss();
    EXPECT_TRUE(stops.owed().empty());
    EXPECT_EQ(guard.settled.size(), 2U) << "the books of both lines";
    EXPECT_FALSE(other.stopping().mayTurn());
    EXPECT_GE(told, 1);
}

TEST_F(SessionLines, AMoveIsNotReleasedWhereAnotherMotorThatKeepsOneHasNoGuardian)
{
    WiredMotor &lead = motorOn(*links[0]);
    WiredMotor &other = motorOn(*links[0], 4);
    Bytes sent;
    const Subscription tapped = tap(0, sent);
    ASSERT_TRUE(lead.guard().call());
    EXPECT_TRUE(stops.releaseMoves(lead)) << "the other keeps none";
    other.gate().moveAcknowledged({});
    EXPECT_EQ(stops.releaseMoves(lead).error().detail, other.guard().reason());
    EXPECT_EQ(sent, Bytes{releaseByte}) << "and nothing more";
}

TEST_F(SessionLines, ALostLineThatOwesAStopIsTriedEveryFiftyMillisecondsUntilItIsBack)
{
    WiredMotor &motor = motorOn(*links[0]);
    run(motor);
    EXPECT_EQ(heard(0, 1), Bytes{driveByte});
    lose(0);
    EXPECT_EQ(motor.stopping().state(), StopState::Owed);
    clock.advance(10 * 50ms - 1ns);
    EXPECT_EQ(links[0]->state(), LinkState::Lost);
    plug(0);
    EXPECT_EQ(links[0]->state(), LinkState::Lost);
    clock.advance(1ns);
    EXPECT_EQ(links[0]->state(), LinkState::Open);
    clock.advance(1ms);
    EXPECT_EQ(heard(0, 2), (Bytes{scriptByte, stopByte})) << "before anything else";
    EXPECT_EQ(motor.stopping().state(), StopState::Stopping);
}

TEST_F(SessionLines, ALostLineThatOwesNothingIsLeftAlone)
{
    WiredMotor &still = motorOn(*links[0]);
    WiredMotor &stood = motorOn(*links[1]);
    run(stood);
    stood.seen = true;
    devices.stream(stood).stop();
    clock.advance(1s);
    ASSERT_EQ(stood.stopping().state(), StopState::Seen);
    const std::size_t before = clock.armed();
    lose(0);
    lose(1);
    plug(0);
    plug(1);
    clock.advance(10s);
    EXPECT_EQ(links[0]->state(), LinkState::Lost);
    EXPECT_EQ(links[1]->state(), LinkState::Lost);
    EXPECT_LE(clock.armed(), before);
    EXPECT_FALSE(still.stopping().mayTurn());
}

TEST_F(SessionLines, OfTwoLostLinesOnlyTheOneThatOwesIsOpenedAgain)
{
    run(motorOn(*links[0]));
    (void)motorOn(*links[1]);
    lose(0);
    lose(1);
    plug(0);
    plug(1);
    clock.advance(50ms);
    EXPECT_EQ(links[0]->state(), LinkState::Open);
    EXPECT_EQ(links[1]->state(), LinkState::Lost);
}

TEST_F(SessionLines, ALostLineIsLeftToTheGuardiansWhoLookForItUnderEveryName)
{
    run(motorOn(*links[0]));
    lose(0);
    ASSERT_EQ(guard.left.size(), 1U);
    EXPECT_EQ(guard.left.front(), links[0]->line());
}

TEST_F(SessionLines, AnotherAdapterUnderTheNameOfALostLineIsToldNothingAndTheDebtWaitsForItsOwnLine)
{
    run(motorOn(*links[0]));
    (void)heard(0, 1);
    lose(1);
    lose(0);
    plug(1, 0);
    clock.advance(10s);
    EXPECT_EQ(links[0]->state(), LinkState::Lost) << "it would be another one";
    EXPECT_TRUE(isReplaced(*links[0]));
    const auto refused = book.open(links[0]->address());
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().text().find("another adapter is called line0 now"), std::string::npos);
    close(*links[0]);
    EXPECT_EQ(stops.owed().size(), 1U);
    links[0] = openLine(0);
    motorOn(*links[0]).stop();
    clock.advance(1ms);
    EXPECT_EQ(heard(1, 1), Bytes{stopByte}) << "what it is told itself, and nothing before";
    EXPECT_EQ(stops.owed().size(), 1U);

    close(*links[1]);
    unplug(0);
    plug(0, 1);
    links[1] = openLine(1);
    clock.advance(1ms);
    EXPECT_EQ(heard(0, 1), Bytes{scriptByte}) << "under its new name";
    (void)motorOn(*links[1]);
    EXPECT_TRUE(stops.owed().empty());
}

TEST_F(SessionLines, ALineThatIsBackUnderAnotherNameIsPaidAtOnceWhileTheLostOneIsListedAndStaysOursWhenThatIsClosed)
{
    WiredMotor &motor = motorOn(*links[0]);
    run(motor);
    (void)heard(0, 1);
    lose(1);
    lose(0);
    guard.book = {owedTo(motor)}; // its guardian could not reach it either
    close(*links[1]);
    plug(0, 1);
    links[1] = openLine(1);
    EXPECT_EQ(heard(0, 1), Bytes{scriptByte});
    ASSERT_EQ(links[0]->state(), LinkState::Lost);
    guard.left.clear();
    close(*links[0]);
    EXPECT_TRUE(guard.left.empty()) << "it is open here";
    guard.book = {owedTo(motorOn(*links[1], 4))};
    clock.advance(2s);
    const Bytes later = heard(0, 1);
    ASSERT_FALSE(later.empty());
    EXPECT_EQ(later.front(), scriptByte) << "what is written down later is paid here, too";
}

} // namespace
} // namespace mb
