// SPDX-License-Identifier: GPL-3.0-or-later
// What an experiment owes to a unit: to a real one that stores by itself, later, a DMC60C on a CAN interface; and when it may be paid. In
// virtual time.
#include "model/bench.h"
#include "support/unitgains.h"
#include "tests/tuning/experimentbench.h"
#include "tests/tuning/realunit.h"
#include "transport/canlink.h"
#include "wire/canframe.h"

#include <functional>

namespace mb::tuning {
namespace {

using namespace std::chrono_literals;
using test::RealUnit;
using test::run;

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

TEST(OwedGains, OfATrialThatIsUnderWayAreNobodysQuestion)
{
    for (const bool isTried : {true, false}) {
        RealUnit unit;
        ASSERT_TRUE(run(unit.clock, unit.journal.begin({})));
        ASSERT_TRUE(
            run(unit.clock, unit.journal.owe(1, unitKeyOf(*unit.device), {{"slot0.p", unit.before, unit.before / 2}})));
        if (isTried) {
            ASSERT_TRUE(run(unit.clock, writeGains(*unit.device, {{unit.gain, unit.before / 2}})));
        }
        unit.clock.advance(60s);
        unit.journal.isUnderWay = true;
        EXPECT_EQ(unit.askedAbout(), 0U);
        EXPECT_EQ(unit.journal.log, (std::vector<std::string>{"begin", "owe"})) << "nor is it settled or released";
        unit.journal.isUnderWay = false;
        EXPECT_EQ(unit.askedAbout(), isTried ? 1U : 0U);
    }
}

TEST(OwedGains, AreNotPutBackWhileSomebodyDrivesAMotorThatIsBlocked)
{
    test::ExperimentBench bench;
    auto &clock = bench.bench.clock;
    bench.simulator()->disturb("stall", 1.0);
    const ParameterChange tried = bench.change("slot0.p", 0.25);
    const std::int64_t before = run(clock, bench.device->read(tried.index)).value_or(-1);
    ASSERT_TRUE(run(clock, writeGains(*bench.device, {tried})));
    const auto other = bench.bench.session.bench(*bench.bench.link)->hostLink();
    ASSERT_TRUE(other->open());
    Timer driving(clock);
    const std::function<void()> drive = [&] {
        (void)dynamic_cast<CanLink &>(*other).send(*canFrameFromText("02060005#0000000010270000"));
        driving.startIn(20ms, drive);
    };
    drive();
    clock.advance(500ms);
    ASSERT_TRUE(bench.simulator()->isOutputOn());
    bool isStopped = false;
    const auto stopping = bench.device->stopping().changed().add([&isStopped] { isStopped = true; });
    const auto refused = run(clock, payOwed(*bench.device, bench.journal, {1, 0.0, {{"slot0.p", before, tried.raw}}}));
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().fault, Fault::Unsafe);
    EXPECT_EQ(run(clock, bench.device->read(tried.index)).value_or(-1), tried.raw);
    clock.advance(15s);
    EXPECT_FALSE(isStopped) << "its motor is that of somebody else";
}

/// Its output is off, and something else turns it.
TEST(OwedGains, AreNotPutBackWhileTheShaftIsSeenToTurn)
{
    test::ExperimentBench bench("sim:can", "dmc60c", 5, "dmc60c:5,load=20");
    auto &clock = bench.bench.clock;
    const ParameterChange tried = bench.change("slot0.p", 0.25);
    const std::int64_t before = run(clock, bench.device->read(tried.index)).value_or(-1);
    ASSERT_TRUE(run(clock, bench.journal.begin({})));
    ASSERT_TRUE(run(clock, bench.journal.owe(1, unitKeyOf(*bench.device), {{"slot0.p", before, tried.raw}})));
    ASSERT_TRUE(run(clock, writeGains(*bench.device, {tried})));
    bench.device->stop();
    bench.simulator()->disturb("load-torque", -0.5);
    clock.advance(2s);
    ASSERT_TRUE(bench.device->isSeenStopped()) << "nothing drives it";
    ASSERT_GT(std::abs(bench.simulator()->speed()), 1000.0);
    const auto refused = run(clock, payOwed(*bench.device, bench.journal, {1, 0.0, bench.journal.owed}));
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().fault, Fault::Unsafe);
    EXPECT_EQ(run(clock, bench.device->read(tried.index)).value_or(-1), tried.raw);
    EXPECT_FALSE(bench.journal.owed.empty());
    bench.simulator()->disturb("load-torque", 0.0);
    const Instant released = clock.now();
    ASSERT_TRUE(run(clock, payOwed(*bench.device, bench.journal, {1, 0.0, bench.journal.owed})));
    EXPECT_GT(clock.now() - released, 500ms) << "it rolls out, which is waited for";
    EXPECT_EQ(run(clock, bench.device->read(tried.index)).value_or(-1), before);
}

TEST(OwedGains, ArePutBackInEveryFamilyWhoseMotorStands)
{
    const std::vector<std::array<std::string, 3>> all{{"sim:can", "dmc60c", "slot0.p"},
        {"sim:can", "abstractdc", "velocity.p"}, {"sim:serial", "supermodified", "gain.p"},
        {"sim:spi", "quadquad2drv", "ch1.velocity.p"}};
    for (const auto &[link, family, key] : all) {
        test::SimulatedSession bench(link);
        bench.scan();
        ASSERT_FALSE(bench.devices(family).empty()) << family;
        Device &device = *bench.devices(family).front();
        bench.clock.advance(1s);
        const auto index = findParameter(device.parameters().table(), key);
        ASSERT_TRUE(index) << family;
        test::FakeJournal journal;
        ASSERT_TRUE(run(bench.clock, device.write(*index, 7)));
        const auto paid = run(bench.clock, payOwed(device, journal, {1, 0.0, {{key, 9, 7}}}));
        EXPECT_TRUE(paid) << family << ": " << (paid ? "" : paid.error().text());
        const Simulator &unit = *bench.simulator(family + ':' + std::to_string(device.identity().address));
        EXPECT_EQ(test::rawInUnit(bench.clock, device, unit, key), 9) << family;
    }
}

} // namespace
} // namespace mb::tuning
