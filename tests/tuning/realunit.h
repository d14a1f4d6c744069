// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiment/gains.h"
#include "experiment/owedgains.h"
#include "model/family.h"
#include "model/unit.h"
#include "support/datedclock.h"
#include "support/fakejournal.h"
#include "support/simulatedsession.h"
#include "transport/backends/virtualcan.h"

namespace mb::dmc60c {
extern const Family family;
}

namespace mb::test {

using namespace std::chrono_literals;
using tuning::OwedValue;

/// A DMC60C on a CAN interface, which counts as a real one, in virtual time: what stalls the clock holds this program up.
struct RealUnit {
    RealUnit()
        : bus(clock, 1'000'000, 1)
        , host(*LinkAddress::parse("socketcan:can0"), bus)
        , port(*LinkAddress::parse("socketcan:can0"), bus)
    {
        struct Sink final : ScanSink {
            void found(const Identity &identity) override { last = identity; }
            void progress(const Message &, int, int) override { }
            std::optional<Identity> last;
        } sink;
        EXPECT_TRUE(host.open());
        EXPECT_TRUE(port.open());
        simulator = std::move(*dmc60c::family.simulate(port, clock, *SimulatedUnit::parse("dmc60c:5")));
        clock.advance(30s);
        EXPECT_TRUE(run(clock, dmc60c::family.scan(host, clock, sink)));
        device = dmc60c::family.open(host, dated, *sink.last);
        clock.advance(1s);
        journal.clock = &dated;
        gain = *findParameter(dmc60c::family.parameters, "slot0.p");
        before = run(clock, device->read(gain)).value_or(-1);
    }
    /// A trial has tried half of the gain, and puts it back `later`.
    void tryAndPutBack(Duration later)
    {
        const std::vector<OwedValue> owed{{"slot0.p", before, before / 2}};
        ASSERT_TRUE(run(clock, journal.begin({})));
        ASSERT_TRUE(run(clock, journal.owe(1, unitKeyOf(*device), owed)));
        ASSERT_TRUE(run(clock, tuning::writeGains(*device, {{gain, before / 2}})));
        clock.advance(later);
        ASSERT_TRUE(run(clock, tuning::payOwed(*device, journal, {1, 0.0, owed})));
        ASSERT_EQ(*run(clock, device->read(gain)), before);
    }
    /// The gains that somebody has to be asked about.
    [[nodiscard]] std::size_t askedAbout()
    {
        const auto owed = run(clock, tuning::lookForOwed(*device, journal));
        EXPECT_TRUE(owed);
        return owed ? owed->size() : 0;
    }
    void losePower()
    {
        simulator->setPowered(false);
        clock.advance(1s);
        simulator->setPowered(true);
        clock.advance(3s);
        EXPECT_TRUE(run(clock, device->refresh()));
    }

    VirtualClock clock;
    test::DatedClock dated{clock};
    VirtualCanBus bus;
    VirtualCanLink host;
    VirtualCanLink port;
    std::unique_ptr<Simulator> simulator;
    std::unique_ptr<Device> device;
    test::FakeJournal journal;
    ParameterIndex gain;
    std::int64_t before = 0;
};

} // namespace mb::test
