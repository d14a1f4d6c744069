// SPDX-License-Identifier: GPL-3.0-or-later
// What is counted of a Supermodified: positions across its starts, tries of a request, and which node is asked.
#include "families/supermodified/line.h"
#include "families/supermodified/motioncount.h"
#include "families/supermodified/node.h"
#include "families/supermodified/nodepresence.h"
#include "families/supermodifiedbench.h"

#include <tuple>

namespace mb::supermodified {
namespace {

using namespace std::chrono_literals;
using mb::test::run;
using test::Bench;
using test::OneNode;
using test::setPoint;

TEST(SupermodifiedCount, PositionsGoOnAcrossStartsWhichTheNodeTakesForItsZero)
{
    MotionCount count;
    EXPECT_FALSE(count.position());
    count.started();
    EXPECT_EQ(count.origin(), 0) << "nobody knew where it was";
    EXPECT_EQ(count.ofNode(), 0);
    count.told(700);
    EXPECT_EQ(count.position(), 700);
    count.started();
    EXPECT_EQ(count.origin(), 700);
    EXPECT_EQ(count.ofNode(), 0);
    count.told(-50);
    count.started();
    EXPECT_EQ(count.origin(), 650);
    EXPECT_EQ(count.position(), 650);
    SetPoint move = setPoint(Mode::Position, 1000.4);
    EXPECT_EQ(count.targetOf(move), 350);
    move.mode = Mode::RampPosition;
    EXPECT_EQ(count.targetOf(move), 350);
    move.relative = true;
    EXPECT_EQ(count.targetOf(move), 1000) << "a distance has no origin";
    EXPECT_EQ(count.targetOf(setPoint(Mode::Velocity, -99.6)), -100) << "nor has a speed";
    count.zeroed();
    EXPECT_EQ(count.origin(), 0);
    EXPECT_EQ(count.position(), 0);
}

TEST(SupermodifiedCount, AStartWithoutAnswerIsAnotherZeroOnlyWhereTheNodeCountsFromThere)
{
    MotionCount count;
    count.told(700);
    count.began(setPoint(Mode::Position, 700.0));
    count.startSent();
    EXPECT_FALSE(count.mayHaveStarted(690)) << "it counts as before";
    EXPECT_EQ(count.origin(), 0);
    EXPECT_TRUE(count.error());
    EXPECT_FALSE(count.mayHaveStarted(3)) << "the first position after it tells";
    count.startSent();
    EXPECT_TRUE(count.mayHaveStarted(3));
    count.told(3);
    EXPECT_EQ(count.position(), 703);
    EXPECT_FALSE(count.error()) << "where its loop wants to be is not known any more";
    SetPoint distance = setPoint(Mode::Position, 10.0);
    distance.relative = true;
    EXPECT_FALSE(count.stepOf(distance, true)) << "nor, then, what adds to that";
}

/// What tells a node that lost its supply from one that was told to go to 0.
TEST(SupermodifiedPresence, CountsThatAreGoneAfterASilenceAreARestartUnlessItTakesItsNextMove)
{
    struct Row {
        bool isAsked;
        void (NodePresence::*answer)();
        bool hasRestarted;
    };
    for (const Row &row : {Row{true, &NodePresence::moved, false}, {true, &NodePresence::notStarted, true},
             {false, &NodePresence::moved, true}, {false, &NodePresence::notStarted, true}}) {
        Bench bench;
        const auto line = Line::of(bench.host, bench.clock);
        const Node node;
        NodePresence presence(*line, node, {[] {}, [] {}});
        presence.located(500, false);
        (void)presence.missed();
        (void)presence.answered();
        presence.located(0, row.isAsked);
        EXPECT_NE(presence.hasRestarted(), row.isAsked) << "it is asked first";
        (presence.*row.answer)();
        EXPECT_EQ(presence.hasRestarted(), row.hasRestarted);
        presence.notStarted();
        EXPECT_EQ(presence.hasRestarted(), row.hasRestarted) << "there is no doubt any more";
        presence.refreshed();
        presence.notStarted();
        EXPECT_FALSE(presence.hasRestarted());
    }
}

/// Next to where it counts from it may have been switched off and on, where no motor could have come so fast.
TEST(SupermodifiedPresence, CountsThatJumpToTheirOriginFourTimesAsFarAsTheyLastWentAreDoubted)
{
    Bench bench;
    const auto line = Line::of(bench.host, bench.clock);
    const Node node;
    for (const auto &[step, from, jumps] : {std::tuple{10, 40, false}, {10, 41, true}, {-10, 41, true}, {0, 16, false},
             {0, 17, true}, {100, 400, false}, {100, 401, true}}) {
        NodePresence presence(*line, node, {[] {}, [] {}});
        presence.located(from - step, false);
        presence.located(from, false);
        EXPECT_EQ(presence.hasJumped(0), jumps) << step << ' ' << from;
        EXPECT_FALSE(presence.hasJumped(from * 2)) << "away from it";
    }
}

/// A line with a peer that answers every request with the same code.
class SupermodifiedVerdicts : public testing::Test {
protected:
    SupermodifiedVerdicts() { EXPECT_TRUE(host.open() && peer.open()); }
    /// How often the node is asked, and what becomes of it.
    int triesAt(std::uint8_t code, Fault expected)
    {
        int asked = 0;
        FrameReader reader([&](const Frame &frame) {
            ++asked;
            Frame answer;
            answer.to = frame.from;
            answer.from = 4;
            answer.command = static_cast<std::uint8_t>(Command::Error);
            answer.size = 1;
            answer.data[0] = code;
            if (code != 0)
                (void)peer.send(uartBytes(answer));
        });
        const auto heard = peer.received().add([&reader](std::span<const std::uint8_t> bytes) { reader.feed(bytes); });
        Node node;
        node.id = 4;
        node.baudrate = host.baudrate();
        const auto shared = Line::of(host, clock);
        const auto answer = run(clock, converse(*shared, asking(node, Command::GetPosition), {}, 4));
        EXPECT_FALSE(answer);
        EXPECT_EQ(answer.error().fault, expected);
        return asked;
    }
    VirtualClock clock;
    VirtualSerialLine wire{clock, VirtualSerialLine::Wiring::HalfDuplex, 1};
    VirtualSerialLink host{*LinkAddress::parse("sim:serial"), wire};
    VirtualSerialLink peer{*LinkAddress::parse("sim:serial"), wire};
};

TEST_F(SupermodifiedVerdicts, AnAnswerThatSaysNoTwiceIsBelievedAndNoiseIsAskedAgainFourTimes)
{
    for (const std::uint8_t verdict : {code::invalidCommand, code::invalidSetCount, code::invalidArgument,
             code::invalidForState, code::invalidGetCount})
        EXPECT_EQ(triesAt(verdict, Fault::Refused), 2) << static_cast<int>(verdict);
    for (const std::uint8_t noise : {code::motorStalled, code::encoderOverflow, std::uint8_t{0x10}, std::uint8_t{0x16},
             code::uartFrame, code::halfPacket, code::wrongLrc})
        EXPECT_EQ(triesAt(noise, Fault::Refused), 4) << static_cast<int>(noise);
    EXPECT_EQ(triesAt(0, Fault::Timeout), 4) << "silence";
}

TEST_F(OneNode, ANodeWithAnotherNumberIsPolledUnderThatOneAndNobodyUnderTheOld)
{
    ASSERT_TRUE(run(bench.clock, device->renumber(9)));
    node.setPowered(false); // it is in force after a restart
    bench.clock.advance(1s);
    node.setPowered(true);
    Identity found = device->identity(); // as a scan does
    found.address = 9;
    device->setIdentity(std::move(found));
    bench.clock.advance(200ms);
    bench.sent.clear();
    bench.clock.advance(1s);
    EXPECT_TRUE(device->liveness().heard);
    const auto frames = bench.framesSent();
    EXPECT_GT(frames.size(), 10U);
    for (const Frame &frame : frames)
        EXPECT_EQ(frame.to, 9);
}

TEST_F(OneNode, ANodeIsGivenTheFirstAndTheLastNumberThereIsAndNoneBeside)
{
    for (const int number : {0, 128, -1})
        EXPECT_FALSE(run(bench.clock, device->renumber(number))) << number;
    EXPECT_EQ(bench.count(Command::NodeId), 0);
    for (const int number : {127, 1})
        EXPECT_TRUE(run(bench.clock, device->renumber(number))) << number;
}

TEST_F(OneNode, WhatItsDialectHasNotIsNotAsked)
{
    bench.clock.advance(200ms);
    bench.sent.clear();
    const auto read = run(bench.clock, device->read(test::Bench::index("anti_windup")));
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().fault, Fault::Unsupported);
    EXPECT_EQ(bench.count(Command::GetAntiWindup), 0);
}

TEST_F(OneNode, ItIsHeardAgainAsSoonAsItsLineIsBack)
{
    for (const bool isAsking : {false, true}) {
        bench.clock.advance(500ms);
        ASSERT_TRUE(device->liveness().heard);
        bench.sent.clear();
        if (isAsking) {
            ASSERT_TRUE(bench.clock.runUntil([this] { return !bench.sent.empty(); }, 1s));
        }
        bench.host.close();
        EXPECT_FALSE(device->liveness().heard);
        bench.clock.advance(5s);
        ASSERT_TRUE(bench.host.open());
        bench.clock.advance(100ms);
        EXPECT_TRUE(device->liveness().heard) << "a question was under way: " << isAsking;
        bench.sent.clear();
        bench.clock.advance(1s);
        EXPECT_GT(bench.count(Command::GetPosition), 5);
    }
}

/// A node whose answers have these lengths, as the scan lists it.
std::string dialectOf(std::uint8_t position, std::uint8_t velocity, std::uint8_t acceleration)
{
    VirtualClock clock;
    VirtualSerialLine wire{clock, VirtualSerialLine::Wiring::HalfDuplex, 1};
    VirtualSerialLink host{*LinkAddress::parse("sim:serial?baud=57600"), wire};
    VirtualSerialLink peer{*LinkAddress::parse("sim:serial?baud=57600"), wire};
    EXPECT_TRUE(host.open() && peer.open());
    FrameReader reader([&](const Frame &frame) {
        Frame answer;
        answer.to = frame.from;
        answer.from = 4;
        answer.command = frame.command;
        answer.size = frame.is(Command::GetPosition) ? position
            : frame.is(Command::GetVelocity)         ? velocity
            : frame.is(Command::GetNodeMask)         ? std::uint8_t{1}
            : frame.is(Command::GetP)                ? std::uint8_t{2}
                                                     : acceleration;
        answer.data.fill(0);
        if (frame.is(Command::GetNodeMask))
            answer.data[0] = exactMask;
        if (frame.to == 4)
            (void)peer.send(uartBytes(answer));
    });
    const auto heard = peer.received().add([&reader](std::span<const std::uint8_t> bytes) { reader.feed(bytes); });
    test::Bench::Found found;
    EXPECT_TRUE(run(clock, scan(host, clock, found)));
    if (found.rows.empty())
        return "nobody";
    return found.rows.back().dialect.empty() ? found.rows.back().detail.english() : found.rows.back().dialect;
}

TEST(SupermodifiedDialects, AllThreeAnswersMustAgree)
{
    EXPECT_EQ(dialectOf(4, 2, 2), "D1");
    EXPECT_EQ(dialectOf(4, 4, 4), "D2");
    EXPECT_EQ(dialectOf(8, 4, 4), "D3");
    const std::string none = "Its answers fit no known dialect.";
    EXPECT_EQ(dialectOf(4, 2, 4), none) << "the speed of D1, the acceleration of D2";
    EXPECT_EQ(dialectOf(4, 4, 2), none);
    EXPECT_EQ(dialectOf(8, 4, 2), none);
    EXPECT_EQ(dialectOf(4, 3, 2), none);
    EXPECT_EQ(dialectOf(5, 2, 2), none);
}

TEST(SupermodifiedCodes, ThoseThatSwitchTheBridgeOffAreActiveUntilTheNextStart)
{
    for (const CodeName &name : codeNames()) {
        CodeReports reports;
        const bool ends = name.code == code::motorStalled || name.code == code::encoderOverflow
            || name.code == code::encoderUnderflow;
        EXPECT_EQ(reports.take(name.code), ends) << name.key;
        EXPECT_EQ(reports.take(name.code), ends) << name.key;
        EXPECT_EQ(
            reports.active(), ends ? std::vector<std::string>{std::string(name.key)} : std::vector<std::string>{});
        int told = 0;
        for (const FaultRecord &record : reports.records()) {
            const bool its = record.key == name.key;
            told += its ? 1 : 0;
            EXPECT_EQ(record.active, its && ends) << record.key;
            EXPECT_EQ(record.sticky, its) << record.key;
            EXPECT_EQ(record.count, its ? 2 : 0) << record.key;
        }
        EXPECT_EQ(told, 1) << name.key;
        reports.started();
        EXPECT_TRUE(reports.active().empty());
        reports.clear();
        for (const FaultRecord &record : reports.records())
            EXPECT_FALSE(record.sticky) << record.key;
    }
}

} // namespace
} // namespace mb::supermodified
