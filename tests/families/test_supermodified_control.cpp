// SPDX-License-Identifier: GPL-3.0-or-later
// The controller against simulated nodes: moves, stops that are refused, restarts, time-outs.
#include "families/supermodifiedbench.h"

#include <cmath>

namespace mb::supermodified {
namespace {

using namespace std::chrono_literals;
using mb::test::run;
using test::Bench;
using test::setPoint;
using SupermodifiedNode = test::OneNode;

TEST_F(SupermodifiedNode, StartsOnceAndSendsAnEqualSetPointOnce)
{
    bench.clock.advance(200ms);
    bench.sent.clear();
    for (int i = 0; i < 20; ++i) {
        ASSERT_TRUE(device->command(setPoint(Mode::Velocity, 2000.0)));
        bench.clock.advance(20ms);
    }
    EXPECT_EQ(bench.count(Command::Start), 1);
    EXPECT_EQ(bench.count(Command::Stop), 1) << "before the start, because nobody knew its state";
    EXPECT_EQ(bench.count(Command::MoveVelocity), 1);
    EXPECT_GT(node.speed(), 1000.0);
    EXPECT_TRUE(device->liveness().moving);
    device->stop();
    EXPECT_FALSE(device->isSeenStopped());
    bench.clock.advance(20ms);
    EXPECT_TRUE(device->isSeenStopped());
    EXPECT_FALSE(node.isOutputOn());
    EXPECT_EQ(bench.count(Command::Stop), 2);
}

TEST_F(SupermodifiedNode, AStopThatIsRefusedIsRepeatedUntilItIsAcknowledged)
{
    order(setPoint(Mode::Velocity, 2000.0), 300ms);
    ASSERT_TRUE(node.isOutputOn());
    bench.sent.clear();
    node.disturb("error", 0x43);
    device->stop();
    bench.clock.advance(25ms);
    EXPECT_FALSE(node.isOutputOn());
    EXPECT_TRUE(device->isSeenStopped());
    EXPECT_GE(bench.count(Command::Stop), 1);
}

TEST_F(SupermodifiedNode, AStopGoesOnThroughSilenceAndThroughALostCable)
{
    order(setPoint(Mode::Velocity, 2000.0), 300ms);
    bench.line.setLoss(1.0);
    device->stop();
    bench.clock.advance(5s);
    EXPECT_TRUE(node.isOutputOn());
    EXPECT_FALSE(device->isSeenStopped());
    bench.line.setLoss(0.0);
    bench.clock.advance(300ms);
    EXPECT_FALSE(node.isOutputOn());
    EXPECT_TRUE(device->isSeenStopped());

    order(setPoint(Mode::Velocity, 2000.0), 300ms);
    ASSERT_TRUE(node.isOutputOn());
    bench.line.pull(bench.host);
    device->stop();
    bench.clock.advance(1s);
    EXPECT_TRUE(node.isOutputOn());
    ASSERT_TRUE(bench.host.open());
    bench.clock.advance(100ms);
    EXPECT_FALSE(node.isOutputOn());
    EXPECT_TRUE(device->isSeenStopped());
}

TEST_F(SupermodifiedNode, DestroyingADeviceThatIsDrivenSendsAStop)
{
    order(setPoint(Mode::Velocity, 2000.0), 300ms);
    ASSERT_TRUE(node.isOutputOn());
    device.reset();
    bench.clock.advance(50ms);
    EXPECT_FALSE(node.isOutputOn());
}

TEST(SupermodifiedControl, ARelativeMoveIsNeverSentTwiceWhenItsAnswerIsLost)
{
    Bench bench;
    Simulator &node = bench.add("supermodified:4,gains=tuned");
    const auto device = bench.connect(4);
    ASSERT_TRUE(device->command(setPoint(Mode::Position, 0.0)));
    bench.clock.advance(300ms);
    SetPoint step = setPoint(Mode::Position, 500.0);
    step.relative = true;
    step.order = 1;
    bench.sent.clear();
    ASSERT_TRUE(device->command(step));
    ASSERT_TRUE(bench.clock.runUntil([&] { return bench.count(Command::MoveRelative) == 1; }, 100ms));
    bench.clock.advance(1ms); // the request is on its way, the acknowledgement is not yet
    bench.line.setLoss(1.0);
    bench.clock.advance(2s);
    bench.line.setLoss(0.0);
    bench.clock.advance(1s);
    EXPECT_EQ(bench.count(Command::MoveRelative), 1);
    EXPECT_LT(node.position(), 700.0);
}

TEST_F(SupermodifiedNode, AMoveThatIsNeverTakenIsTriedFourTimesAndEndsTheMotion)
{
    order(setPoint(Mode::Velocity, 100.0), 300ms);
    bench.sent.clear();
    bench.line.setLoss(1.0);
    ASSERT_TRUE(device->command(setPoint(Mode::Velocity, 200.0)));
    bench.clock.advance(3s);
    EXPECT_EQ(bench.count(Command::MoveVelocity), 4);
    EXPECT_FALSE(device->command(setPoint(Mode::Velocity, 300.0))) << "until it was stopped";
    bench.line.setLoss(0.0);
    bench.clock.advance(1s);
    EXPECT_EQ(bench.count(Command::MoveVelocity), 4) << "a motion that has failed is not taken up again";
}

TEST_F(SupermodifiedNode, AnOrderThatWaitsWhenTheMotorStallsIsNotSentAnyMore)
{
    int waited = 0;
    for (int i = 0; i < 20; ++i) {
        device->stop();
        bench.clock.advance(300ms);
        order(setPoint(Mode::Velocity, 100.0), 300ms + i * 1ms);
        std::optional<int> sentBefore;
        const auto told = device->changed().add([&] {
            if (!sentBefore && !device->liveness().faults.empty())
                sentBefore = bench.count(Command::MoveVelocity);
        });
        bench.sent.clear();
        node.disturb("error", code::motorStalled); // is reported instead of the next answer
        ASSERT_TRUE(device->command(setPoint(Mode::Velocity, 200.0)));
        bench.clock.advance(300ms);
        ASSERT_TRUE(sentBefore) << "it has switched itself off";
        EXPECT_EQ(bench.count(Command::MoveVelocity), *sentBefore) << i;
        waited += *sentBefore == 0 ? 1 : 0;
    }
    EXPECT_GT(waited, 0) << "behind a question";
}

TEST_F(SupermodifiedNode, ARelativeMoveThatWasRefusedIsSentAgainAndDoneOnce)
{
    order(setPoint(Mode::Position, 0.0), 300ms);
    for (std::uint32_t order = 1; order <= 3; ++order) {
        node.disturb("error", 0x44); // is reported instead of the first answer
        SetPoint step = setPoint(Mode::Position, 500.0);
        step.relative = true;
        step.order = order;
        ASSERT_TRUE(device->command(step));
        bench.clock.advance(600ms);
    }
    EXPECT_NEAR(node.position(), 1500.0, 20.0);
}

TEST_F(SupermodifiedNode, PositionsStayContinuousAlthoughStartZeroesThem)
{
    order(setPoint(Mode::Position, 3000.0), 2s);
    EXPECT_NEAR(position(), 3000.0, 20.0);
    device->stop();
    bench.clock.advance(200ms);
    const double rest = position();
    ASSERT_TRUE(device->command(setPoint(Mode::Position, rest))); // the present position: nothing moves
    bench.clock.advance(1s);
    EXPECT_NEAR(position(), rest, 20.0);
    EXPECT_NEAR(node.position(), rest, 20.0);
    order(setPoint(Mode::Position, rest + 1000.0), 2s);
    EXPECT_NEAR(position(), rest + 1000.0, 20.0);
}

TEST(SupermodifiedControl, EveryKindOfMoveInEveryDialect)
{
    for (const std::string dialect : {"D1", "D2", "D3"}) {
        Bench bench;
        Simulator &node = bench.add("supermodified:4,dialect=" + dialect);
        const auto device = bench.connect(4);
        EXPECT_EQ(device->identity().dialect, dialect);
        const double scale = dialect == "D3" ? 8.0 : 1.0;
        const auto order = [&](SetPoint wanted, Duration time) {
            ASSERT_TRUE(device->command(wanted)) << dialect;
            bench.clock.advance(time);
        };
        order(setPoint(Mode::Position, 1000.0 * scale), 1s);
        EXPECT_NEAR(node.position(), 1000.0 * scale, 30.0 * scale) << dialect;
        SetPoint ramp = setPoint(Mode::RampPosition, 3000.0 * scale);
        ramp.velocity = 2000.0 * scale;
        ramp.acceleration = 4000.0 * scale;
        order(ramp, 500ms);
        EXPECT_GT(node.speed(), 300.0 * scale) << dialect;
        EXPECT_LT(node.speed(), 2300.0 * scale) << dialect;
        bench.clock.advance(2s);
        EXPECT_NEAR(node.position(), 3000.0 * scale, 30.0 * scale) << dialect;
        SetPoint back = setPoint(Mode::RampPosition, -1000.0 * scale);
        back.relative = true;
        order(back, 3s);
        EXPECT_NEAR(node.position(), 2000.0 * scale, 40.0 * scale) << dialect;
        order(setPoint(Mode::Velocity, -1500.0 * scale), 1s);
        EXPECT_NEAR(node.speed(), -1500.0 * scale * (dialect == "D3" ? 1.0 : 0.897), 150.0 * scale) << dialect;
        SetPoint hold = setPoint(Mode::Position, 0.0);
        hold.relative = true;
        bench.sent.clear();
        order(hold, 500ms);
        EXPECT_EQ(bench.count(Command::Halt), 1) << dialect;
        EXPECT_NEAR(node.speed(), 0.0, 30.0 * scale) << dialect;
        order(setPoint(Mode::RampVelocity, 1000.0 * scale), 2s);
        EXPECT_GT(node.speed(), 700.0 * scale) << dialect;
        device->stop();
        bench.clock.advance(500ms);
        EXPECT_FALSE(node.isOutputOn());
    }
}

TEST(SupermodifiedControl, FourNodesWithBufferedMovesStartTogether)
{
    Bench bench;
    std::vector<Simulator *> nodes;
    std::vector<std::unique_ptr<Device>> devices;
    for (int id = 4; id <= 7; ++id) {
        nodes.push_back(
            &bench.add("supermodified:" + std::to_string(id) + (id % 2 == 0 ? ",dialect=D1" : ",dialect=D2")));
        devices.push_back(bench.connect(id));
    }
    for (const auto &device : devices) {
        SetPoint move = setPoint(Mode::Position, 1000.0);
        move.buffered = true;
        ASSERT_TRUE(device->command(move));
    }
    bench.clock.advance(500ms);
    for (Simulator *node : nodes) {
        EXPECT_TRUE(node->isOutputOn()) << "holds its place";
        EXPECT_NEAR(node->position(), 0.0, 5.0);
    }
    bench.sent.clear();
    ASSERT_TRUE(devices.front()->releaseMoves());
    std::vector<Instant> begun(nodes.size());
    for (int i = 0; i < 400; ++i) {
        bench.clock.advance(100us);
        for (std::size_t n = 0; n < nodes.size(); ++n) {
            if (begun[n] == Instant{} && nodes[n]->position() > 20.0)
                begun[n] = bench.clock.now();
        }
    }
    EXPECT_EQ(bench.count(Command::DoMove), 5) << "to all, then to each";
    const auto [first, last] = std::minmax_element(begun.begin(), begun.end());
    EXPECT_NE(*first, Instant{});
    EXPECT_LE(*last - *first, 3ms) << "one loop of a node is 1.024 ms";
    bench.clock.advance(1s);
    for (Simulator *node : nodes)
        EXPECT_NEAR(node->position(), 1000.0, 20.0);
    for (const auto &device : devices)
        device->stop();
    bench.clock.advance(100ms);
    for (Simulator *node : nodes)
        EXPECT_FALSE(node->isOutputOn());
}

TEST_F(SupermodifiedNode, AStalledMotorEndsTheStreamAndIsNotStartedAgainByItself)
{
    bench.clock.advance(200ms);
    SetPointStream stream(*device, bench.clock);
    ASSERT_TRUE(stream.start(setPoint(Mode::Position, 2000.0), 60s));
    node.disturb("stall", 1);
    bench.clock.advance(4s);
    EXPECT_FALSE(stream.isRunning());
    EXPECT_EQ(stream.end(), SetPointStream::End::Refused);
    EXPECT_NE(stream.reason().english().find("stalled"), std::string::npos) << stream.reason();
    EXPECT_FALSE(node.isOutputOn());
    EXPECT_EQ(device->liveness().faults, std::vector<std::string>{"motor_stalled"});
    node.disturb("stall", 0);
    bench.clock.advance(2s);
    EXPECT_FALSE(node.isOutputOn());
}

TEST_F(SupermodifiedNode, ANodeThatLostItsSupplyWhileDrivenEndsTheStream)
{
    bench.clock.advance(200ms);
    SetPointStream stream(*device, bench.clock);
    ASSERT_TRUE(stream.start(setPoint(Mode::Velocity, 2000.0), 60s));
    bench.clock.advance(500ms);
    node.setPowered(false);
    bench.clock.advance(80ms);
    node.setPowered(true);
    bench.clock.advance(500ms);
    EXPECT_FALSE(stream.isRunning());
    EXPECT_FALSE(node.isOutputOn());
}

TEST_F(SupermodifiedNode, CountsThatAreGoneAfterASilenceAreNoRestartWhereTheNodeWasToldToGoThere)
{
    bench.clock.advance(200ms);
    SetPointStream stream(*device, bench.clock);
    ASSERT_TRUE(stream.start(setPoint(Mode::Position, 0.0), 600s));
    int gone = 0;
    for (double target = 20.0; target <= 200.0; target += 10.0) {
        ASSERT_TRUE(stream.update(setPoint(Mode::Position, target)));
        bench.clock.advance(800ms);
        const double before = position();
        ASSERT_TRUE(stream.update(setPoint(Mode::Position, 0.0)));
        bench.clock.advance(8ms);
        bench.line.setLoss(1.0); // nobody sees it on its way
        bench.clock.advance(60ms);
        bench.line.setLoss(0.0);
        bench.clock.advance(400ms);
        gone += before != 0.0 && position() == 0.0 ? 1 : 0;
        ASSERT_TRUE(stream.isRunning()) << target << ": " << stream.reason();
        EXPECT_FALSE(device->liveness().restarted) << target;
    }
    EXPECT_GT(gone, 0);
}

TEST_F(SupermodifiedNode, ANodeThatLostItsSupplySaysThatItIsNotStartedWhereItsCountsDoNotTell)
{
    bench.clock.advance(200ms);
    SetPointStream stream(*device, bench.clock);
    ASSERT_TRUE(stream.start(setPoint(Mode::Position, 200.0), 60s));
    bench.clock.advance(1s);
    ASSERT_GT(node.position(), 100.0);
    node.setPowered(false);
    bench.clock.advance(60ms);
    node.setPowered(true);
    bench.clock.advance(500ms);
    EXPECT_FALSE(stream.isRunning());
    EXPECT_NE(stream.reason().english().find("not started"), std::string::npos) << stream.reason();
}

TEST_F(SupermodifiedNode, RefusesWhatTheNodeCannotDoWithoutSendingAnything)
{
    bench.clock.advance(100ms);
    (void)run(bench.clock, device->read(Bench::index("gain.p")));
    bench.sent.clear();
    EXPECT_EQ(device->command(setPoint(Mode::Velocity, 40000.0)).error().fault, Fault::OutOfRange) << "16 bits";
    EXPECT_EQ(device->command(setPoint(Mode::Duty, 0.1)).error().fault, Fault::Unsupported);
    EXPECT_EQ(device->command(setPoint(Mode::Position, 1e10)).error().fault, Fault::OutOfRange);
    EXPECT_EQ(device->command(setPoint(Mode::Position, 2.2e6)).error().fault, Fault::OutOfRange) << "P·e overflows";
    EXPECT_TRUE(device->check(setPoint(Mode::RampPosition, 2.2e6))) << "a profile is short steps";
    SetPoint fast = setPoint(Mode::RampPosition, 100.0);
    fast.velocity = 50000.0;
    EXPECT_EQ(device->command(fast).error().fault, Fault::OutOfRange);
    for (const Frame &frame : bench.framesSent())
        EXPECT_TRUE(isGet(frame.command));
}

TEST_F(SupermodifiedNode, AnotherMasterIsHeardAndLocksControl)
{
    VirtualSerialLink other(*LinkAddress::parse("sim:serial"), bench.line);
    ASSERT_TRUE(other.open());
    ASSERT_TRUE(other.setBaudrate(57600));
    bench.clock.advance(99ms); // between two questions of our own
    ASSERT_TRUE(bench.clock.runUntil([&] { return device->liveness().heard; }, 1s));
    for (int i = 0; i < 40 && !device->liveness().foreignMaster; ++i) {
        ASSERT_TRUE(other.send(test::bytesOf("55 AA 04 02 1A 00 1A")));
        bench.clock.advance(7300us);
    }
    EXPECT_TRUE(device->liveness().foreignMaster);
    EXPECT_EQ(device->mayMove().error().fault, Fault::Unsafe);
    bench.clock.advance(1s);
    EXPECT_TRUE(device->mayMove());
}

TEST_F(SupermodifiedNode, WhatAnotherMasterTellsAnotherNodeIsNoReasonToDoubtThisOne)
{
    VirtualSerialLink other(*LinkAddress::parse("sim:serial"), bench.line);
    ASSERT_TRUE(other.open());
    ASSERT_TRUE(other.setBaudrate(57600));
    bench.clock.advance(99ms);
    const auto toldAnywhere = [&](std::string_view frame) {
        bool doubted = false;
        for (int i = 0; i < 40 && !doubted; ++i) {
            EXPECT_TRUE(other.send(test::bytesOf(frame)));
            bench.clock.advance(7300us);
            doubted = device->liveness().foreignMaster;
        }
        return doubted;
    };
    EXPECT_FALSE(toldAnywhere("55 AA 05 02 1A 00 1A")) << "for node 5";
    EXPECT_TRUE(toldAnywhere("55 AA 00 02 1A 00 1A")) << "for everybody";
}

TEST_F(SupermodifiedNode, SetPointsBeforeAndBehindAStopAreNoOneLine)
{
    order(setPoint(Mode::Velocity, 500.0), 200ms);
    device->stop();
    bench.clock.advance(500ms);
    order(setPoint(Mode::Velocity, 600.0), 200ms);
    device->telemetry()->commit();
    const ChannelIndex channel = *device->telemetry()->find("setpoint");
    ASSERT_EQ(device->telemetry()->size(channel), 2U);
    EXPECT_EQ(device->telemetry()->gaps(channel, Instant{}, bench.clock.now()).size(), 1U);
    EXPECT_EQ(device->telemetry()->lost(channel), 0U);
    device->stop();
}

TEST(SupermodifiedControl, ALineIsNotDrivenAnyMoreByADeviceThatIsGone)
{
    Bench bench;
    bench.add("supermodified:4");
    bench.add("supermodified:5");
    std::unique_ptr<Device> driven = bench.connect(4);
    const std::unique_ptr<Device> other = bench.connect(5);
    EXPECT_FALSE(static_cast<Controller &>(*other).isLineDriving());
    ASSERT_TRUE(driven->command(setPoint(Mode::Velocity, 500.0)));
    bench.clock.advance(300ms);
    EXPECT_TRUE(static_cast<Controller &>(*other).isLineDriving()) << "no update now";
    driven.reset();
    EXPECT_FALSE(static_cast<Controller &>(*other).isLineDriving());
}

TEST(SupermodifiedControl, ASampleThatIsLostIsCountedOnItsOwnChannelsOnly)
{
    // What one poll asks for, by the place of its channels in the table.
    const std::vector<std::vector<std::uint16_t>> polls{{0, 1}, {2}, {4}, {5}, {6, 7, 8, 9}, {10}};
    int seen = 0;
    for (int frame = 40; frame < 70; ++frame) {
        Bench bench;
        bench.add("supermodified:4,dialect=D1,fault=drop@" + std::to_string(frame));
        const std::unique_ptr<Device> device = bench.connect(4);
        bench.clock.advance(4s);
        device->telemetry()->commit();
        std::vector<std::uint16_t> losing;
        for (std::uint16_t i = 0; i < device->family().channels.size(); ++i) {
            const std::uint64_t lost = device->telemetry()->lost({i});
            EXPECT_LE(lost, 1U) << "channel " << i << ", frame " << frame;
            if (lost > 0)
                losing.push_back(i);
        }
        EXPECT_TRUE(losing.empty() || std::find(polls.begin(), polls.end(), losing) != polls.end())
            << "frame " << frame << ", first channel " << losing.front() << " of " << losing.size();
        seen += losing.empty() ? 0 : 1;
    }
    EXPECT_GT(seen, 15) << "a lost answer to a poll is a lost sample";
}

TEST(SupermodifiedControl, CurrentIsACountUntilTheUserSaysWhatItIsWorth)
{
    Bench bench;
    bench.add("supermodified:4,dialect=D1");
    bench.add("supermodified:5,dialect=D3");
    const auto raw = bench.connect(4);
    const auto known = bench.connect(5);
    const auto current = *raw->telemetry()->find("current");
    EXPECT_EQ(raw->telemetry()->channels()[current.value].unit, "counts");
    EXPECT_EQ(known->telemetry()->channels()[current.value].unit, "A");
    SetPoint fast = setPoint(Mode::Velocity, 8000.0);
    ASSERT_TRUE(raw->command(fast));
    bench.clock.advance(2s);
    const double counts = raw->telemetry()->latest(current)->value;
    EXPECT_GT(counts, 5.0);
    ASSERT_TRUE(raw->knowledge().calibrate("amperes_per_count", 0.01));
    EXPECT_EQ(raw->telemetry()->channels()[current.value].unit, "A");
    bench.clock.advance(200ms);
    EXPECT_NEAR(raw->telemetry()->latest(current)->value, counts * 0.01, 0.5 * counts * 0.01);
}

TEST_F(SupermodifiedNode, ItsStopScriptStopsARunningNode)
{
    order(setPoint(Mode::Velocity, 2000.0), 300ms);
    node.disturb("error", 0x43);
    const StopScript script = device->stopScript();
    ASSERT_EQ(script.steps.size(), 4U);
    EXPECT_TRUE(script.steps.front().bytes.empty()) << "an answer may be under way";
    const StopStep &step = script.steps.back();
    EXPECT_EQ(step.reply, test::bytesOf("55 AA 77 04 1B 00 1B"));
    int attempts = 0;
    for (bool proved = false; !proved && attempts < step.attempts; ++attempts) {
        bench.heard.clear();
        ASSERT_TRUE(bench.host.send(step.bytes));
        bench.clock.advance(step.wait);
        proved = std::search(bench.heard.begin(), bench.heard.end(), step.reply.begin(), step.reply.end())
            != bench.heard.end();
    }
    EXPECT_LE(attempts, 3);
    EXPECT_FALSE(node.isOutputOn());
}

TEST(SupermodifiedPower, ANodeWhoseFirstAnswersAreLostHasNotLostItsSupply)
{
    for (int missed = 1; missed <= 30; ++missed) { // it stands at 0, and was never seen anywhere else
        Bench bench;
        bench.add("supermodified:4");
        const auto device = bench.connect(4);
        bench.line.setLoss(1.0);
        bench.clock.advance(10ms * missed);
        bench.line.setLoss(0.0);
        bench.clock.advance(500ms);
        EXPECT_TRUE(device->liveness().heard);
        EXPECT_FALSE(device->liveness().restarted) << missed;
    }
}

} // namespace
} // namespace mb::supermodified
