// SPDX-License-Identifier: GPL-3.0-or-later
#include "traffic/trafficstatistics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mb {
namespace {

using namespace std::chrono_literals;

constexpr Instant start{std::chrono::seconds(1000)};

CanFrame countedFrame(std::uint32_t id, Instant time, std::initializer_list<std::uint8_t> bytes = {})
{
    CanFrame made = extendedFrame(id, bytes);
    made.time = time;
    return made;
}

TrafficRow only(const TrafficStatistics &statistics, Instant now)
{
    std::vector<TrafficRow> rows;
    statistics.rows(now, rows);
    EXPECT_EQ(rows.size(), 1U);
    return rows.empty() ? TrafficRow{} : rows.front();
}

TEST(TrafficStatistics, RateIsTheNumberOfFramesInTheLastSecond)
{
    TrafficStatistics statistics;
    for (int i = 0; i < 300; ++i)
        statistics.add(Direction::Received, countedFrame(5, start + i * 10ms));
    EXPECT_EQ(only(statistics, start + 3s).rate, 100.0);
    EXPECT_EQ(only(statistics, start + 3500ms).rate, 50.0);
    EXPECT_EQ(only(statistics, start + 4s).rate, 0.0);
    EXPECT_EQ(only(statistics, start + 1h).rate, 0.0);
    EXPECT_EQ(only(statistics, start + 1h).count, 300U);
}

TEST(TrafficStatistics, RateOfAFullBusIsExact)
{
    TrafficStatistics statistics;
    for (int i = 0; i < 3 * 9009; ++i)
        statistics.add(Direction::Received, countedFrame(5, start + i * Duration(1s) / 9009));
    EXPECT_EQ(only(statistics, start + 3s).rate, 9009.0);
}

TEST(TrafficStatistics, RateStartsAgainAfterAPause)
{
    TrafficStatistics statistics;
    for (int i = 0; i < 100; ++i)
        statistics.add(Direction::Received, countedFrame(5, start + i * 10ms));
    for (int i = 0; i < 10; ++i)
        statistics.add(Direction::Received, countedFrame(5, start + 100s + i * 10ms));
    EXPECT_EQ(only(statistics, start + 101s).rate, 10.0);
}

TEST(TrafficStatistics, RateOfATimeBeforeTheNewestFrameIsExact)
{
    TrafficStatistics statistics;
    for (int i = 0; i <= 40; ++i)
        statistics.add(Direction::Received, countedFrame(5, start + i * 50ms));
    EXPECT_EQ(only(statistics, start + 1450ms).rate, 20.0) << "the clock of an adapter may be half a second ahead";
}

TEST(TrafficStatistics, JitterIsTheStandardDeviationOfThePeriod)
{
    TrafficStatistics steady;
    TrafficStatistics uneven;
    Instant time = start;
    for (int i = 0; i < 65; ++i) {
        steady.add(Direction::Received, countedFrame(5, start + i * 10ms));
        uneven.add(Direction::Received, countedFrame(5, time));
        time += i % 2 == 0 ? 9ms : 11ms;
    }
    EXPECT_NEAR(*only(steady, time).period, 0.010, 1e-12);
    EXPECT_NEAR(*only(steady, time).jitter, 0.0, 1e-12);
    EXPECT_NEAR(*only(uneven, time).period, 0.010, 1e-12);
    EXPECT_NEAR(*only(uneven, time).jitter, 0.001, 1e-12);
    EXPECT_NEAR(*only(uneven, time).worst, 0.001, 1e-12);
}

TEST(TrafficStatistics, OneLateFrameShowsInWorstAndLeavesAfter32Periods)
{
    TrafficStatistics statistics;
    for (int i = 0; i < 40; ++i)
        statistics.add(Direction::Received, countedFrame(5, start + i * 10ms));
    Instant time = start + 422ms; // due at 400 ms
    statistics.add(Direction::Received, countedFrame(5, time));
    // 31 periods of 10 ms and one of 32 ms: mean 10.6875 ms
    EXPECT_NEAR(*only(statistics, time).period, 0.0106875, 1e-12);
    EXPECT_NEAR(*only(statistics, time).worst, 0.0213125, 1e-12);
    EXPECT_NEAR(*only(statistics, time).jitter, 0.022 * std::sqrt(31.0) / 32.0, 1e-12);
    for (int i = 0; i < 32; ++i)
        statistics.add(Direction::Received, countedFrame(5, time += 10ms));
    EXPECT_NEAR(*only(statistics, time).worst, 0.0, 1e-12);
}

TEST(TrafficStatistics, TooFewFramesTellNoPeriodAndNoJitter)
{
    TrafficStatistics statistics;
    statistics.add(Direction::Received, countedFrame(5, start));
    EXPECT_FALSE(only(statistics, start).period);
    statistics.add(Direction::Received, countedFrame(5, start + 10ms));
    EXPECT_TRUE(only(statistics, start).period);
    EXPECT_FALSE(only(statistics, start).jitter);
    EXPECT_FALSE(only(statistics, start).worst);
    statistics.add(Direction::Received, countedFrame(5, start + 20ms));
    EXPECT_TRUE(only(statistics, start).jitter);
    EXPECT_TRUE(only(statistics, start).worst);
    std::vector<CanFrame> trail;
    statistics.trail(keyOf(Direction::Received, countedFrame(5, start)), Instant{}, trail);
    EXPECT_EQ(trail.size(), 1U) << "all three lie in one step of 50 ms";
}

TEST(TrafficStatistics, RemembersWhenEachByteChanged)
{
    TrafficStatistics statistics;
    statistics.add(Direction::Received, countedFrame(5, start, {1, 2, 3}));
    EXPECT_EQ(only(statistics, start).changed, (std::array<Instant, 8>{})) << "the first frame changes nothing";
    statistics.add(Direction::Received, countedFrame(5, start + 1s, {1, 9, 3}));
    EXPECT_EQ(only(statistics, start + 1s).changed[3], Instant{}) << "it has no fourth byte";
    statistics.add(Direction::Received, countedFrame(5, start + 2s, {1, 9, 3, 0}));
    const TrafficRow row = only(statistics, start + 2s);
    EXPECT_EQ(row.changed[0], Instant{});
    EXPECT_EQ(row.changed[1], start + 1s);
    EXPECT_EQ(row.changed[2], Instant{});
    EXPECT_EQ(row.changed[3], start + 2s) << "a byte that appeared";
    EXPECT_TRUE(sameContent(row.last, countedFrame(5, start, {1, 9, 3, 0})));
    statistics.add(Direction::Received, countedFrame(5, start + 3s, {7, 9, 3, 0}));
    EXPECT_EQ(only(statistics, start + 3s).changed[0], start + 3s);
}

TEST(TrafficStatistics, KeepsKindsAndDirectionsOfOneIdentifierApart)
{
    TrafficStatistics statistics;
    CanFrame remote = standardFrame(0x123, {});
    remote.remote = true;
    CanFrame error = standardFrame(0x123, {});
    error.error = true;
    statistics.add(Direction::Received, standardFrame(0x123, {}));
    statistics.add(Direction::Sent, standardFrame(0x123, {}));
    statistics.add(Direction::Received, countedFrame(0x123, start));
    statistics.add(Direction::Received, remote);
    statistics.add(Direction::Received, error);
    std::vector<TrafficRow> rows;
    statistics.rows(start, rows);
    ASSERT_EQ(rows.size(), 5U);
    for (const TrafficRow &row : rows)
        EXPECT_EQ(row.count, 1U);
    EXPECT_EQ(rows[1].key.direction, Direction::Sent);
    EXPECT_TRUE(rows[2].key.extended);
    EXPECT_TRUE(rows[3].key.remote);
    EXPECT_TRUE(rows[4].key.error);
}

TEST(TrafficStatistics, CountsTogetherWhatExceedsItsRows)
{
    TrafficStatistics statistics;
    constexpr std::uint32_t more = TrafficStatistics::mostKeys + 50;
    for (int round = 0; round < 2; ++round) {
        for (std::uint32_t id = 0; id < more; ++id)
            statistics.add(Direction::Received, countedFrame(id * 4096, start));
    }
    std::vector<TrafficRow> rows;
    statistics.rows(start, rows);
    EXPECT_EQ(rows.size(), TrafficStatistics::mostKeys);
    std::uint64_t counted = statistics.unlisted();
    EXPECT_EQ(counted, 100U);
    for (std::uint32_t i = 0; i < rows.size(); ++i) {
        EXPECT_EQ(rows[i].key.id, i * 4096) << "in the order of their appearance";
        counted += rows[i].count;
    }
    EXPECT_EQ(counted, 2U * more) << "every frame is counted somewhere";
}

TEST(TrafficStatistics, TrailHasOneFrameEach50MillisecondsOf5Seconds)
{
    TrafficStatistics statistics;
    for (int i = 0; i < 1000; ++i)
        statistics.add(Direction::Received, countedFrame(5, start + i * 10ms, {static_cast<std::uint8_t>(i)}));
    std::vector<CanFrame> trail;
    const TrafficKey key = keyOf(Direction::Received, countedFrame(5, start));
    statistics.trail(key, Instant{}, trail);
    ASSERT_EQ(trail.size(), 100U);
    EXPECT_EQ(trail.front().time, start + 5s);
    for (std::size_t i = 1; i < trail.size(); ++i)
        EXPECT_EQ(trail[i].time - trail[i - 1].time, 50ms);
    const Instant seen = trail.back().time;
    trail.clear();
    statistics.trail(key, seen - 100ms, trail);
    EXPECT_EQ(trail.size(), 2U) << "only what is new";
    trail.clear();
    statistics.trail(keyOf(Direction::Sent, countedFrame(5, start)), Instant{}, trail);
    EXPECT_TRUE(trail.empty());
}

TEST(TrafficStatistics, TimeStampsThatStepBackAreCounted)
{
    TrafficStatistics statistics;
    statistics.add(Direction::Received, countedFrame(5, start + 100ms));
    statistics.add(Direction::Received, countedFrame(5, start + 40ms));
    statistics.add(Direction::Received, countedFrame(5, start + 100ms));
    EXPECT_EQ(only(statistics, start + 1s).rate, 3.0);
}

TEST(TrafficStatistics, StartsAfreshWhenCleared)
{
    TrafficStatistics statistics;
    for (std::uint32_t id = 0; id < 2000; ++id)
        statistics.add(Direction::Received, countedFrame(id, start));
    statistics.clear();
    EXPECT_EQ(statistics.unlisted(), 0U);
    statistics.add(Direction::Received, countedFrame(7, start));
    EXPECT_EQ(only(statistics, start).count, 1U);
}

} // namespace
} // namespace mb
