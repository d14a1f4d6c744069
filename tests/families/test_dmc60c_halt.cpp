// SPDX-License-Identifier: GPL-3.0-or-later
// Out of the halt (dmc60c/README.md#stopping), and the restart on order. On virtual time, against the simulated controller.
#include "support/simulatedsession.h"
#include "transport/canlink.h"

#include <algorithm>

namespace mb {
namespace {

using namespace std::chrono_literals;
using test::run;

struct Dmc60cHalt : testing::Test {
    Dmc60cHalt()
    {
        bench.scan();
        device = bench.device(5);
        bench.clock.advance(500ms);
        events = bench.simulator("dmc60c:5")->events().add([this](const SimulatorEvent &e) { log.push_back(e.what); });
    }
    [[nodiscard]] double latest(std::string_view key) const
    {
        const auto point = device->telemetry()->latest(*findChannel(device->family().channels, key));
        return point ? point->value : -1e9;
    }
    static SetPoint position(double target)
    {
        SetPoint made;
        made.mode = Mode::Position;
        made.target = target;
        made.slot = 1; // whose stored gains are for positions
        return made;
    }

    test::SimulatedSession bench;
    Device *device = nullptr;
    std::vector<std::string> log;
    Subscription events;
};

TEST_F(Dmc60cHalt, ATargetOfZeroIsReachedAlthoughZeroAloneEndsNoHalt)
{
    SetPointStream &stream = bench.session.stream(*device);
    for (int round = 0; round < 2; ++round) { // after the start of the device, and after a stop
        ASSERT_TRUE(run(bench.clock, device->write(bench.index(*device, "encoder.position"), 2000)));
        ASSERT_TRUE(stream.start(position(0.0), 60s));
        bench.clock.advance(3s);
        EXPECT_NEAR(latest("position"), 0.0, 60.0) << round;
        EXPECT_EQ(device->liveness().mode, Mode::Position) << round;
        stream.stop();
        bench.clock.advance(2s);
    }
}

TEST_F(Dmc60cHalt, WhatTakesItOutOfTheHaltMovesNothing)
{
    SetPoint still;
    still.mode = Mode::Duty;
    ASSERT_TRUE(bench.session.stream(*device).start(still, 60s));
    const double before = latest("position");
    bench.clock.advance(2s);
    EXPECT_EQ(latest("position"), before);
    EXPECT_EQ(latest("duty"), 0.0);
}

TEST_F(Dmc60cHalt, ARestartKeepsWhatWasJustWrittenAndEndsWhenTheUnitAnswers)
{
    const auto index = bench.index(*device, "limit.forward.soft.threshold");
    const auto other = bench.index(*device, "limit.reverse.soft.threshold");
    ASSERT_TRUE(run(bench.clock, device->write(index, 4711)));
    ASSERT_TRUE(run(bench.clock, device->write(other, -4711)));
    ASSERT_TRUE(run(bench.clock, device->restart()));
    EXPECT_EQ(std::count(log.begin(), log.end(), "reset"), 1);
    EXPECT_FALSE(device->liveness().restarted) << "it was read again";
    EXPECT_EQ(run(bench.clock, device->read(index)), 4711);
    EXPECT_EQ(run(bench.clock, device->read(other)), -4711);
}

TEST_F(Dmc60cHalt, ARestartStopsTheMotorAndIsRefusedDuringAnUpdate)
{
    SetPoint drive;
    drive.mode = Mode::Duty;
    drive.target = 0.2;
    SetPointStream &stream = bench.session.stream(*device);
    ASSERT_TRUE(stream.start(drive, 60s));
    bench.clock.advance(500ms);
    ASSERT_TRUE(run(bench.clock, device->restart()));
    EXPECT_FALSE(stream.isRunning());
    bench.clock.advance(1s);
    EXPECT_FALSE(bench.simulator("dmc60c:5")->isOutputOn());
    device->gate().setBusy(say("firmware update"));
    EXPECT_EQ(run(bench.clock, device->restart()).error().fault, Fault::Unsafe);
}

TEST(Dmc60cRestart, OfAUnitWithoutApplicationIsRefusedAtOnceAndTellsWhatHelps)
{
    test::SimulatedSession bench;
    bench.scan();
    const Instant begin = bench.clock.now();
    const auto restarted = run(bench.clock, bench.device(9)->restart());
    ASSERT_FALSE(restarted);
    EXPECT_EQ(restarted.error().fault, Fault::Refused);
    EXPECT_EQ(restarted.error().remedy, "update its firmware first");
    EXPECT_LT(bench.clock.now() - begin, 5s) << "3 s of them the unit may take";
}

TEST_F(Dmc60cHalt, ARestartEndsTheBootloaderOfAUnitThatHasAnApplication)
{
    auto &link = dynamic_cast<CanLink &>(device->link());
    ASSERT_TRUE(run(bench.clock, device->write(bench.index(*device, "limit.forward.soft.threshold"), 4711)));
    const auto session = static_cast<unsigned>(device->identity().session.value_or(0));
    const auto low = static_cast<std::uint8_t>(session & 0xFFU);
    const auto high = static_cast<std::uint8_t>(session >> 8U);
    ASSERT_TRUE(link.send(extendedFrame(0x0206FC05, {low, high, 0xF0, 0, 0, 0, 0, 0}))); // EnterBootloader
    bench.clock.advance(1s);
    ASSERT_EQ(device->identity().state, DeviceState::Bootloader);
    const Instant begin = bench.clock.now();
    ASSERT_TRUE(run(bench.clock, device->restart()));
    EXPECT_EQ(device->identity().state, DeviceState::Online);
    EXPECT_LT(bench.clock.now() - begin, 4s);
}

TEST_F(Dmc60cHalt, LimitsThatHoldAndAHaltAreTold)
{
    using Conditions = std::vector<std::string_view>;
    const auto conditions = [this] {
        Conditions clauses;
        for (const StateRow *row : conditionsOf(device->family().states, device->states()))
            clauses.push_back(row->clause);
        return clauses;
    };
    bench.clock.advance(200ms);
    EXPECT_EQ(conditions(), Conditions{"halted"});
    Simulator *unit = bench.simulator("dmc60c:5");
    unit->disturb("forward-limit", 1.0);
    SetPoint drive;
    drive.mode = Mode::Duty;
    drive.target = 0.2;
    SetPointStream &stream = bench.session.stream(*device);
    ASSERT_TRUE(stream.start(drive, 60s));
    bench.clock.advance(500ms);
    EXPECT_EQ(conditions(), Conditions{"forward limit switch holds"});
    drive.overrideLimits = true;
    drive.disableForwardLimit = true;
    ASSERT_TRUE(stream.update(drive));
    bench.clock.advance(500ms);
    EXPECT_EQ(conditions(), Conditions{"the set-point decides which limit switches count"})
        << "switched off by the frame";
    unit->disturb("forward-limit", 0.0);
    stream.stop();
    for (const auto &[key, raw] : {std::pair{"limit.reverse.soft.threshold", std::int64_t{1'000'000'000}},
             std::pair{"limit.reverse.soft.enabled", std::int64_t{1}}})
        ASSERT_TRUE(run(bench.clock, device->write(bench.index(*device, key), raw))) << key;
    bench.clock.advance(1s);
    EXPECT_EQ(conditions(), (Conditions{"reverse soft limit holds", "halted"}));
}

} // namespace
} // namespace mb
