// SPDX-License-Identifier: GPL-3.0-or-later
// Acceptance masks (supermodified/README.md#masks): who follows whom, which id the host has, and what is locked.
#include "families/supermodifiedbench.h"

namespace mb::supermodified {
namespace {

using namespace std::chrono_literals;
using mb::test::run;
using test::Bench;
using test::setPoint;

TEST(SupermodifiedRoster, TheHostIsOutsideEveryMaskThatLeavesRoom)
{
    for (int mask = 1; mask <= 255; ++mask) {
        for (const int node : {1, 4, 5, 15, 0x70, 0x77, 127}) {
            Roster roster;
            roster.note(node, 57600);
            roster.noteMask(node, static_cast<std::uint8_t>(mask));
            const int host = roster.hostId();
            EXPECT_GE(host, lowestNode);
            EXPECT_LE(host, highestNode);
            if (roster.lockOf(node).empty()) {
                EXPECT_NE(host & mask, node & mask) << mask << ' ' << node;
            } else {
                for (int other = lowestNode; other <= highestNode; ++other)
                    ASSERT_EQ(other & mask, node & mask) << "there was a free id";
            }
        }
    }
}

TEST(SupermodifiedRoster, AMaskAndAnIdThatWaitForARestartCountAlready)
{
    Roster roster;
    roster.note(4, 57600);
    roster.note(5, 57600);
    EXPECT_EQ(roster.lockOf(5), "");
    roster.noteNextMask(4, 0xF0);
    EXPECT_EQ(roster.followersOf(5), std::vector<int>{4});
    roster.noteMask(4, 0xFF); // still in force
    EXPECT_EQ(roster.followersOf(5), std::vector<int>{4});
    roster.noteMask(4, 0xF0); // it was restarted
    roster.noteNextMask(4, 0xFF);
    EXPECT_EQ(roster.followersOf(5), std::vector<int>{4}) << "the old one is still in force";
    roster.noteMask(4, 0xFF);
    EXPECT_EQ(roster.lockOf(5), "");
    roster.noteNextMask(4, 0xF0);
    roster.noteMask(4, 0xF0);
    roster.noteMask(4, 0xFF);
    EXPECT_EQ(roster.followersOf(5), std::vector<int>{}) << "what was written was in force, and is not any more";
    roster.noteNextId(4, usualHostId);
    EXPECT_NE(roster.hostId(), usualHostId);
}

TEST(SupermodifiedRoster, AMaskThatWasReadOnceIsKnownAlthoughItIsNotReadAgain)
{
    Roster roster;
    roster.note(4, 57600);
    roster.note(5, 57600);
    EXPECT_EQ(roster.lockOf(5), "") << "nobody has asked for it yet";
    roster.noteUnreadMask(4);
    EXPECT_NE(roster.lockOf(5).english().find("node 4"), std::string::npos);
    EXPECT_EQ(roster.lockOf(4), "") << "what it does when others are addressed is not its own matter";
    roster.noteMask(4, 0xFF);
    roster.noteUnreadMask(4);
    EXPECT_EQ(roster.lockOf(5), "");
    roster.note(6, 9600);
    roster.noteUnreadMask(6);
    EXPECT_EQ(roster.lockOf(5), "") << "at another rate it hears no frame";
    roster.note(6, 57600);
    EXPECT_NE(roster.lockOf(5), "");
    roster.forget(6);
    EXPECT_EQ(roster.lockOf(5), "");
}

TEST(SupermodifiedRoster, WhereEveryIdIsInAGroupControlIsLocked)
{
    Roster roster;
    roster.note(4, 57600);
    roster.noteMask(4, 0x01);
    EXPECT_EQ(roster.hostId() & 1, 1);
    EXPECT_EQ(roster.lockOf(4), "");
    roster.note(7, 57600);
    roster.noteMask(7, 0x01);
    EXPECT_NE(roster.lockOf(4), "");
    EXPECT_NE(roster.lockOf(4).english().find("node.mask"), std::string::npos);
}

TEST(SupermodifiedMasks, DrivingANodeThatWasOnlyProbedStartsNobodyElse)
{
    for (const int id : {4, 6, 15}) {
        Bench bench;
        Simulator &follower = bench.add("supermodified:" + std::to_string(id) + ",mask=240");
        Simulator &driven = bench.add("supermodified:5");
        bool started = false;
        const Subscription events
            = follower.events().add([&](const SimulatorEvent &event) { started |= event.what == "output-on"; });
        const auto five = bench.connect(5);
        const auto allowed = five->mayMove();
        ASSERT_FALSE(allowed) << id;
        EXPECT_EQ(allowed.error().fault, Fault::Unsafe);
        EXPECT_NE(allowed.error().text().find("node " + std::to_string(id)), std::string::npos)
            << allowed.error().detail;
        EXPECT_FALSE(five->command(setPoint(Mode::Velocity, 200.0)));
        bench.clock.advance(2s);
        EXPECT_FALSE(started) << id;
        EXPECT_FALSE(driven.isOutputOn());
    }
}

TEST(SupermodifiedMasks, ANodeOfAnEarlierRunHidesNobodyWhoFollows)
{
    Bench before;
    before.add("supermodified:9");
    const std::vector<Identity> known = before.scanAll();
    ASSERT_EQ(known.size(), 1U);
    for (const bool isThere : {true, false}) {
        Bench bench;
        if (isThere)
            bench.add("supermodified:9");
        bench.add("supermodified:5");
        bench.add("supermodified:6,mask=240");
        const auto allowed = bench.connect(5, known)->mayMove();
        ASSERT_FALSE(allowed) << isThere;
        EXPECT_NE(allowed.error().text().find("node 6"), std::string::npos) << allowed.error().text();
    }
}

TEST(SupermodifiedMasks, LostAnswersHideNobodyWhoFollows)
{
    for (const std::string lost : {"drop@1", "drop@1,fault=drop@2"}) {
        Bench bench;
        bench.add("supermodified:5");
        bench.add("supermodified:6,mask=240,fault=" + lost);
        const auto allowed = bench.connect(5)->mayMove();
        ASSERT_FALSE(allowed) << lost;
        EXPECT_NE(allowed.error().text().find("node 6"), std::string::npos) << allowed.error().text();
    }
}

TEST(SupermodifiedMasks, ANodeWithTheIdOfTheHostIsFoundBeforeAnotherAnswersIt)
{
    Bench bench;
    bench.add("supermodified:5");
    bench.add("supermodified:" + std::to_string(usualHostId));
    const auto five = bench.connect(5);
    EXPECT_NE(Line::of(bench.host, bench.clock)->roster().hostId(), usualHostId);
    for (const Frame &frame : bench.framesSent())
        EXPECT_FALSE(frame.to == 5 && frame.from == usualHostId) << "its answer would be an order to the other";
}

TEST(SupermodifiedMasks, WhileThatOfANodeCannotBeReadNoOtherIsDriven)
{
    for (const bool scans : {false, true}) {
        Bench bench;
        bench.add("supermodified:4");
        bench.add("supermodified:5,level=1");
        if (scans)
            (void)bench.scanAll();
        const auto four = bench.connect(4);
        const auto five = bench.connect(5);
        const auto allowed = four->mayMove();
        ASSERT_FALSE(allowed) << scans;
        EXPECT_EQ(allowed.error().fault, Fault::Unsafe);
        EXPECT_NE(allowed.error().text().find("node 5"), std::string::npos) << allowed.error().text();
        Line::of(bench.host, bench.clock)->roster().forget(5);
        EXPECT_TRUE(four->mayMove()) << "a scan missed it";
        bench.clock.advance(1s);
        EXPECT_FALSE(four->mayMove()) << "it is heard, with a mask that nobody has read";
        ASSERT_TRUE(run(bench.clock, five->write(Bench::index("error.level"), 0)));
        ASSERT_TRUE(run(bench.clock, five->refresh()));
        EXPECT_TRUE(four->mayMove()) << four->mayMove().error().text();
    }
}

TEST(SupermodifiedMasks, ANodeThatFallsSilentInItsInterviewLeavesItsMaskUnknown)
{
    Bench bench;
    bench.add("supermodified:4");
    Simulator &other = bench.add("supermodified:5");
    const auto four = bench.connect(4); // it asks for the masks of others
    const auto keep = Line::of(bench.host, bench.clock);
    keep->roster().forget(5);
    ASSERT_TRUE(four->mayMove());
    bench.sent.clear();
    Timer cut(bench.clock);
    const Subscription asked = bench.host.traffic().add([&](const Traffic &traffic) {
        const auto frames = test::framesIn({traffic.bytes.begin(), traffic.bytes.end()});
        if (traffic.direction == Direction::Received && !frames.empty() && frames.back().from == 5)
            cut.startIn(Duration::zero(), [&] { other.setPowered(false); });
    });
    (void)bench.scanAll();
    EXPECT_FALSE(four->mayMove());
}

TEST(SupermodifiedMasks, TheDriverOfANodeWithAMaskHearsNoAnswerDoneByIt)
{
    Bench bench;
    Simulator &masked = bench.add("supermodified:4,mask=240");
    Simulator &other = bench.add("supermodified:20,dialect=D3");
    const auto four = bench.connect(4);
    const auto twenty = bench.connect(20);
    ASSERT_TRUE(twenty->command(setPoint(Mode::Velocity, 2000.0)));
    bench.clock.advance(1s);
    EXPECT_TRUE(other.isOutputOn());
    EXPECT_FALSE(masked.isOutputOn()) << "the answer to a start is a start for whose group the host is in";
    twenty->stop();
    bench.clock.advance(100ms);
    EXPECT_FALSE(other.isOutputOn());
}

TEST(SupermodifiedMasks, AMaskThatIsWrittenLocksItsGroupAtOnce)
{
    Bench bench;
    bench.add("supermodified:4");
    bench.add("supermodified:5");
    const auto four = bench.connect(4);
    const auto five = bench.connect(5);
    EXPECT_TRUE(five->mayMove());
    ASSERT_TRUE(run(bench.clock, four->write(Bench::index("node.mask"), 0xF0)));
    EXPECT_FALSE(five->mayMove());
    ASSERT_TRUE(run(bench.clock, four->write(Bench::index("node.mask"), 0xFF)));
    EXPECT_TRUE(five->mayMove()) << "it never was in force";
}

TEST(SupermodifiedMasks, AMaskThatIsFoundWhileAMotorRunsStopsIt)
{
    Bench bench;
    Simulator &driven = bench.add("supermodified:5");
    const auto five = bench.connect(5);
    bench.clock.advance(200ms);
    SetPointStream stream(*five, bench.clock);
    ASSERT_TRUE(stream.start(setPoint(Mode::Velocity, 1000.0), 60s));
    bench.clock.advance(300ms);
    ASSERT_TRUE(driven.isOutputOn());
    bench.add("supermodified:4,mask=240");
    (void)bench.scanAll();
    bench.clock.advance(200ms);
    EXPECT_FALSE(stream.isRunning());
    EXPECT_FALSE(driven.isOutputOn());
}

TEST(SupermodifiedMasks, AFollowerThatIsFoundWhileAMotorRunsIsStoppedByItsOwnAddress)
{
    Bench bench;
    bench.add("supermodified:5");
    const auto five = bench.connect(5);
    bench.clock.advance(200ms);
    SetPointStream stream(*five, bench.clock);
    ASSERT_TRUE(stream.start(setPoint(Mode::Velocity, 1000.0), 60s));
    bench.clock.advance(300ms);
    Simulator &follower = bench.add("supermodified:4,mask=240");
    (void)bench.scanAll();
    bench.clock.advance(200ms);
    ASSERT_FALSE(stream.isRunning());
    bench.sent.clear();
    const auto four = bench.connect(4);
    bench.clock.advance(200ms);
    const auto sent = bench.framesSent();
    EXPECT_TRUE(std::any_of(
        sent.begin(), sent.end(), [](const Frame &frame) { return frame.to == 4 && frame.is(Command::Stop); }));
    EXPECT_EQ(four->stopping().state(), StopState::Seen) << "and followed up until it is seen";
    EXPECT_FALSE(follower.isOutputOn());
    bench.sent.clear();
    const auto again = bench.connect(4);
    bench.clock.advance(200ms);
    EXPECT_EQ(bench.count(Command::Stop), 0) << "once";
}

TEST(SupermodifiedIds, AnIdThatAnotherNodeGetsWithItsRestartIsTaken)
{
    Bench bench;
    bench.add("supermodified:4");
    bench.add("supermodified:6");
    const auto four = bench.connect(4);
    const auto six = bench.connect(6);
    ASSERT_TRUE(run(bench.clock, four->renumber(5)));
    const auto refused = run(bench.clock, six->renumber(5));
    ASSERT_FALSE(refused) << "two of one id";
    EXPECT_EQ(refused.error().fault, Fault::OutOfRange);
    EXPECT_TRUE(run(bench.clock, four->renumber(5))) << "its own";
    ASSERT_TRUE(run(bench.clock, four->renumber(7)));
    EXPECT_TRUE(run(bench.clock, six->renumber(5))) << "nobody wants it any more";
}

void restart(Bench &bench, Simulator &node)
{
    node.setPowered(false);
    bench.clock.advance(300ms);
    node.setPowered(true);
    bench.clock.advance(300ms);
}

TEST(SupermodifiedIds, ANodeThatWasRenumberedAndRestartedIsDrivenAtItsNewId)
{
    for (const bool scans : {true, false}) {
        Bench bench;
        Simulator &node = bench.add("supermodified:4");
        {
            const auto four = bench.connect(4);
            ASSERT_TRUE(run(bench.clock, four->renumber(5)));
            restart(bench, node);
        }
        const auto keep = Line::of(bench.host, bench.clock);
        if (scans) {
            EXPECT_EQ(bench.scanAll().size(), 1U);
        }
        const auto five = bench.connect(5);
        EXPECT_TRUE(five->mayMove()) << scans << ' ' << five->mayMove().error().text();
        EXPECT_FALSE(keep->roster().nodes().contains(4)) << "its old id is free";
    }
}

TEST(SupermodifiedMasks, ANodeThatWasUnpluggedDoesNotLockTheOthersAfterAScan)
{
    Bench bench;
    Simulator &masked = bench.add("supermodified:4,mask=240");
    bench.add("supermodified:5");
    const auto four = bench.connect(4);
    const auto five = bench.connect(5);
    ASSERT_FALSE(five->mayMove());
    masked.setPowered(false);
    bench.clock.advance(2s);
    (void)bench.scanAll();
    EXPECT_TRUE(five->mayMove());
    masked.setPowered(true);
    bench.clock.advance(3s);
    EXPECT_TRUE(four->liveness().heard);
    EXPECT_FALSE(five->mayMove()) << "it is back, and its mask with it";
}

TEST(SupermodifiedMasks, ANodeThatMissedOneQuestionOfAScanKeepsItsLock)
{
    Bench bench;
    bench.add("supermodified:4,mask=240");
    bench.add("supermodified:5");
    {
        const auto four = bench.connect(4);
    }
    const auto five = bench.connect(5);
    ASSERT_FALSE(five->mayMove());
    int asked = 0;
    Timer back(bench.clock);
    const Subscription losing = bench.host.traffic().add([&](const Traffic &traffic) {
        const auto frames = test::framesIn({traffic.bytes.begin(), traffic.bytes.end()});
        if (traffic.direction != Direction::Sent || frames.empty() || frames.back().to != 4 || ++asked > 1)
            return;
        bench.line.setLoss(1.0);
        back.startIn(20ms, [&] { bench.line.setLoss(0.0); });
    });
    EXPECT_EQ(bench.scanAll().size(), 2U);
    EXPECT_GT(asked, 1);
    EXPECT_FALSE(five->mayMove());
}

} // namespace
} // namespace mb::supermodified
