// SPDX-License-Identifier: GPL-3.0-or-later
// What is counted and concluded from the logs of an Abstract DC Drive, with every limit from both sides.
#include "async/virtualclock.h"
#include "families/abstractdc/answertime.h"
#include "families/abstractdc/leadprobe.h"
#include "families/abstractdc/logsense.h"
#include "families/abstractdc/motionsense.h"
#include "families/abstractdc/outputwatch.h"
#include "families/abstractdc/parameters.h"
#include "families/abstractdc/powercycledebt.h"
#include "families/abstractdc/setpoints.h"
#include "families/abstractdc/whereabouts.h"
#include "model/family.h"
#include "transport/backends/virtualcan.h"

#include <gtest/gtest.h>

#include <limits>
#include <memory>
#include <utility>

namespace mb::abstractdc {
extern const Family family;

namespace {

using namespace std::chrono_literals;

// Its output: abstractdc/README.md#wraps

/// The output was read with the target as far ahead as it may be.
void seen(LeadProbe &probe, std::int32_t output, Instant at)
{
    probe.sent(true, at - 50ms);
    probe.heard(output, at);
}

TEST(AbstractDcLeadProbe, GrowsFourfoldEachTimeTheOutputIsSeenBelowFullPower)
{
    LeadProbe probe;
    const Instant begin = Instant{} + 1s;
    EXPECT_EQ(probe.most(), 1000.0);
    seen(probe, 254, begin);
    EXPECT_EQ(probe.most(), 4000.0);
    seen(probe, -254, begin + 100ms);
    EXPECT_EQ(probe.most(), 16000.0);
    seen(probe, 255, begin + 200ms);
    seen(probe, -255, begin + 300ms);
    EXPECT_EQ(probe.most(), 16000.0) << "at full power already";
    for (int i = 0; i < 20; ++i)
        seen(probe, 0, begin + 1s + i * 100ms);
    EXPECT_EQ(probe.most(), 2147483647.0);
    probe.reset();
    EXPECT_EQ(probe.most(), 1000.0);
}

TEST(AbstractDcLeadProbe, BelievesNoOutputOfBeforeTheTargetWasSoFarAhead)
{
    LeadProbe probe;
    const Instant begin = Instant{} + 1s;
    probe.heard(0, begin);
    EXPECT_EQ(probe.most(), 1000.0) << "nothing was sent";
    probe.sent(false, begin);
    probe.heard(0, begin + 1s);
    EXPECT_EQ(probe.most(), 1000.0) << "near enough";
    probe.sent(true, begin + 2s);
    probe.heard(0, begin + 2s + 40ms);
    EXPECT_EQ(probe.most(), 1000.0) << "two passes of its loop are not over";
    probe.sent(true, begin + 2s + 40ms);
    probe.heard(0, begin + 2s + 41ms);
    EXPECT_EQ(probe.most(), 4000.0);
    probe.heard(0, begin + 3s);
    EXPECT_EQ(probe.most(), 4000.0) << "not twice for one target";
}

class AbstractDcOutput : public testing::Test {
protected:
    void expectCounts(std::int64_t saturations, std::int64_t wraps) const
    {
        const auto records = watch.records();
        ASSERT_EQ(records.size(), 2U);
        EXPECT_EQ(records[0].key, "output_saturated");
        EXPECT_EQ(records[0].count, saturations);
        EXPECT_EQ(records[0].sticky, saturations > 0);
        EXPECT_EQ(records[1].key, "output_wrapped");
        EXPECT_EQ(records[1].count, wraps);
        EXPECT_EQ(records[1].sticky, wraps > 0);
    }
    using Keys = std::vector<std::string>;
    OutputWatch watch;
};

TEST_F(AbstractDcOutput, IsSaturatedPastFullPowerAndCountedOnceEachTime)
{
    EXPECT_FALSE(watch.take(255));
    EXPECT_FALSE(watch.take(-255));
    EXPECT_EQ(watch.faults(), Keys{});
    expectCounts(0, 0);
    EXPECT_FALSE(watch.take(256));
    EXPECT_FALSE(watch.take(300));
    EXPECT_EQ(watch.faults(), Keys{"output_saturated"});
    EXPECT_TRUE(watch.records()[0].active);
    expectCounts(1, 0);
    EXPECT_FALSE(watch.take(0));
    EXPECT_EQ(watch.faults(), Keys{});
    EXPECT_FALSE(watch.take(-256));
    expectCounts(2, 0);
    watch.enterLoop();
    EXPECT_EQ(watch.faults(), Keys{});
    EXPECT_FALSE(watch.take(256));
    expectCounts(3, 0);
}

TEST_F(AbstractDcOutput, WrapsFrom32768OnAndTellsOfItOnceUntilItIsReleased)
{
    EXPECT_FALSE(watch.take(32767));
    EXPECT_FALSE(watch.take(-32767));
    EXPECT_FALSE(watch.hasWrapped());
    EXPECT_TRUE(watch.take(32768));
    EXPECT_TRUE(watch.hasWrapped());
    EXPECT_FALSE(watch.take(40000)) << "told already";
    EXPECT_EQ(watch.faults(), (Keys{"output_saturated", "output_wrapped"}));
    expectCounts(1, 1);
    watch.release();
    EXPECT_FALSE(watch.hasWrapped());
    EXPECT_TRUE(watch.take(-32768));
    watch.release();
    EXPECT_TRUE(watch.take(std::numeric_limits<std::int32_t>::min()));
    expectCounts(1, 3);
    EXPECT_TRUE(watch.records()[1].active);
    watch.clearCounts();
    expectCounts(0, 0);
    EXPECT_TRUE(watch.hasWrapped()) << "a count that is cleared drives nothing";
}

// Whether it has restarted: abstractdc/README.md#restarts

class AbstractDcRestartSense : public testing::Test {
protected:
    /// Silent at `before`, heard at `after`.
    Restart heardAt(std::optional<std::int64_t> before, std::int32_t after, bool lineOpen = true, bool stood = true)
    {
        if (before)
            where.located(static_cast<double>(*before), {}, false);
        where.silent(lineOpen, stood);
        return where.heard(after, {});
    }
    DeviceProfile profile;
    Whereabouts where{profile, [](const Whereabouts::Counters &) {}};
};

TEST_F(AbstractDcRestartSense, IsProvenByAPositionThatBeginsAnewFarFromWhereItStood)
{
    for (const std::int32_t near : {100, -100, 1, 0})
        EXPECT_EQ(heardAt(5000, near), Restart::Proven) << near;
    for (const std::int32_t far : {101, -101, 5000, std::numeric_limits<std::int32_t>::min()})
        EXPECT_EQ(heardAt(5000, far), Restart::No) << far;
    EXPECT_EQ(heardAt(300, 0), Restart::Proven);
    EXPECT_EQ(heardAt(-300, 0), Restart::Proven);
    EXPECT_EQ(heardAt(5000, 0, true, false), Restart::Maybe) << "it turned, and may have come there";
}

TEST_F(AbstractDcRestartSense, IsNotProvenByASilenceAloneWhereItStoodNearZeroOrNobodyKnowsWhere)
{
    EXPECT_EQ(heardAt(7, 7), Restart::No) << "its cable was out";
    EXPECT_EQ(heardAt(7, 8), Restart::Maybe);
    EXPECT_EQ(heardAt(0, 0), Restart::Maybe);
    EXPECT_EQ(heardAt(299, 0), Restart::Maybe);
    EXPECT_EQ(heardAt(std::nullopt, 3), Restart::Maybe);
}

TEST_F(AbstractDcRestartSense, IsProvenOnlyByTheFirstPositionAfterASilenceOnAnOpenLine)
{
    EXPECT_EQ(heardAt(5000, 0, false), Restart::Maybe) << "the link was closed: nobody listened";
    where.located(0, {}, false);
    EXPECT_EQ(where.heard(0, {}), Restart::No);
    EXPECT_EQ(heardAt(5000, 5000), Restart::No);
    where.located(5000, {}, false);
    EXPECT_EQ(where.heard(0, {}), Restart::No) << "that was a motion";
    where.silent(true, true);
    where.silent(false, false); // the link is closed meanwhile: it was silent all the same
    EXPECT_EQ(where.heard(0, {}), Restart::Proven);
}

TEST_F(AbstractDcRestartSense, APositionFromBeforeAnEarlierSilenceProvesNothing)
{
    EXPECT_EQ(heardAt(7, 7), Restart::No);
    EXPECT_EQ(heardAt(std::nullopt, 7), Restart::Maybe);
    EXPECT_EQ(heardAt(5000, 5000), Restart::No);
    EXPECT_EQ(heardAt(std::nullopt, 0), Restart::Maybe);
}

TEST_F(AbstractDcRestartSense, IsMaybeTheFirstTimeThatItIsHeardNearZeroWhereItWasKnownToBeAway)
{
    profile.counters["place.position"] = 5000;
    EXPECT_EQ(where.heard(3, {}), Restart::Maybe);
    EXPECT_EQ(heardAt(5000, 3, false), Restart::Maybe);
}

TEST_F(AbstractDcRestartSense, IsNoneWhereItWasNearZeroWhenItWasLastHeardAndNobodySawItSilent)
{
    EXPECT_EQ(where.heard(3, {}), Restart::No);
    EXPECT_EQ(heardAt(0, 0, false), Restart::No) << "its line was gone";
    EXPECT_EQ(heardAt(0, 0, true), Restart::Maybe) << "it was silent while its line was open";
}

TEST_F(AbstractDcRestartSense, IsSeenWhereNoShaftGetsToZeroSoFast)
{
    EXPECT_EQ(Whereabouts::between(5000, 200, 200), Restart::Seen);
    EXPECT_EQ(Whereabouts::between(5000, 201, 200), Restart::No) << "not near 0";
    EXPECT_EQ(Whereabouts::between(250, 50, 200), Restart::No) << "it may have turned there";
    EXPECT_EQ(Whereabouts::between(251, 50, 200), Restart::Seen);
}

// The power cycle that it owes: abstractdc/README.md#averaging

TEST(AbstractDcDebt, IsKeptUntilItIsPaidAndNotWrittenWhereNoneIsOwed)
{
    DeviceProfile profile;
    int kept = 0;
    PowerCycleDebt debt(profile, [&](std::int64_t owed) {
        ++kept;
        profile.counters[std::string(counter::powerCycle)] = owed;
    });
    EXPECT_FALSE(debt.isOwed());
    debt.pay();
    EXPECT_EQ(kept, 0);
    EXPECT_TRUE(profile.isEmpty());
    debt.incur();
    EXPECT_TRUE(debt.isOwed());
    debt.pay();
    EXPECT_FALSE(debt.isOwed());
    EXPECT_EQ(kept, 2);
}

// Its shaft: abstractdc/README.md#position

class AbstractDcMotion : public testing::Test {
protected:
    bool at(Duration time, std::int32_t position)
    {
        return sense.add(position, Instant{1s} + time) == MotionSense::Reading::Glitch;
    }
    [[nodiscard]] std::optional<double> velocity(Duration time) const { return sense.velocity(Instant{1s} + time); }
    [[nodiscard]] bool stands(Duration since) const { return sense.standsSince(Instant{1s} + since); }
    [[nodiscard]] bool moves(Duration time) const { return sense.isMoving(Instant{1s} + time); }
    MotionSense sense;
};

TEST_F(AbstractDcMotion, VelocityIsThatOfTheShortestStretchOfFortyFiveMillisecondsOrMore)
{
    at(0ms, 0);
    EXPECT_FALSE(velocity(0ms)) << "one sample";
    at(15ms, 100);
    EXPECT_NEAR(*velocity(15ms), 100 / 0.015, 1e-6) << "no longer stretch is there yet";
    at(60ms, 1000);
    EXPECT_NEAR(*velocity(60ms), 900 / 0.045, 1e-6);
    at(59ms + 45ms, 1500);
    EXPECT_NEAR(*velocity(104ms), 1400 / 0.089, 1e-6) << "44 ms are too short";
    at(300ms, 1500);
    EXPECT_EQ(*velocity(300ms), 0.0);
}

TEST_F(AbstractDcMotion, NothingIsKnownOfItAfterHalfASecondOfSilence)
{
    at(0ms, 0);
    at(100ms, 100);
    EXPECT_TRUE(velocity(600ms));
    EXPECT_TRUE(moves(600ms));
    EXPECT_FALSE(velocity(600ms + 1ns));
    EXPECT_FALSE(moves(600ms + 1ns));
    EXPECT_EQ(sense.position(), 100) << "where it was last";
    sense.forget();
    EXPECT_FALSE(sense.position());
    EXPECT_FALSE(velocity(100ms));
    EXPECT_FALSE(stands(0ms));
}

TEST_F(AbstractDcMotion, TwoSamplesOfOneTimeHaveNoVelocity)
{
    at(10ms, 0);
    at(10ms, 5);
    EXPECT_FALSE(velocity(10ms));
}

TEST_F(AbstractDcMotion, MovesByThreeCountsOfTheLastQuarterOfASecond)
{
    at(0ms, 2);
    EXPECT_FALSE(moves(0ms)) << "one sample";
    at(10ms, 0);
    EXPECT_FALSE(moves(10ms)) << "two counts are noise";
    at(20ms, 3);
    EXPECT_TRUE(moves(20ms));
    at(30ms, 3);
    at(270ms - 1ns, 3);
    EXPECT_TRUE(moves(270ms)) << "the 0 is a quarter of a second old, and not left out yet";
    at(270ms, 3);
    EXPECT_FALSE(moves(270ms));
}

TEST_F(AbstractDcMotion, StandsByTwoSamplesFortyFiveMillisecondsApartThatAreYoungerThanTheStop)
{
    EXPECT_FALSE(stands(0ms));
    at(10ms, 50);
    at(20ms, 7);
    at(65ms - 1ns, 8);
    EXPECT_FALSE(stands(15ms)) << "44.9 ms";
    at(65ms, 8);
    EXPECT_TRUE(stands(15ms)) << "one count is noise";
    EXPECT_TRUE(stands(20ms - 1ns));
    EXPECT_FALSE(stands(20ms)) << "what is as old as the stop is not younger";
    at(66ms, 9);
    EXPECT_FALSE(stands(15ms)) << "two counts";
    at(66ms + 45ms, 9);
    EXPECT_TRUE(stands(15ms));
}

TEST_F(AbstractDcMotion, ARingOfAWrapWithinItsSlackIsAGlitchAndOneOutsideIsMotion)
{
    struct Row {
        std::int32_t jump;
        bool glitch;
    };
    for (const Row &row : {Row{65535 + 4095, true}, Row{65535 + 4096, false}, Row{65535 - 4095, true},
             Row{65535 - 4096, false}, Row{-65535 - 4095, true}, Row{-65535 + 4096, false}}) {
        sense = {};
        at(0ms, 0);
        at(20ms, 0);
        EXPECT_EQ(at(40ms, row.jump), row.glitch) << row.jump;
        EXPECT_EQ(sense.glitches(), row.glitch ? 1U : 0U);
        EXPECT_EQ(sense.position(), row.glitch ? 0 : row.jump) << "a glitch is not recorded";
    }
}

TEST_F(AbstractDcMotion, TheSlackGrowsWithTheWayOfAMovingShaft)
{
    at(0ms, 0);
    at(50ms, 5000); // 100000 counts/s: 2000 in 20 ms
    EXPECT_TRUE(at(70ms, 7000 + 65535 + 6000));
    sense = {};
    at(0ms, 0);
    at(50ms, 5000);
    EXPECT_FALSE(at(70ms, 7000 + 65535 + 6200));
    sense = {};
    at(0ms, 0);
    at(50ms, 50000); // 1000000 counts/s: no more than 30000
    EXPECT_FALSE(at(90ms, 90000 + 65535 + 30000));
    EXPECT_FALSE(at(100ms, 100000));
}

TEST_F(AbstractDcMotion, APositionThatWrapsAtThirtyTwoBitsGoesOn)
{
    constexpr std::int64_t last = std::numeric_limits<std::int32_t>::max();
    const auto told
        = [](std::int64_t position) { return static_cast<std::int32_t>(static_cast<std::uint32_t>(position)); };
    for (const std::int64_t step : {4000, -4000}) {
        sense = {};
        std::int64_t position = step > 0 ? last - 9000 : -last + 9000;
        for (int i = 0; i < 8; ++i, position += step) {
            EXPECT_EQ(sense.add(told(position), Instant{1s} + i * 20ms), MotionSense::Reading::Taken) << i;
            EXPECT_EQ(sense.position(), told(position));
            if (i > 0) {
                EXPECT_NEAR(*velocity(i * 20ms), static_cast<double>(step) * 50.0, 1e-3) << i;
            }
        }
        EXPECT_EQ(sense.add(0, Instant{1s} + 160ms), MotionSense::Reading::Anew) << "so fast does no shaft turn back";
        EXPECT_EQ(sense.position(), 0);
    }
    sense = {};
    at(0ms, told(last));
    at(50ms, told(last + 1));
    EXPECT_TRUE(stands(-1ms)) << "one count";
    EXPECT_FALSE(moves(50ms));
    at(100ms, told(last + 3));
    EXPECT_TRUE(moves(100ms));
    EXPECT_TRUE(at(120ms, told(last + 3 + 65535))) << "a glitch";
}

TEST(AbstractDcMotionSense, AJumpThatStaysIsBelievedTheSecondTime)
{
    MotionSense sense;
    Instant t{};
    EXPECT_EQ(sense.add(0, t += 20ms), MotionSense::Reading::Taken);
    EXPECT_EQ(sense.add(10, t += 20ms), MotionSense::Reading::Taken);
    EXPECT_EQ(sense.add(10 - 65535, t += 20ms), MotionSense::Reading::Glitch);
    EXPECT_EQ(sense.add(12, t += 20ms), MotionSense::Reading::Taken);
    EXPECT_EQ(sense.add(12 + 65535, t += 20ms), MotionSense::Reading::Glitch);
    EXPECT_EQ(sense.add(12 + 65535, t += 20ms), MotionSense::Reading::Taken);
    EXPECT_EQ(sense.position(), 12 + 65535);
    EXPECT_EQ(sense.glitches(), 2U);
}

TEST(AbstractDcMotionSense, AShaftThatNobodySawTurnIsNotTakenForAFasterOneTheLongerItWasNotSeen)
{
    for (const Duration later : {Duration(20ms), Duration(100s)}) {
        for (const std::int32_t position : {200, 230}) {
            MotionSense sense;
            (void)sense.add(1000, {});
            EXPECT_EQ(sense.add(position, Instant{} + later) == MotionSense::Reading::Anew, position == 200)
                << position;
        }
    }
}

TEST(AbstractDcMotionSense, APositionNearZeroThatNoShaftReachesSoFastIsThatOfARestart)
{
    const auto readingOf = [](std::int32_t step, std::int32_t from, std::int32_t position) {
        MotionSense sense;
        Instant t{};
        for (int i = 10; i >= 0; --i)
            (void)sense.add(from - i * step, t += 20ms);
        return sense.add(position, t + 20ms);
    };
    EXPECT_EQ(readingOf(0, 1000, 0), MotionSense::Reading::Anew);
    EXPECT_EQ(readingOf(0, 1000, -200), MotionSense::Reading::Anew);
    EXPECT_EQ(readingOf(0, 1000, -201), MotionSense::Reading::Taken) << "turned on from 0, too, but who knows";
    EXPECT_EQ(readingOf(0, 200, 0), MotionSense::Reading::Taken) << "a shaft may do that";
    EXPECT_EQ(readingOf(0, -201, 0), MotionSense::Reading::Anew);
    EXPECT_EQ(readingOf(100, 5000, 0), MotionSense::Reading::Anew);
    EXPECT_EQ(readingOf(100, 400, 0), MotionSense::Reading::Taken) << "it was seen to do half of it";
    EXPECT_EQ(readingOf(100, 401, 0), MotionSense::Reading::Anew);
    EXPECT_EQ(readingOf(100, 5000, 400), MotionSense::Reading::Anew) << "it ran on from 0";
    EXPECT_EQ(readingOf(0, 1000, 500), MotionSense::Reading::Taken) << "a jump to anywhere else is none";
}

// What its loop measures: abstractdc/README.md#stale-logs

TEST(AbstractDcLogSense, ALoopHasPassedTwiceOnlyAfterItsSetPointWasOnTheWireTooAndADutyHasNoPass)
{
    VirtualClock clock;
    VirtualCanBus bus{clock, 125'000, 1};
    VirtualCanLink link{*LinkAddress::parse("sim:can"), bus};
    const DeviceProfile profile;
    LogSense sense(link, clock, std::make_shared<Telemetry>(family.channels), profile, {});
    const Duration passes = 2 * loopPeriod + loopPeriod / 4;
    Instant begin = Instant{} + 1s;
    for (const auto &[loop, least] :
        {std::pair{Loop::Velocity, passes}, {Loop::Direct, Duration::zero()}, {Loop::Position, passes}}) {
        ASSERT_TRUE(sense.enter(loop, begin));
        EXPECT_FALSE(sense.hasPassed(begin + least + roundTrip(link) - 1ns));
        EXPECT_TRUE(sense.hasPassed(begin + least + roundTrip(link)));
        begin += 10s;
    }
}

// What may be written while it drives: abstractdc/README.md#wraps

TEST(AbstractDcGains, AStrongerOneIsRefusedBeyondWhereItWouldWrapAndAWeakerOneNowhere)
{
    ParameterStore known(parameterTable());
    const auto velocity = [](Field field) { return *parameterOf(Loop::Velocity, field); };
    for (const auto &[field, raw] : {std::pair{Field::P, 0}, {Field::D, 100}, {Field::Divisor, 1}})
        known.setRead(velocity(field), raw); // 2 · 100 / 20 ms: 10 of output per unit of error
    const std::vector<ParameterChange> stronger{{velocity(Field::P), 10}};
    EXPECT_TRUE(mayChange(known, stronger, 1600.0, 0.0));
    EXPECT_FALSE(mayChange(known, stronger, 1601.0, 0.0));
    const std::vector<ParameterChange> weaker{{velocity(Field::D), 50}};
    EXPECT_TRUE(mayChange(known, weaker, 1e6, 0.0));
}

} // namespace
} // namespace mb::abstractdc
