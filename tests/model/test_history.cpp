// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/recording.h"

using namespace mb;
using namespace mb::test;

TEST(History, IsEmptyAtFirst)
{
    const History history;
    std::vector<Point> out(3);
    history.columns(at(0), at(1000), 100, out);
    EXPECT_TRUE(out.empty());
    EXPECT_TRUE(history.isEmpty());
    EXPECT_FALSE(history.first());
    EXPECT_FALSE(history.last());
    EXPECT_FALSE(history.at(at(10)));
    EXPECT_FALSE(history.extremes(at(0), at(10)));
    EXPECT_TRUE(history.gaps(at(0), at(10)).empty());
}

TEST(History, GivesTheExtremesThatBruteForceGives)
{
    const Recording recording(7, 70'000);
    std::mt19937 random(7);
    std::uniform_int_distribution<std::size_t> index(0, recording.plain.entries.size() - 1);
    for (int round = 0; round < 300; ++round) {
        const std::int64_t a = recording.microsOf(index(random));
        const std::int64_t b = a + (recording.microsOf(index(random)) - a) / (1 + round % 50);
        const Instant from = at(std::min(a, b));
        const Instant to = at(std::max(a, b));
        double low = std::numeric_limits<double>::infinity();
        double high = -low;
        for (const auto &entry : recording.plain.entries) {
            if (entry.point.time >= from && entry.point.time <= to) {
                low = std::min(low, entry.point.value);
                high = std::max(high, entry.point.value);
            }
        }
        const auto extremes = recording.history.extremes(from, to);
        ASSERT_EQ(extremes.has_value(), low <= high);
        if (extremes) {
            ASSERT_EQ(extremes->low, low);
            ASSERT_EQ(extremes->high, high);
        }
    }
}

TEST(History, FindsTheLastSampleAtOrBefore)
{
    const Recording recording(8, 20'000);
    const auto &entries = recording.plain.entries;
    EXPECT_FALSE(recording.history.at(entries.front().point.time - 1us));
    std::mt19937 random(8);
    std::uniform_int_distribution<std::int64_t> when(recording.microsOf(0), recording.microsOf(entries.size() - 1));
    for (int round = 0; round < 500; ++round) {
        const Instant time = at(when(random));
        const auto after = std::upper_bound(entries.begin(), entries.end(), time,
            [](Instant t, const Plain::Entry &entry) { return t < entry.point.time; });
        const auto found = recording.history.at(time);
        ASSERT_TRUE(found);
        ASSERT_TRUE(same(*found, std::prev(after)->point));
    }
    EXPECT_TRUE(same(*recording.history.at(Instant::max()), entries.back().point));
    EXPECT_TRUE(same(*recording.history.last(), entries.back().point));
    EXPECT_TRUE(same(*recording.history.first(), entries.front().point));
}

TEST(History, MergesGapsButLosesNoCount)
{
    History history;
    for (int i = 0; i < 1000; ++i) {
        history.append(at(i * 1000), 0.0);
        history.breakLine(2);
    }
    EXPECT_EQ(history.gaps(at(0), at(1'000'000)).size(), 999U);
    const auto merged = history.gaps(at(0), at(1'000'000), 100ms);
    ASSERT_EQ(merged.size(), 10U);
    EXPECT_EQ(merged[0].from, at(0));
    EXPECT_EQ(merged[0].to, at(100'000));
    EXPECT_EQ(merged[1].from, at(100'000));
    std::uint64_t lost = 0;
    for (const auto &gap : merged)
        lost += gap.lost;
    EXPECT_EQ(lost, 1998U);
    EXPECT_EQ(history.lost(), 2000U); // the last two before a sample that has not come
}

TEST(History, CountsWhatIsLostBeforeTheFirstSampleWithoutAGap)
{
    History history;
    history.breakLine(5);
    history.append(at(1000), 1.0);
    history.append(at(2000), 1.0);
    EXPECT_EQ(history.lost(), 5U);
    EXPECT_TRUE(history.gaps(at(0), at(9000)).empty());
    std::vector<Point> out;
    history.columns(at(0), at(9000), 100, out);
    EXPECT_EQ(out.size(), 2U);
    history.breakLine(1);
    history.append(at(3000), 1.0);
    ASSERT_EQ(history.gaps(at(0), at(9000)).size(), 1U);
    EXPECT_EQ(history.gaps(at(0), at(9000))[0].lost, 1U);
}

TEST(History, VisitsEverySampleForAnExport)
{
    const Recording recording(12, 20'000);
    const auto &entries = recording.plain.entries;
    for (const auto &[a, b] : {std::pair<std::size_t, std::size_t>{0, 19'999}, {300, 301}, {4000, 12'345}}) {
        std::vector<Point> expected;
        for (std::size_t i = 0; i < entries.size(); ++i) {
            if (entries[i].point.time < entries[a].point.time || entries[i].point.time > entries[b].point.time)
                continue;
            if (!expected.empty() && entries[i].broken)
                expected.push_back({entries[i - 1].point.time});
            expected.push_back(entries[i].point);
        }
        std::vector<Point> actual;
        recording.history.forEach(
            entries[a].point.time, entries[b].point.time, [&](const Point &point) { actual.push_back(point); });
        expectSame(expected, actual);
    }
}

TEST(History, CountsAreExactTo2To53)
{
    History history;
    const double most = 9007199254740992.0;
    history.append(at(1), most);
    history.append(at(2), most - 1.0);
    for (int i = 3; i < 100; ++i)
        history.append(at(i), -most + i);
    const auto extremes = history.extremes(at(0), at(1000));
    EXPECT_EQ(extremes->high, most);
    EXPECT_EQ(extremes->low, -most + 3);
    EXPECT_EQ(history.at(at(2))->value, most - 1.0);
}

TEST(History, ClampsATimeThatGoesBackAndCountsIt)
{
    History history;
    history.append(at(5000), 1.0);
    history.append(at(4000), 2.0);
    history.append(at(6000), 3.0);
    EXPECT_EQ(history.clamped(), 1U);
    EXPECT_EQ(history.size(), 3U);
    EXPECT_EQ(history.at(at(5000))->value, 2.0);
    EXPECT_FALSE(history.at(at(4999)));
}

TEST(History, KeepsWholeMicrosecondsRoundedDown)
{
    History history;
    const Instant time = at(7) + 999ns;
    history.append(time, 1.0);
    EXPECT_EQ(history.last()->time, at(7));
    EXPECT_TRUE(history.at(time));
    EXPECT_TRUE(history.extremes(time, time));
}

TEST(History, TakesWhatIsNotFiniteForALostSample)
{
    History history;
    history.append(at(1000), 1.0);
    history.append(at(2000), std::numeric_limits<double>::quiet_NaN());
    history.append(at(3000), std::numeric_limits<double>::infinity());
    history.append(at(4000), 2.0);
    EXPECT_EQ(history.size(), 2U);
    EXPECT_EQ(history.lost(), 2U);
    ASSERT_EQ(history.gaps(at(0), at(5000)).size(), 1U);
    EXPECT_EQ(history.gaps(at(0), at(5000))[0].lost, 2U);
}

TEST(History, SurvivesHoursBetweenSamples)
{
    History history;
    for (int hour = 0; hour < 100; ++hour)
        history.append(Instant(std::chrono::hours(hour)), hour);
    for (int hour = 0; hour < 100; ++hour) {
        ASSERT_EQ(history.at(Instant(std::chrono::hours(hour)))->value, hour);
        ASSERT_EQ(history.at(Instant(std::chrono::hours(hour)))->time, Instant(std::chrono::hours(hour)));
    }
    EXPECT_EQ(history.extremes(Instant(10h), Instant(50h))->high, 50.0);
}

TEST(History, NeedsAtMostSixteenBytesASample)
{
    History history;
    for (int i = 0; i < 1'000'000; ++i)
        history.append(at(std::int64_t{1000} * i), i % 100);
    EXPECT_LE(static_cast<double>(history.memoryUse()) / 1e6, 16.0);
}

TEST(History, ForgetsEverythingWhenCleared)
{
    Recording recording(13, 10'000);
    const std::uint64_t revision = recording.history.revision();
    recording.history.clear();
    EXPECT_GT(recording.history.revision(), revision);
    EXPECT_TRUE(recording.history.isEmpty());
    EXPECT_EQ(recording.history.lost(), 0U);
    EXPECT_TRUE(recording.history.gaps(Instant::min(), Instant::max()).empty());
    recording.history.append(at(-5), 4.0);
    EXPECT_EQ(recording.history.last()->time, at(-5));
    EXPECT_EQ(recording.history.clamped(), 0U);
}
