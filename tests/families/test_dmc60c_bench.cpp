// SPDX-License-Identifier: GPL-3.0-or-later
// The host's half against the simulator: two implementations that share protocol.h and nothing else.
#include "async/virtualclock.h"
#include "model/family.h"
#include "model/parametertransfer.h"
#include "transport/backends/virtualcan.h"

#include <gtest/gtest.h>

namespace mb::dmc60c {
extern const Family family;

namespace {

using namespace std::chrono_literals;

struct Found final : ScanSink {
    void found(const Identity &identity) override
    {
        for (Identity &known : list) {
            if (known.address == identity.address && known.session == identity.session) {
                known = identity;
                return;
            }
        }
        list.push_back(identity);
    }
    void progress(const Message &, int, int) override { }
    std::vector<Identity> list;
};

class Dmc60cBench : public testing::Test {
protected:
    Dmc60cBench()
        : bus(clock, 1'000'000, 1)
        , host(*LinkAddress::parse("sim:can"), bus)
    {
        EXPECT_TRUE(host.open());
    }
    Simulator &add(std::string_view text)
    {
        auto &link = *links.emplace_back(std::make_unique<VirtualCanLink>(*LinkAddress::parse("sim:can"), bus));
        EXPECT_TRUE(link.open());
        auto unit = SimulatedUnit::parse(text);
        EXPECT_TRUE(unit);
        auto simulator = family.simulate(link, clock, *unit);
        EXPECT_TRUE(simulator) << (simulator ? "" : simulator.error().text());
        return *simulators.emplace_back(std::move(*simulator));
    }
    template <class T> Result<T> run(Task<T> task, Duration limit = 60s)
    {
        task.start();
        EXPECT_TRUE(clock.runUntil([&] { return task.isFinished(); }, limit));
        if (!task.isFinished())
            return fail(Fault::Timeout, say("the task hangs"));
        return std::move(task.result());
    }
    Identity scanFor(int address)
    {
        Found sink;
        EXPECT_TRUE(run(family.scan(host, clock, sink)));
        for (const Identity &identity : sink.list) {
            if (identity.address == address)
                return identity;
        }
        ADD_FAILURE() << "not found";
        return {};
    }

