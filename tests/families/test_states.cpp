// SPDX-License-Identifier: GPL-3.0-or-later
// What devices tell of themselves besides samples: limits, halts, pins, and the faults that no status frame carries.
#include "support/simulatedsession.h"

#include <algorithm>

namespace mb {
namespace {

using namespace std::chrono_literals;
using test::run;
using test::SimulatedSession;

std::optional<bool> stateOf(const Device &device, std::string_view key)
{
    const auto index = findState(device.family().states, key);
    EXPECT_TRUE(index) << key;
    return index ? device.states()[*index] : std::nullopt;
}

bool hasFault(const Device &device, std::string_view key)
{
    const auto &faults = device.liveness().faults;
    return std::find(faults.begin(), faults.end(), key) != faults.end();
}

/// A board tells its inputs only after somebody has asked for its status bits.
TEST(States, EveryRowIsToldSoonWhereFramesCarryItByThemselves)
{
    for (const char *address : {"sim:can", "sim:serial"}) {
        SimulatedSession bench(address);
        bench.scan();
        bench.clock.advance(2s);
        for (const Device *device : bench.session.devices()) {
            if (device->identity().state != DeviceState::Online)
                continue;
            for (const StateRow &row : device->family().states)
                EXPECT_TRUE(stateOf(*device, row.key)) << device->selector() << ' ' << row.key;
        }
    }
}

TEST(States, EncoderPinsFollowTheShaftAndAreToldWithoutFloodingTheWindow)
{
    SimulatedSession bench;
    bench.scan();
    Device *const device = bench.device(5);
    ASSERT_NE(device, nullptr);
    const auto velocity = findChannel(device->family().channels, "velocity");
    ASSERT_TRUE(run(bench.clock, device->setRate(*velocity, 500.0)));
    SetPoint drive;
    drive.mode = Mode::Duty;
    drive.target = 0.3;
    SetPointStream &stream = bench.session.stream(*device);
    ASSERT_TRUE(stream.start(drive, 60s));
    bench.clock.advance(100ms);
    int flips = 0;
    int told = 0;
    const auto pin = *findState(device->family().states, "input.encoder.a");
    bool last = device->states().isOn(pin);
    const Subscription changes = device->statesChanged().add([&](Instant) {
        flips += device->states().isOn(pin) != last ? 1 : 0;
        last = device->states().isOn(pin);
    });
    const Subscription changed = device->changed().add([&told] { ++told; });
    bench.clock.advance(2s);
    EXPECT_GT(flips, 100) << "of 1000 frames of a turning shaft";
    EXPECT_LE(told, 2 * 20 + 5) << "twenty times a second at most";
    EXPECT_GE(told, 20);
}

TEST(States, OverCurrentAndCommunicationFaultsAreToldAndNeverClearedByAsking)
{
    SimulatedSession bench;
    bench.scan();
    Device *const device = bench.device(5);
    ASSERT_NE(device, nullptr);
    EXPECT_FALSE(hasFault(*device, "over_current"));
    Simulator *const unit = bench.simulator("dmc60c:5");
    ASSERT_TRUE(unit->disturb("stall", 1.0) && unit->disturb("bus-voltage", 24.0));
    SetPoint drive;
    drive.mode = Mode::Duty;
    drive.target = 1.0;
    SetPointStream &stream = bench.session.stream(*device);
    ASSERT_TRUE(stream.start(drive, 60s));
    ASSERT_TRUE(bench.clock.runUntil([&] { return hasFault(*device, "over_current"); }, 5s));
    stream.stop();
    bench.clock.advance(5s);
    EXPECT_FALSE(hasFault(*device, "over_current")) << "it is over";
    const auto records = run(bench.clock, device->readFaults());
    ASSERT_TRUE(records);
    const auto over = std::find_if(
        records->begin(), records->end(), [](const FaultRecord &record) { return record.key == "over_current"; });
    ASSERT_NE(over, records->end());
    EXPECT_TRUE(over->sticky) << "asking for the present ones cleared nothing";
    EXPECT_GE(over->count.value_or(0), 1);
}

TEST(States, DigitalInputsOfANodeFollowTheirPins)
{
    SimulatedSession bench("sim:serial");
    bench.scan();
    Device *const device = bench.device(4, "supermodified");
    ASSERT_NE(device, nullptr);
    bench.clock.advance(2s);
    EXPECT_EQ(stateOf(*device, "input.2"), true) << "a pull-up";
    ASSERT_TRUE(bench.simulator("supermodified:4")->disturb("input2", 0.0));
    bench.clock.advance(2s);
    EXPECT_EQ(stateOf(*device, "input.2"), false);
    EXPECT_EQ(stateOf(*device, "input.1"), true);
}

TEST(States, TheInputOfAnAxisIsItsStatusBit)
{
    SimulatedSession bench("sim:spi");
    bench.scan();
    Device *const device = bench.devices("quadquad2drv").front();
    bench.clock.advance(1s);
    EXPECT_EQ(stateOf(*device, "ch2.input"), std::nullopt) << "nobody has asked for status bits";
    ASSERT_TRUE(run(bench.clock, device->write(bench.index(*device, "ch2.input.mode"), 1)));
    bench.clock.advance(1s);
    const bool before = stateOf(*device, "ch2.input").value();
    ASSERT_TRUE(bench.simulator("quadquad2drv:0")->disturb("input2", 0.0));
    bench.clock.advance(1s);
    EXPECT_EQ(stateOf(*device, "ch2.input"), !before);
    EXPECT_EQ(stateOf(*device, "ch1.input"), false);
}

} // namespace
} // namespace mb
