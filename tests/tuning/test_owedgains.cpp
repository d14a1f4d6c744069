// SPDX-License-Identifier: GPL-3.0-or-later
// What an experiment owes to a real unit that stores by itself, later: a DMC60C on a CAN interface, in virtual time.
#include "experiment/gains.h"
#include "experiment/owedgains.h"
#include "experiment/verdict.h"
#include "model/family.h"
#include "model/unit.h"
#include "support/datedclock.h"
#include "support/fakejournal.h"
#include "support/simulatedsession.h"
#include "transport/backends/virtualcan.h"

namespace mb::dmc60c {
extern const Family family;
}

namespace mb::tuning {
namespace {

using namespace std::chrono_literals;
using test::run;

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
        ASSERT_TRUE(run(clock, writeGains(*device, {{gain, before / 2}})));
        clock.advance(later);
        ASSERT_TRUE(run(clock, payOwed(*device, journal, {1, 0.0, owed})));
        ASSERT_EQ(*run(clock, device->read(gain)), before);
    }
    /// The gains that somebody has to be asked about.
    [[nodiscard]] std::size_t askedAbout()
    {
        const auto owed = run(clock, lookForOwed(*device, journal));
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

TEST(OwedGains, OfAUnitThatStoresLaterCountAsPutBackWhenItsFlashSaysSo)
{
    RealUnit unit;
    ASSERT_TRUE(storesLater(*unit.device));
    unit.tryAndPutBack(3s);
    EXPECT_EQ(unit.askedAbout(), 0U) << "it has them";
    EXPECT_EQ(unit.journal.owed.size(), 1U) << "but not for good";
    unit.clock.advance(storingTime(*unit.device));
    EXPECT_EQ(unit.askedAbout(), 0U);
    EXPECT_TRUE(unit.journal.owed.empty());
    unit.losePower();
    EXPECT_EQ(*run(unit.clock, unit.device->read(unit.gain)), unit.before);
}

TEST(OwedGains, AreAskedForWhenThePowerWentBeforeTheyWereStored)
{
    RealUnit unit;
    unit.tryAndPutBack(3s);
    EXPECT_EQ(unit.askedAbout(), 0U);
    unit.losePower();
    EXPECT_EQ(*run(unit.clock, unit.device->read(unit.gain)), unit.before / 2) << "its flash had what was tried";
    EXPECT_EQ(unit.askedAbout(), 1U);
    ASSERT_TRUE(run(unit.clock, payOwed(*unit.device, unit.journal, {1, 0.0, unit.journal.owed})));
    unit.clock.advance(storingTime(*unit.device));
    EXPECT_EQ(unit.askedAbout(), 0U);
    EXPECT_EQ(unit.journal.owed.size(), 1U) << "the device tells once that it restarted before it had stored";
    EXPECT_EQ(unit.askedAbout(), 0U);
    EXPECT_TRUE(unit.journal.owed.empty());
    unit.losePower();
    EXPECT_EQ(*run(unit.clock, unit.device->read(unit.gain)), unit.before);
}

TEST(OwedGains, OfWhatSomebodyHasWrittenSinceTheyWerePutBackAreOwedNoMore)
{
    RealUnit unit;
    unit.tryAndPutBack(3s);
    ASSERT_TRUE(run(unit.clock, writeGains(*unit.device, {{unit.gain, unit.before + 1000}})));
    EXPECT_EQ(unit.askedAbout(), 0U);
    EXPECT_TRUE(unit.journal.owed.empty());
    EXPECT_EQ(*run(unit.clock, unit.device->read(unit.gain)), unit.before + 1000);
}

TEST(OwedGains, ThatWereNeverPutBackAreAskedForWhateverTheUnitHas)
{
    RealUnit unit;
    ASSERT_TRUE(run(unit.clock, unit.journal.begin({})));
    ASSERT_TRUE(
        run(unit.clock, unit.journal.owe(1, unitKeyOf(*unit.device), {{"slot0.p", unit.before, unit.before / 2}})));
    ASSERT_TRUE(run(unit.clock, writeGains(*unit.device, {{unit.gain, unit.before + 1000}})));
    EXPECT_EQ(unit.askedAbout(), 1U);
}

} // namespace
} // namespace mb::tuning
