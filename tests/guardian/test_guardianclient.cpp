// SPDX-License-Identifier: GPL-3.0-or-later
// What a program and the guardians before it know of the same debts: the books on the disk, read by a session on virtual time.
#include "app/guardian/client/guardianclient.h"
#include "app/guardian/client/wirescript.h"
#include "async/virtualclock.h"
#include "model/owedstops.h"
#include "support/loosemotor.h"

#include <array>
#include <chrono>
#include <filesystem>
#include <memory>

namespace mb {
namespace {

using namespace std::chrono_literals;
using guardian::Debt;
using guardian::DebtBook;
using Frames = std::vector<std::string>;

const std::string debtorLine = "usb-1.2";

class GuardianBooks : public testing::Test {
protected:
    GuardianBooks()
    {
        std::string pattern = testing::TempDir() + "/booksXXXXXX";
        EXPECT_NE(::mkdtemp(pattern.data()), nullptr);
        folder = pattern;
        clock.advance(1h);
        link.settings().identify = [](const LinkAddress &) { return debtorLine; };
        EXPECT_TRUE(link.open());
        book = std::make_unique<DebtBook>(folder + "/run", debtorLine);
        motor.stopping().driven();
        motor.stop();
        link.sent.clear();
    }
    ~GuardianBooks() override { std::filesystem::remove_all(folder); }
    /// A guardian writes down that it owes a stop, so long ago.
    void owe(std::chrono::seconds ago) const
    {
        EXPECT_TRUE(book->add(
            {motor.selector(), wireScript(motor.script, Outlet::Form::CanSocket), guardian::runTime() - ago}));
    }

    std::string folder;
    VirtualClock clock;
    std::array<const Family *, 1> families{&test::looseFamily};
    LinkBook links{clock, families};
    SessionMemory memory{clock};
    DeviceBook devices{clock, links, memory, nullptr};
    test::LoggedLink link{clock, {Outlet::Form::CanSocket, 7}};
    test::LooseMotor motor{link, clock};
    std::unique_ptr<DebtBook> book;
};

TEST_F(GuardianBooks, AnAgedDebtIsShownAndNotSentUntilSomebodyHasLooked)
{
    owe(11min);
    GuardianClient client("nowhere", folder + "/run");
    OwedStops owed(clock, devices, &client);
    owed.pay(link);
    EXPECT_EQ(link.sent, Frames{});
    EXPECT_EQ(owed.unseen().size(), 1U);
    clock.advance(3s);
    EXPECT_EQ(owed.unseen().size(), 1U);
    EXPECT_TRUE(book->exists()) << "for every other program";
    owed.dismiss();
    EXPECT_TRUE(owed.unseen().empty());
    EXPECT_FALSE(book->exists());
}

TEST_F(GuardianBooks, ADebtOfAnEarlierRunOfTheMachineIsAnAgedOne)
{
    owe(-1h); // since then time began anew
    GuardianClient client("nowhere", folder + "/run");
    OwedStops owed(clock, devices, &client);
    owed.pay(link);
    EXPECT_EQ(link.sent, Frames{});
    EXPECT_EQ(owed.unseen().size(), 1U);
}

TEST_F(GuardianBooks, ADebtThatIsWrittenDownHereIsAsOldForEverybody)
{
    GuardianClient client("nowhere", folder + "/run");
    (void)client.own(link);
    const Instant since = clock.now() - 9min;
    ASSERT_TRUE(client.owe({debtorLine, motor.selector(), motor.script, since}, clock.now()));
    GuardianClient other("nowhere", folder + "/run");
    (void)other.own(link);
    const auto owed = other.owed(clock.now());
    ASSERT_EQ(owed.size(), 1U);
    EXPECT_LT(std::chrono::abs(owed.front().since - since), 50ms);
}

TEST_F(GuardianBooks, ALinkThatIsOpenedAgainLeavesWhatItOwesInSight)
{
    GuardianClient client("nowhere", folder + "/run");
    OwedStops owed(clock, devices, &client);
    owed.pay(link);
    owed.add(motor);
    owe(11min);
    owed.leave(link);
    clock.advance(2s);
    ASSERT_EQ(owed.unseen().size(), 1U);
    owed.pay(link);
    clock.advance(2s);
    EXPECT_EQ(owed.unseen().size(), 1U) << "given up is not stopped";
}

TEST_F(GuardianBooks, ABookThatCannotBeHadRefusesMotionAndNamesItsFolder)
{
    GuardianClient client("/bin/true", folder + "/missing/run");
    EXPECT_TRUE(client.own(link)) << "nobody else has it";
    const auto watch = client.watch(link, motor.script, motor.selector());
    ASSERT_FALSE(watch);
    EXPECT_EQ(watch.error().fault, Fault::Unsafe);
    EXPECT_NE(watch.error().text().find(folder + "/missing/run cannot be used"), std::string::npos);
}

TEST_F(GuardianBooks, ABookThatIsTakenAwaySettlesNothing)
{
    GuardianClient client("nowhere", folder + "/run");
    OwedStops owed(clock, devices, &client);
    owe(1s);
    owed.pay(link);
    ASSERT_EQ(owed.unseen().size(), 1U);
    std::filesystem::remove_all(folder + "/run");
    clock.advance(3s);
    EXPECT_EQ(owed.unseen().size(), 1U);
    owed.dismiss();
    clock.advance(3s);
    EXPECT_TRUE(owed.unseen().empty());
}

TEST_F(GuardianBooks, ASecondProgramThatOpensTheLineEndsNothingForTheFirst)
{
    GuardianClient first("nowhere", folder + "/run");
    OwedStops shown(clock, devices, &first);
    shown.pay(link);
    shown.add(motor);
    owe(11min);
    shown.leave(link);
    clock.advance(2s);
    GuardianClient second("nowhere", folder + "/run");
    OwedStops elsewhere(clock, devices, &second);
    elsewhere.pay(link);
    clock.advance(2s);
    EXPECT_EQ(shown.unseen().size(), 1U);
    elsewhere.dismiss();
    clock.advance(2s);
    EXPECT_TRUE(shown.unseen().empty()) << "somebody has looked";
}

TEST_F(GuardianBooks, WhatIsDismissedWhileTheLineIsGoneIsNotStoppedWhenItIsBack)
{
    GuardianClient client("nowhere", folder + "/run");
    OwedStops owed(clock, devices, &client);
    owed.pay(link);
    owed.add(motor);
    owe(0s);
    owed.leave(link);
    owed.dismiss();
    EXPECT_FALSE(book->exists());
    link.sent.clear();
    owed.pay(link);
    EXPECT_EQ(link.sent, Frames{});
    EXPECT_TRUE(owed.unseen().empty());
}

} // namespace
} // namespace mb
