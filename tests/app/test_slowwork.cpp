// SPDX-License-Identifier: GPL-3.0-or-later
// What may block is done elsewhere: the engine goes on while a port does not open and while a disk takes nothing.
#include "app/engine/enginecore.h"
#include "async/virtualclock.h"
#include "heard.h"
#include "support/eventloop.h"
#include "support/heldbackground.h"
#include "support/pseudoterminal.h"
#include "support/temporaryfile.h"
#include "support/textmotor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include <poll.h>

namespace mb {
namespace {

using namespace std::chrono_literals;

class SlowWork : public testing::Test {
protected:
    SlowWork() { core.setBackground(&background); }
    void open(const test::PseudoTerminal &terminal)
    {
        core.send(orders::OpenLink{addressOf(terminal)}, opened.finished());
    }
    static LinkAddress addressOf(const test::PseudoTerminal &terminal)
    {
        return *LinkAddress::parse("serial:" + terminal.path());
    }
    void openNow(const test::PseudoTerminal &terminal)
    {
        open(terminal);
        background.release();
        clock.advance(10ms);
        ASSERT_TRUE(opened && *opened);
        opened.reset();
    }
    [[nodiscard]] bool isOpen(const test::PseudoTerminal &terminal)
    {
        const Link *link = core.session().linkBook().find(addressOf(terminal));
        return link && link->state() == LinkState::Open;
    }
    [[nodiscard]] static bool isHeldByNobody(const test::PseudoTerminal &terminal)
    {
        pollfd source{terminal.descriptor(), POLLIN, 0};
        return ::poll(&source, 1, 0) == 1 && (source.revents & POLLHUP) != 0;
    }
    [[nodiscard]] bool said(const std::string &part) const
    {
        return std::any_of(
            lines.begin(), lines.end(), [&part](const std::string &l) { return l.find(part) != std::string::npos; });
    }
    Device &motor() { return *core.session().devices().front(); }