    VirtualClock clock;
    VirtualCanBus bus;
    VirtualCanLink host;
    std::vector<std::unique_ptr<VirtualCanLink>> links;
    std::vector<std::unique_ptr<Simulator>> simulators;
};

TEST_F(Dmc60cBench, FindsTheDemoBenchWithinHalfASecond)
{
    for (const std::string_view text : family.bench)
        add(text);
    Found sink;
    const Instant begun = clock.now();
    ASSERT_TRUE(run(family.scan(host, clock, sink)));
    EXPECT_LE(clock.now() - begun, 500ms);
    ASSERT_EQ(sink.list.size(), 3U);
    EXPECT_EQ(sink.list[0].address, 5);
    EXPECT_EQ(sink.list[0].state, DeviceState::Online);
    EXPECT_FALSE(sink.list[0].name.empty());
    EXPECT_EQ(sink.list[0].serial.size(), 12U);
    EXPECT_EQ(sink.list[2].state, DeviceState::Bootloader);
    EXPECT_FALSE(sink.list[2].serial.empty());
}

TEST_F(Dmc60cBench, ReadsAll55ParametersInATenthOfASecond)
{
    add("dmc60c:5");
    const auto device = family.open(host, clock, scanFor(5));
    NoProgress progress;
    const Instant begun = clock.now();
    const auto outcomes = run(readParameters(*device, readable(*device), progress));
    EXPECT_LE(clock.now() - begun, 100ms);
    ASSERT_TRUE(outcomes);
    ASSERT_EQ(outcomes->size(), 55U);
    for (const TransferOutcome &outcome : *outcomes)
        EXPECT_TRUE(outcome.raw) << outcome.raw.error().text();
}

TEST_F(Dmc60cBench, ReadsAndWritesEverythingAtTenPercentLoss)
{
    add("dmc60c:5");
    const auto device = family.open(host, clock, scanFor(5));
    bus.setLoss(0.1);
    NoProgress progress;
    const auto outcomes = run(readParameters(*device, readable(*device), progress));
    ASSERT_TRUE(outcomes);
    std::vector<ParameterChange> changes;
    for (const TransferOutcome &outcome : *outcomes) {
        ASSERT_TRUE(outcome.raw) << outcome.raw.error().text();
        const Parameter &p = device->parameters().parameter(outcome.index);
        if (p.access == Access::ReadWrite && p.nature == Nature::Setting)
            changes.push_back(
                {outcome.index, *outcome.raw == *toRaw(p, p.maximum) ? *outcome.raw - 1 : *outcome.raw + 1});
    }
    const auto written = run(writeParameters(*device, changes, progress));
    ASSERT_TRUE(written);
    ASSERT_EQ(written->size(), changes.size()) << written->back().raw.error().text();
    for (const TransferOutcome &outcome : *written)
        EXPECT_EQ(outcome.verified, true);
}

TEST_F(Dmc60cBench, ProvesThatAChangeIsInFlashAndThatItSurvivesThePower)
{
    Simulator &unit = add("dmc60c:5");
    const auto device = family.open(host, clock, scanFor(5));
    const ParameterIndex p = *findParameter(family.parameters, "slot0.p");
    const ParameterIndex i = *findParameter(family.parameters, "slot0.i");
    ASSERT_TRUE(run(device->write(p, 123456)));
    ASSERT_TRUE(run(device->write(i, 4321)));
    EXPECT_EQ(device->parameters().entry(p).state, ParameterState::Ram);
    const Instant begun = clock.now();
    NoProgress progress;
    const auto stored = run(device->store(progress));
    ASSERT_TRUE(stored) << stored.error().text();
    EXPECT_TRUE(*stored);
    EXPECT_GT(clock.now() - begun, 14s) << "the second change is written 15 s later";
    EXPECT_LE(clock.now() - begun, 20s);
    EXPECT_EQ(device->parameters().entry(p).state, ParameterState::Stored);
    unit.setPowered(false);
    clock.advance(1s);
    EXPECT_FALSE(device->liveness().heard);
    unit.setPowered(true);
    clock.advance(3s);
    EXPECT_TRUE(device->liveness().heard);
    EXPECT_TRUE(device->liveness().restarted) << "a new session after the power cycle";
    EXPECT_EQ(*run(device->read(p)), 123456);
    EXPECT_EQ(*run(device->read(i)), 4321);
    ASSERT_TRUE(run(device->refresh()));
    EXPECT_FALSE(device->liveness().restarted);
}

TEST_F(Dmc60cBench, DrivesAndIsSeenStopped)
{
    Simulator &unit = add("dmc60c:5");
    const auto device = family.open(host, clock, scanFor(5));
    SetPoint setPoint;
    setPoint.mode = Mode::Duty;
    setPoint.target = 0.5;
    for (int n = 0; n < 25; ++n) {
        ASSERT_TRUE(device->command(setPoint));
        clock.advance(20ms);
    }
    EXPECT_TRUE(unit.isOutputOn());
    EXPECT_GT(unit.speed(), 100.0);
    EXPECT_TRUE(device->liveness().moving);
    EXPECT_EQ(device->liveness().mode, Mode::Duty);
    EXPECT_GT(device->telemetry()->latest(*findChannel(family.channels, "velocity"))->value, 100.0);
    EXPECT_FALSE(device->isSeenStopped());
    device->stop();
    EXPECT_FALSE(device->isSeenStopped());
    clock.advance(50ms);
    EXPECT_FALSE(unit.isOutputOn());
    EXPECT_TRUE(device->isSeenStopped());
}

TEST_F(Dmc60cBench, TakesTheLongestNameWholeAndNotOneCharacterMore)
{
    add("dmc60c:5");
    const auto device = family.open(host, clock, scanFor(5));
    const std::string longest = std::string(63, 'n') + '!';
    ASSERT_TRUE(run(device->rename(longest)));
    EXPECT_EQ(scanFor(5).name, longest);
    EXPECT_EQ(run(device->rename(longest + '!')).error().fault, Fault::OutOfRange);
    EXPECT_EQ(scanFor(5).name, longest);
}

TEST_F(Dmc60cBench, RenamesRenumbersAndBlinks)
{
    add("dmc60c:5");
    add("dmc60c:7");
    const auto device = family.open(host, clock, scanFor(5));
    EXPECT_TRUE(run(device->identify()));
    ASSERT_TRUE(run(device->rename("Gripper M\xC3\xBC")));
    EXPECT_EQ(device->identity().name, "Gripper M\xC3\xBC");
    const auto taken = run(device->renumber(7));
    ASSERT_FALSE(taken);
    EXPECT_EQ(taken.error().fault, Fault::Refused);
    ASSERT_TRUE(run(device->renumber(12)));
    EXPECT_EQ(device->identity().address, 12);
    clock.advance(100ms);
    EXPECT_TRUE(device->liveness().heard) << "telemetry follows the number";
    EXPECT_EQ(scanFor(12).name, "Gripper M\xC3\xBC");
}

TEST_F(Dmc60cBench, CountsEveryStatusFrameThatTheBusLost)
{
    add("dmc60c:5");
    const auto device = family.open(host, clock, scanFor(5));
    clock.advance(1s);
    const ChannelIndex duty = *findChannel(family.channels, "duty");
    const ChannelIndex position = *findChannel(family.channels, "position");
    const auto total = [&](ChannelIndex channel) {
        device->telemetry()->commit();
        return device->telemetry()->size(channel) + device->telemetry()->lost(channel);
    };
    const std::size_t dutyBefore = total(duty);
    const std::size_t positionBefore = total(position);
    bus.setLoss(0.1);
    clock.advance(60s);
    bus.setLoss(0.0);
    clock.advance(500ms);
    EXPECT_NEAR(static_cast<double>(total(duty) - dutyBefore), 6050.0, 2.0);
    EXPECT_NEAR(static_cast<double>(total(position) - positionBefore), 605.0, 2.0);
    EXPECT_NEAR(static_cast<double>(device->telemetry()->lost(duty)), 600.0, 80.0);
}

TEST_F(Dmc60cBench, ResolvesADuplicateThroughItsSession)
{
    add("dmc60c:5,fault=duplicate");
    Found sink;
    ASSERT_TRUE(run(family.scan(host, clock, sink)));
    ASSERT_EQ(sink.list.size(), 2U);
    EXPECT_EQ(sink.list[0].state, DeviceState::Duplicate);
    EXPECT_EQ(sink.list[1].state, DeviceState::Duplicate);
    EXPECT_NE(sink.list[0].serial, sink.list[1].serial);
    const auto device = family.open(host, clock, sink.list[1]);
    EXPECT_FALSE(device->mayMove());
    ASSERT_TRUE(run(device->renumber(6)));
    EXPECT_EQ(device->identity().state, DeviceState::Online);
    Found after;
    ASSERT_TRUE(run(family.scan(host, clock, after)));
    ASSERT_EQ(after.list.size(), 2U);
    for (const Identity &identity : after.list) {
        EXPECT_EQ(identity.state, DeviceState::Online);
        EXPECT_EQ(identity.serial, sink.list[identity.address == 6 ? 1 : 0].serial);
    }
}

TEST_F(Dmc60cBench, AssignsANumberToAUnitWithoutOne)
{
    add("dmc60c:0");
    const auto device = family.open(host, clock, scanFor(0));
    EXPECT_EQ(device->identity().state, DeviceState::Unassigned);
    ASSERT_TRUE(run(device->renumber(8)));
    EXPECT_EQ(scanFor(8).state, DeviceState::Online);
}

TEST_F(Dmc60cBench, RenamesAndRenumbersAtTenPercentLoss)
{
    add("dmc60c:5");
    const auto device = family.open(host, clock, scanFor(5));
    bus.setLoss(0.1);
    for (int number = 10; number < 30; ++number) {
        const auto moved = run(device->renumber(number));
        ASSERT_TRUE(moved) << moved.error().text();
    }
    EXPECT_TRUE(run(device->rename("Twenty moves")));
}

TEST_F(Dmc60cBench, RaisesRatesAndAsksForThemAgainAfterARestart)
{
    Simulator &unit = add("dmc60c:5");
    const auto device = family.open(host, clock, scanFor(5));
    const ChannelIndex position = *findChannel(family.channels, "position");
    const auto samplesIn = [&](Duration time) {
        device->telemetry()->commit();
        const std::size_t before = device->telemetry()->size(position);
        clock.advance(time);
        device->telemetry()->commit();
        return static_cast<double>(device->telemetry()->size(position) - before);
    };
    EXPECT_NEAR(samplesIn(1s), 10.0, 1.0);
    ASSERT_TRUE(run(device->setRate(position, 200.0)));
    EXPECT_NEAR(samplesIn(1s), 200.0, 1.0);
    unit.setPowered(false);
    clock.advance(500ms);
    unit.setPowered(true);
    clock.advance(3s);
    EXPECT_TRUE(device->liveness().restarted);
    EXPECT_NEAR(samplesIn(1s), 200.0, 1.0) << "the device itself starts with 10 a second";
    ASSERT_TRUE(run(device->setRate(position, 0.0)));
    EXPECT_NEAR(samplesIn(1s), 10.0, 1.0);
    EXPECT_EQ(device->telemetry()->lost(position), 0U);
}

TEST_F(Dmc60cBench, ALostSupplyThatLooksLikeLostFramesIsFoundOut)
{
    Simulator &unit = add("dmc60c:5");
    const auto device = family.open(host, clock, scanFor(5));
    clock.advance(500ms);
    const auto session = device->identity().session;
    unit.setPowered(false);
    unit.setPowered(true); // 40 ms to its application: shorter than what counts as silence
    clock.advance(1s);
    EXPECT_NE(device->identity().session, session);
    EXPECT_TRUE(device->liveness().restarted) << "its position began anew";
}

TEST_F(Dmc60cBench, FramesThatAreLostAreNoRestart)
{
    add("dmc60c:5");
    const auto device = family.open(host, clock, scanFor(5));
    clock.advance(500ms);
    bus.setLoss(0.3);
    clock.advance(20s);
    EXPECT_FALSE(device->liveness().restarted);
    EXPECT_EQ(device->identity().state, DeviceState::Online);
}

TEST_F(Dmc60cBench, KeepsTheCountsOfClearedFaultsAtThirtyPercentLoss)
{
    Simulator &unit = add("dmc60c:5");
    const auto device = family.open(host, clock, scanFor(5));
    ASSERT_TRUE(unit.disturb("gate-fault", 1.0));
    clock.advance(100ms);
    ASSERT_TRUE(unit.disturb("gate-fault", 0.0));
    clock.advance(5s);
    const auto before = run(device->readFaults());
    ASSERT_TRUE(before);
    ASSERT_TRUE(before->at(3).sticky);
    bus.setLoss(0.3);
    const auto cleared = run(device->clearFaults());
    bus.setLoss(0.0);
    ASSERT_TRUE(cleared) << cleared.error().text();
    EXPECT_EQ(cleared->at(3).count, before->at(3).count);
    EXPECT_TRUE(cleared->at(3).sticky);
    const auto after = run(device->readFaults());
    ASSERT_TRUE(after);
    EXPECT_EQ(after->at(3).count, 0);
    EXPECT_FALSE(after->at(3).sticky);
}

} // namespace
} // namespace mb::dmc60c
