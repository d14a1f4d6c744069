// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording.h"
#include "telemetry/chunkstore.h"

#include <cmath>
#include <filesystem>
#include <fstream>

namespace mb {
namespace {

using test::at;

constexpr std::size_t tiny = 1; ///< every full chunk goes to the file

std::shared_ptr<ChunkStore> storeOf(std::size_t budget)
{
    return std::make_shared<ChunkStore>(std::filesystem::temp_directory_path().string(), budget);
}

/// The same samples in memory and behind a store.
struct Pair {
    test::Recording plain;
    History stored;

    Pair(unsigned seed, int count, const std::shared_ptr<ChunkStore> &store)
        : plain(seed, count)
    {
        stored.keepIn(store);
        for (const auto &entry : plain.plain.entries) {
            if (entry.broken)
                stored.breakLine(entry.lost);
            stored.append(entry.point.time, entry.point.value);
        }
    }
};

History::Statistics slowly(const test::Plain &plain, Instant from, Instant to)
{
    History::Statistics slow;
    std::vector<double> values;
    for (std::size_t i = 0; i < plain.entries.size(); ++i) {
        const auto &entry = plain.entries[i];
        if (entry.point.time < from || entry.point.time > to)
            continue;
        if (!values.empty())
            slow.lost += entry.lost;
        values.push_back(entry.point.value);
    }
    slow.count = values.size();
    if (values.empty())
        return slow;
    long double sum = 0;
    long double squares = 0;
    for (const double value : values) {
        sum += value;
        squares += static_cast<long double>(value) * value;
    }
    const auto count = static_cast<long double>(values.size());
    slow.mean = static_cast<double>(sum / count);
    slow.rms = static_cast<double>(std::sqrt(squares / count));
    long double spread = 0;
    for (const double value : values)
        spread += (value - sum / count) * (value - sum / count);
    slow.deviation = static_cast<double>(std::sqrt(spread / count));
    slow.low = *std::min_element(values.begin(), values.end());
    slow.high = *std::max_element(values.begin(), values.end());
    return slow;
}

TEST(HistoryStore, WhatIsInTheFileReadsAsIfItWereInMemory)
{
    const Pair pair(3, 60'000, storeOf(tiny));
    const auto first = pair.plain.history.first()->time;
    const auto last = pair.plain.history.last()->time;
    std::vector<Point> expected;
    std::vector<Point> actual;
    std::mt19937 random(4);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    for (int i = 0; i < 60; ++i) {
        const auto span = last - first;
        const Instant from
            = first + Duration(static_cast<std::int64_t>(part(random) * static_cast<double>(span.count())));
        const Instant to = from
            + Duration(
                static_cast<std::int64_t>(std::pow(part(random), 6) * static_cast<double>((last - from).count())));
        pair.plain.history.columns(from, to, 300, expected);
        pair.stored.columns(from, to, 300, actual);
        test::expectSame(expected, actual);
        pair.plain.history.read(pair.plain.history.lowerBound(from), to, 5000, expected);
        pair.stored.read(pair.stored.lowerBound(from), to, 5000, actual);
        test::expectSame(expected, actual);
    }
    EXPECT_EQ(pair.stored.lost(), pair.plain.history.lost());
}

TEST(HistoryStore, MemoryStaysWithinTheBudgetHoweverLongTheRecording)
{
    const auto store = storeOf(1'000'000);
    History history;
    history.keepIn(store);
    for (std::int64_t i = 0; i < 2'000'000; ++i)
        history.append(at(i * 1000), static_cast<double>(i));
    EXPECT_LE(store->resident(), 1'000'000U + 60'000U); // and the chunk that is being filled
    EXPECT_LE(history.memoryUse(), 1'200'000U);
    EXPECT_GT(store->stored(), 20'000'000U);
    EXPECT_EQ(store->failure(), "");
    EXPECT_EQ(history.at(at(5'000'000))->value, 5000.0);
}

TEST(HistoryStore, ASpikeThatWentToTheFileIsSeenFromAboveAndFromNear)
{
    History history;
    history.keepIn(storeOf(tiny));
    for (std::int64_t i = 0; i < 3'600'000; ++i)
        history.append(at(i * 1000), i == 1'234'567 ? 1e6 : 0.0);
    std::vector<Point> points;
    for (const std::int64_t span : {3'600'000'000LL, 60'000'000LL, 1'000'000LL, 2'000LL}) {
        history.columns(at(1'234'567'000 - span / 3), at(1'234'567'000 + span / 3), 1000, points);
        EXPECT_TRUE(std::any_of(points.begin(), points.end(), [](const Point &p) { return p.value == 1e6; })) << span;
    }
}

TEST(HistoryStore, ClearingGivesTheRoomBackAndIsUsedAgain)
{
    const auto store = storeOf(tiny);
    History history;
    history.keepIn(store);
    for (int round = 0; round < 3; ++round) {
        for (int i = 0; i < 300'000; ++i)
            history.append(at(i * 1000), i);
        EXPECT_GT(store->stored(), 3'000'000U);
        EXPECT_LT(store->stored(), 5'000'000U);
        history.clear();
        EXPECT_EQ(store->stored(), 0U);
        EXPECT_EQ(store->resident(), 0U);
    }
}

TEST(HistoryStore, WithoutADiskSamplesStayInMemoryAndTheCauseIsKnown)
{
    const auto store = std::make_shared<ChunkStore>("/nonexistent/folder", tiny);
    History history;
    history.keepIn(store);
    for (int i = 0; i < 30'000; ++i)
        history.append(at(i * 1000), i);
    EXPECT_EQ(history.size(), 30'000U);
    EXPECT_EQ(history.first()->value, 0.0);
    EXPECT_EQ(store->stored(), 0U);
    EXPECT_NE(store->failure().english().find("/nonexistent/folder"), std::string::npos);
}

TEST(HistoryStore, ADiskIsNotFilledToItsLastByte)
{
    const std::string folder = std::filesystem::temp_directory_path().string();
    const auto spared = static_cast<std::uint64_t>(std::filesystem::space(folder).capacity);
    const auto store = std::make_shared<ChunkStore>(folder, tiny, spared);
    History history;
    history.keepIn(store);
    for (int i = 0; i < 30'000; ++i)
        history.append(at(i * 1000), i);
    EXPECT_EQ(history.first()->value, 0.0);
    EXPECT_EQ(store->stored(), 0U);
    EXPECT_NE(store->failure().english().find("left to others"), std::string::npos) << store->failure().english();
}

TEST(HistoryStatistics, AgreeWithTheSlowWayOnRandomStretches)
{
    const Pair pair(5, 30'000, storeOf(200'000));
    const auto &entries = pair.plain.plain.entries;
    std::mt19937 random(6);
    std::uniform_int_distribution<std::size_t> place(0, entries.size() - 1);
    for (int i = 0; i < 300; ++i) {
        const auto [a, b] = std::minmax({place(random), place(random)});
        const Instant from = entries[a].point.time;
        const Instant to = entries[b].point.time;
        const auto slow = slowly(pair.plain.plain, from, to);
        const auto fast = pair.stored.statistics(from, to);
        ASSERT_TRUE(fast);
        EXPECT_EQ(fast->count, slow.count);
        EXPECT_EQ(fast->lost, slow.lost);
        EXPECT_NEAR(fast->mean, slow.mean, 1e-12);
        EXPECT_NEAR(fast->deviation, slow.deviation, 1e-9);
        EXPECT_NEAR(fast->rms, slow.rms, 1e-12);
        EXPECT_EQ(fast->low, slow.low);
        EXPECT_EQ(fast->high, slow.high);
    }
    EXPECT_FALSE(pair.stored.statistics(at(-10), at(-5)));
}

TEST(HistoryStatistics, LargeCountsDoNotSwallowASmallRipple)
{
    History history;
    for (int i = 0; i < 100'000; ++i)
        history.append(at(i * 1000), 4e15 + (i % 2));
    const auto found = history.statistics(at(0), at(1'000'000'000));
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->deviation, 0.5, 1e-9);
    EXPECT_EQ(found->mean, 4e15 + 0.5);
}

} // namespace
} // namespace mb
