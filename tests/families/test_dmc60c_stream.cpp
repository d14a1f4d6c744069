// SPDX-License-Identifier: GPL-3.0-or-later
#include "dmc60cstreamfixture.h"

#include <random>

namespace mb::dmc60c {
namespace {

using namespace std::chrono_literals;

TEST_F(Dmc60cStream, KeepsValuesAndSourceTimes)
{
    stream.add(Instant{123456789ns}, {1.5, -2.0});
    EXPECT_EQ(telemetry->latest(a)->time, Instant{123456789ns});
    EXPECT_EQ(telemetry->latest(a)->value, 1.5);
    EXPECT_EQ(telemetry->latest(b)->value, -2.0);
}

TEST_F(Dmc60cStream, CountsEveryFrameThatIsMissingInARegularStream)
{
    for (const auto gap : {10ms, 10ms, 20ms, 10ms, 10ms, 50ms, 10ms, 30ms, 20ms, 10ms})
        after(gap);
    EXPECT_EQ(lost(), 1U + 4U + 2U + 1U);
    EXPECT_EQ(recorded(), sent);
}

TEST_F(Dmc60cStream, DrawsTheGapWhereItWas)
{
    for (const auto gap : {10ms, 10ms, 30ms, 10ms})
        after(gap);
    telemetry->commit();
    const auto gaps = telemetry->gaps(a, Instant{}, time);
    ASSERT_EQ(gaps.size(), 1U);
    EXPECT_EQ(gaps[0].from, Instant{1s} + 20ms);
    EXPECT_EQ(gaps[0].to, Instant{1s} + 50ms);
}

TEST_F(Dmc60cStream, CountsExactlyAtTenPercentRandomLoss)
{
    std::mt19937 random(7);
    std::uint64_t missing = 0;
    after(10ms);
    Duration gap{};
    for (int i = 0; i < 20000; ++i) {
        gap += 10ms;
        if (i < 19990 && random() % 10 == 0) {
            ++missing;
            continue;
        }
        after(gap);
        gap = Duration::zero();
    }
    EXPECT_EQ(lost(), missing);
    EXPECT_EQ(recorded(), sent);
}

TEST_F(Dmc60cStream, TakesJitterForWhatItIs)
{
    std::mt19937 random(3);
    Instant due = time;
    for (int i = 0; i < 5000; ++i) {
        due += 10ms;
        const auto jitter = std::chrono::microseconds(random() % 6000);
        stream.add(due + jitter, {0.0, 0.0});
    }
    EXPECT_EQ(lost(), 0U);
}

TEST_F(Dmc60cStream, TakesALateFrameForLate)
{
    for (const auto gap : {10ms, 10ms, 17ms, 3ms, 10ms, 10ms})
        after(gap);
    EXPECT_EQ(lost(), 0U);
}

TEST_F(Dmc60cStream, TakesFramesThatComeAtOnceBehindAGapForLate)
{
    after(10ms);
    for (int round = 0; round < 5; ++round) { // a computer or an adapter that is held up brings them together
        after(200ms);
        for (int i = 1; i < 20; ++i)
            after(0ms);
        for (int i = 0; i < 20; ++i)
            after(10ms);
    }
    for (int round = 0; round < 5; ++round) { // and one that never sends them otherwise
        after(40ms);
        for (int i = 1; i < 4; ++i)
            after(10us);
    }
    after(10ms);
    EXPECT_EQ(lost(), 0U);
    EXPECT_EQ(stream.period(), 10ms);
    EXPECT_EQ(recorded(), sent);
}

TEST_F(Dmc60cStream, LosesNothingOnALinkThatStallsAtRandom)
{
    std::mt19937 random(11);
    Duration handedOver{}; // by an adapter with times of whole milliseconds, which is held up now and then
    for (std::int64_t i = 1; i < 20000; ++i) {
        const Duration due = i * 10ms;
        if (due > handedOver)
            handedOver = due + (random() % 50 == 0 ? 30ms + (random() % 450) * 1ms / 10 : (random() % 30) * 100us);
        const auto whole = std::chrono::floor<std::chrono::milliseconds>(std::max(due, handedOver));
        stream.add(Instant{1s} + whole, {0.0, 0.0});
    }
    EXPECT_LE(lost(), 200U); // of 20000, at the edges of what came together
    EXPECT_EQ(stream.period(), 10ms);
}

TEST_F(Dmc60cStream, GivesLateFramesTheTimesAtWhichTheyWereSent)
{
    after(10ms);
    after(50ms);
    for (int i = 1; i < 5; ++i)
        after(0ms);
    telemetry->commit();
    std::vector<Duration> times;
    telemetry->forEach(
        a, Instant{}, time, [&times](const Point &point) { times.push_back(point.time.time_since_epoch() - 1s); });
    EXPECT_EQ(times, (std::vector<Duration>{10ms, 20ms, 30ms, 40ms, 50ms, 60ms}));
}

TEST_F(Dmc60cStream, FramesThatWaitedForEachOtherAreNoShorterPeriod)
{
    for (int i = 0; i < 40; ++i) // what had queued up when the link was opened
        after(20us);
    for (int i = 0; i < 20; ++i)
        after(10ms);
    EXPECT_EQ(stream.period(), 10ms);
    EXPECT_EQ(lost(), 0U);
}

TEST_F(Dmc60cStream, CountsWhatDidNotComeWithTheOthersBehindAGap)
{
    after(10ms);
    for (int round = 0; round < 3; ++round) {
        after(200ms);
        for (int i = 1; i < 17; ++i) // 3 of 20 are missing
            after(0ms);
        after(10ms);
    }
    EXPECT_EQ(lost(), 9U);
    for (int round = 0; round < 3; ++round) {
        after(50ms);
        for (int i = 1; i < 4; ++i)
            after(0ms);
    }
    after(10ms);
    EXPECT_EQ(lost(), 12U);
    EXPECT_EQ(recorded(), sent);
}

TEST_F(Dmc60cStream, BearsADeviceThatTakesItsPeriodFromTheFrameBefore)
{
    std::mt19937 random(5);
    for (int i = 0; i < 5000; ++i)
        after(10ms + (random() % 5 == 0 ? 4ms : 0ms)); // no crystal: lateness adds up, to 8 % here
    EXPECT_EQ(lost(), 0U);
    after(20ms);
    after(10ms);
    EXPECT_EQ(lost(), 1U);
}

TEST_F(Dmc60cStream, LearnsALongerPeriodWithoutCountingIt)
{
    for (const auto period : {10ms, 50ms, 100ms, 1000ms}) {
        for (int i = 0; i < 20; ++i)
            after(period);
        EXPECT_EQ(lost(), 0U) << period.count();
        EXPECT_EQ(stream.period(), period);
        EXPECT_EQ(recorded(), sent);
    }
    after(3000ms);
    after(1000ms);
    EXPECT_EQ(lost(), 2U) << "loss is counted again";
}

TEST_F(Dmc60cStream, LearnsAShorterPeriod)
{
    for (int i = 0; i < 10; ++i)
        after(10ms);
    for (int i = 0; i < 10; ++i)
        after(1ms);
    EXPECT_EQ(stream.period(), 1ms);
    after(3ms);
    after(1ms);
    EXPECT_EQ(lost(), 2U);
}

TEST_F(Dmc60cStream, OfALateFrameBehindTwoThatAreMissingOnlyThoseAreCounted)
{
    for (const auto gap : {10ms, 10ms, 36ms, 4ms, 10ms, 10ms}) // 50 comes at 56, and 60 in time
        after(gap);
    EXPECT_EQ(lost(), 2U);
    EXPECT_EQ(recorded(), sent);
}

TEST_F(Dmc60cStream, ThreeShortGapsAfterALongOneAreJitterAndFourOfThemANewPeriod)
{
    for (const auto gap : {10ms, 10ms, 14ms, 6ms, 6ms, 6ms})
        after(gap);
    EXPECT_EQ(stream.period(), 10ms);
    EXPECT_EQ(lost(), 0U);
    after(6ms);
    EXPECT_EQ(stream.period(), 6ms);
    EXPECT_EQ(lost(), 0U);
}

TEST_F(Dmc60cStream, APeriodOfNothingIsNotBelieved)
{
    after(10ms);
    stream.setPeriod(0ms);
    stream.setPeriod(-1ms);
    EXPECT_EQ(stream.period(), 10ms);
    after(20ms);
    after(10ms);
    EXPECT_EQ(lost(), 1U);
}

TEST_F(Dmc60cStream, APeriodThatDiffersByATenthIsAnotherOneAndTheGapBehindItIsNoLoss)
{
    for (const auto gap : {10ms, 10ms, 10ms})
        after(gap);
    stream.setPeriod(8500us);
    after(20ms); // a mixture of both
    after(8500us);
    after(8500us);
    EXPECT_EQ(lost(), 0U);
    stream.setPeriod(9000us); // known: what has gone is missing
    after(18ms);
    after(9000us);
    EXPECT_EQ(lost(), 1U);
}

TEST_F(Dmc60cStream, BelievesTheDeviceAboutANewPeriod)
{
    for (int i = 0; i < 5; ++i)
        after(10ms);
    after(50ms); // already the new period, and still unexplained
    EXPECT_TRUE(stream.isHolding());
    stream.setPeriod(50ms);
    EXPECT_FALSE(stream.isHolding());
    after(50ms);
    after(50ms);
    EXPECT_EQ(lost(), 0U);
    after(100ms);
    after(50ms);
    EXPECT_EQ(lost(), 1U);
}

TEST_F(Dmc60cStream, BelievesTheDeviceThatThePeriodIsTheOldOne)
{
    after(10ms);
    for (int i = 0; i < 20; ++i) {
        after(30ms);
        stream.setPeriod(10ms);
    }
    after(10ms);
    EXPECT_EQ(lost(), 40U) << "however regular the loss is";
    EXPECT_EQ(stream.period(), 10ms);
    EXPECT_EQ(recorded(), sent);
}

TEST_F(Dmc60cStream, StillTakesALateFrameForLateWhenTheDeviceConfirmsThePeriod)
{
    after(10ms);
    after(10ms);
    after(18ms);
    stream.setPeriod(10ms);
    after(2ms);
    after(10ms);
    EXPECT_EQ(lost(), 0U);
}

TEST_F(Dmc60cStream, ADeviceThatIsToldItsPeriodAgainMayBeginANewOne)
{
    for (const auto gap : {17ms, 12ms, 19ms}) {
        after(10ms);
        after(10ms);
        stream.setPeriod(10ms);
        after(gap); // the write fell between two frames, and the timer began again with it
        after(10ms);
        EXPECT_EQ(lost(), 0U);
    }
    stream.setPeriod(10ms);
    after(20ms);
    after(10ms);
    EXPECT_EQ(lost(), 1U) << "that is a frame";
}

TEST_F(Dmc60cStream, BreaksTheLineButCountsNothingAfterASilence)
{
    after(10ms);
    after(10ms);
    stream.interrupt();
    after(5s);
    after(10ms);
    EXPECT_EQ(lost(), 0U);
    EXPECT_EQ(telemetry->gaps(a, Instant{}, time).size(), 1U);
}

TEST_F(Dmc60cStream, GoesBackToTheFirstPeriodAfterARestart)
{
    stream.setPeriod(1ms);
    after(1ms);
    stream.restart();
    EXPECT_EQ(stream.period(), 10ms);
    after(10ms);
    after(10ms);
    EXPECT_EQ(lost(), 0U);
}

TEST_F(Dmc60cStream, UnlikeGapsInARowAreLossAlthoughNoRegularFrameComes)
{
    after(10ms);
    for (const auto gap : {20ms, 30ms, 20ms, 40ms, 20ms, 30ms, 20ms}) {
        after(gap);
        EXPECT_EQ(lost(), 0U) << "it could be another period";
    }
    after(50ms);
    EXPECT_EQ(lost(), 1U + 2U + 1U + 3U + 1U + 2U + 1U) << "those of the last gap may still come";
    after(10ms);
    EXPECT_EQ(lost(), 1U + 2U + 1U + 3U + 1U + 2U + 1U + 4U);
    EXPECT_FALSE(stream.isHolding());
    EXPECT_EQ(recorded(), sent);
    EXPECT_EQ(stream.period(), 10ms);
}

TEST_F(Dmc60cStream, GapsThatTheDeviceExplainsAreLossAfterEightToo)
{
    after(10ms);
    after(30ms);
    stream.setPeriod(10ms);
    for (int i = 0; i < 7; ++i)
        after(30ms);
    EXPECT_EQ(lost(), 14U);
    after(10ms);
    EXPECT_EQ(lost(), 16U);
    EXPECT_EQ(stream.period(), 10ms);
}

TEST_F(Dmc60cStream, UpToThirtyTwoPeriodsAreLossAndLongerOnesSilence)
{
    after(10ms);
    after(10ms);
    after(330ms);
    after(10ms);
    EXPECT_EQ(lost(), 32U);
    after(340ms);
    after(10ms);
    EXPECT_EQ(lost(), 32U) << "33 missing frames are a silence";
    telemetry->commit();
    for (const ChannelIndex channel : {a, b})
        EXPECT_EQ(telemetry->gaps(channel, Instant{}, time).size(), 2U) << "which is drawn all the same";
}

TEST_F(Dmc60cStream, UpToAQuarterOfASecondIsLossHoweverShortThePeriod)
{
    stream.setPeriod(1ms);
    after(1ms);
    after(1ms);
    after(251ms);
    after(1ms);
    EXPECT_EQ(lost(), 250U);
    after(252ms);
    after(1ms);
    EXPECT_EQ(lost(), 250U);
}

} // namespace
} // namespace mb::dmc60c