    test::EventLoop loop;
    VirtualClock clock;
    test::HeldBackground background;
    test::PseudoTerminal slow;
    test::PseudoTerminal good;
    EngineCore core{clock, test::textFamilies, false};
    test::Heard<> opened;
    std::vector<std::string> lines;
    Subscription listening = core.noticed().add(
        [this](Severity, const std::string &, const Message &text) { lines.push_back(text.english()); });
};

} // namespace

TEST_F(SlowWork, APortIsOpenOnceItsDriverHasAnswered)
{
    open(slow);
    clock.advance(4s);
    EXPECT_FALSE(opened);
    EXPECT_FALSE(isOpen(slow));
    background.release();
    clock.advance(10ms);
    ASSERT_TRUE(opened && *opened);
    EXPECT_TRUE(isOpen(slow));
}

TEST_F(SlowWork, APortThatIsAskedForTwiceIsOpenedOnceAndAnswersBoth)
{
    open(slow);
    test::Heard<> second;
    core.send(orders::OpenLink{addressOf(slow)}, second.finished());
    EXPECT_FALSE(second);
    EXPECT_EQ(background.waiting(), 1U);
    background.release();
    clock.advance(10ms);
    ASSERT_TRUE(opened && second);
    EXPECT_TRUE(*opened);
    EXPECT_TRUE(*second);
}

TEST_F(SlowWork, APortThatIsClosedBeforeItIsOpenTellsEveryOneWhoAskedForIt)
{
    open(slow);
    test::Heard<> second;
    core.send(orders::OpenLink{addressOf(slow)}, second.finished());
    core.send(orders::CloseLink{addressOf(slow).text()});
    ASSERT_TRUE(opened && second);
    EXPECT_EQ(opened->error().fault, Fault::Cancelled);
    EXPECT_EQ(second->error().fault, Fault::Cancelled);
}

TEST_F(SlowWork, APortThatDoesNotOpenEndsWithOneClearError)
{
    open(slow);
    clock.advance(Link::openLimit + 1ms);
    ASSERT_TRUE(opened && !*opened);
    EXPECT_EQ(opened->error().fault, Fault::LinkLost);
    EXPECT_NE(opened->error().text().find("its driver has not answered for 5 s; unplug it"), std::string::npos)
        << opened->error().text();
    EXPECT_EQ(lines.size(), 1U);
    EXPECT_EQ(core.snapshot().failed.size(), 1U) << "the window shows it";
    background.release();
    clock.advance(1s);
    EXPECT_FALSE(isOpen(slow)) << "too late: nobody waits for it";
    EXPECT_TRUE(isHeldByNobody(slow));
}

TEST_F(SlowWork, StopsLeaveWhileAnotherPortDoesNotOpen)
{
    openNow(good);
    ASSERT_FALSE(core.session().devices().empty());
    open(slow);
    (void)good.read();
    core.stopAll(StopCause::User);
    const auto bytes = good.read();
    EXPECT_NE(std::string(bytes.begin(), bytes.end()).find(test::textStop), std::string::npos);
    EXPECT_FALSE(opened);
}

TEST_F(SlowWork, AnInterfaceThatIsUpIsOpenedElsewhereTooAndOnceAlthoughSomebodyAsksForIt)
{
    EngineCore unasked(clock, test::textFamilies, true);
    unasked.setBackground(&background);
    LinkListing listing;
    listing.link = *LinkAddress::parse("socketcan:nothere0");
    listing.openable = true;
    unasked.links().takeListings({listing});
    EXPECT_EQ(background.waiting(), 1U) << "a driver may hold up whoever opens it";
    unasked.links().takeListings({listing});
    unasked.send(orders::OpenLink{listing.link}, opened.finished());
    EXPECT_EQ(background.waiting(), 1U);
    background.release();
    clock.advance(10ms);
    ASSERT_TRUE(opened && !*opened);
    EXPECT_TRUE(unasked.session().links().empty());
    const Snapshot shot = unasked.snapshot();
    ASSERT_EQ(shot.failed.size(), 1U) << "whoever asked is told, although it had begun by itself";
    EXPECT_EQ(shot.failed[0].address, "socketcan:nothere0");
}

TEST_F(SlowWork, APortThatIsClosedBeforeItIsOpenStaysClosed)
{
    open(slow);
    core.send(orders::CloseLink{addressOf(slow).text()});
    ASSERT_TRUE(opened && !*opened);
    background.release();
    clock.advance(1s);
    EXPECT_FALSE(isOpen(slow));
    EXPECT_TRUE(isHeldByNobody(slow));
    openNow(slow);
}

TEST_F(SlowWork, ALostPortThatHangsIsAskedForOnceAtATime)
{
    openNow(good);
    good.pull();
    ASSERT_TRUE(loop.runUntil([this] { return core.snapshot().links[0].state == LinkState::Lost; }));
    EXPECT_EQ(background.waiting(), 1U) << "it is closed, elsewhere";
    background.release();
    for (int second = 0; second < 4; ++second) {
        clock.advance(1s);
        EXPECT_LE(background.waiting(), 1U);
    }
    EXPECT_EQ(background.waiting(), 1U) << "it is tried, elsewhere";
}

TEST_F(SlowWork, WhatIsKnownOfADeviceIsKeptAlthoughTheDiskTakesItLater)
{
    const test::TemporaryFolder folder;
    core.session().memory().keepProfiles(folder.path("profiles"));
    openNow(good);
    motor().knowledge().setVerdict("direction", DirectionVerdict::Reversed);
    EXPECT_EQ(background.waiting(), 1U);
    EXPECT_FALSE(std::filesystem::exists(folder.path("profiles")));
    core.send(orders::CloseLink{addressOf(good).text()});
    open(good);
    background.release();
    clock.advance(10ms);
    ASSERT_TRUE(isOpen(good));
    EXPECT_EQ(motor().knowledge().profile().verdicts.at("direction"), DirectionVerdict::Reversed);
    EXPECT_TRUE(std::filesystem::exists(folder.path("profiles")));
}

} // namespace mb
