// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/history.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace {

using namespace mb;
using namespace std::chrono_literals;

Instant at(std::int64_t micros)
{
    return Instant(std::chrono::microseconds(micros));
}

/// The same recording as plain vectors, and every query the slow and obvious way.
struct Plain {
    struct Entry {
        Point point;
        bool broken = false; ///< does not connect to the one before
        std::uint64_t lost = 0;
    };
    std::vector<Entry> entries;
    bool broken = false;
    std::uint64_t lost = 0;

    void append(Instant time, double value)
    {
        entries.push_back({{time, value}, broken, lost});
        broken = false;
        lost = 0;
    }
    void breakLine(std::uint64_t count)
    {
        broken = true;
        lost += count;
    }
    [[nodiscard]] std::vector<Point> columns(Instant from, Instant to, int pixels) const;
    [[nodiscard]] std::vector<History::Gap> gaps(Instant from, Instant to) const
    {
        std::vector<History::Gap> found;
        for (std::size_t i = 1; i < entries.size(); ++i) {
            const Instant begin = entries[i - 1].point.time;
            if (entries[i].broken && entries[i].point.time >= from && begin <= to)
                found.push_back({begin, entries[i].point.time, entries[i].lost});
        }
        return found;
    }
};

std::int64_t columnOf(Instant time, Duration width)
{
    const auto count = time.time_since_epoch().count();
    const auto w = width.count();
    return count >= 0 ? count / w : -((-count + w - 1) / w);
}

std::vector<Point> Plain::columns(Instant from, Instant to, int pixels) const
{
    std::vector<Point> out;
    const Duration width = History::columnWidth(from, to, pixels);
    const auto add = [&](std::size_t i, bool inside) {
        if (!inside && !out.empty() && entries[i].broken)
            out.push_back({out.back().time});
        out.push_back(entries[i].point);
    };
    std::size_t i = 0;
    while (i < entries.size() && columnOf(entries[i].point.time, width) < columnOf(from, width))
        ++i;
    if (i > 0)
        add(i - 1, true);
    while (i < entries.size() && columnOf(entries[i].point.time, width) <= columnOf(to, width)) {
        std::size_t j = i;
        while (j < entries.size() && columnOf(entries[j].point.time, width) == columnOf(entries[i].point.time, width))
            ++j;
        std::vector<std::size_t> picked;
        for (std::size_t k = i; k < j; ++k)
            picked.push_back(k);
        if (picked.size() > 4) {
            const auto less
                = [this](std::size_t a, std::size_t b) { return entries[a].point.value < entries[b].point.value; };
            const std::size_t low = *std::min_element(picked.begin(), picked.end(), less);
            const std::size_t high = *std::max_element(
                picked.begin(), picked.end(), [&](auto a, auto b) { return less(a, b) || (!less(b, a) && a > b); });
            picked = {i, low, high, j - 1};
            std::sort(picked.begin(), picked.end());
            picked.erase(std::unique(picked.begin(), picked.end()), picked.end());
        }
        const bool dense = j - i > 4;
        for (const std::size_t k : picked)
            add(k, dense && k != i);
        i = j;
    }
    if (i < entries.size())
        add(i, false);
    return out;
}

bool same(const Point &a, const Point &b)
{
    return a.time == b.time && ((a.isGap() && b.isGap()) || a.value == b.value);
}

void expectSame(const std::vector<Point> &expected, const std::vector<Point> &actual)
{
    ASSERT_EQ(expected.size(), actual.size());
    for (std::size_t i = 0; i < expected.size(); ++i)
        ASSERT_TRUE(same(expected[i], actual[i]))
            << "point " << i << ": expected " << expected[i].value << ", is " << actual[i].value;
}

/// Regular stretches, bursts with equal times, pauses beyond 32 bits of microseconds, gaps and lost samples.
struct Recording {
    Plain plain;
    History history;

    Recording(unsigned seed, int count, std::int64_t start = 0)
    {
        std::mt19937 random(seed);
        std::uniform_int_distribution<int> dice(0, 999);
        std::normal_distribution<double> noise;
        std::int64_t time = start;
        std::int64_t period = 1000;
        for (int i = 0; i < count; ++i) {
            const int throwOf = dice(random);
            if (throwOf < 5)
                period = 1 + dice(random) * dice(random);
            if (throwOf == 5)
                time += 5'000'000'000;
            if (throwOf > 990) {
                const auto lost = static_cast<std::uint64_t>(dice(random) % 3);
                plain.breakLine(lost);
                history.breakLine(lost);
            }
            time += throwOf % 10 == 0 ? 0 : period;
            const double value = throwOf % 7 == 0 ? 1.0 : noise(random);
            plain.append(at(time), value);
            history.append(at(time), value);
        }
    }
    [[nodiscard]] std::int64_t microsOf(std::size_t index) const
    {
        return plain.entries[index].point.time.time_since_epoch() / 1us;
    }
};

} // namespace

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

TEST(History, GivesTheColumnsThatBruteForceGives)
{
    for (unsigned seed = 1; seed <= 6; ++seed) {
        const Recording recording(seed, seed == 1 ? 40'000 : 9'000, seed % 2 == 0 ? -3'000'000'000 : 17);
        const std::size_t count = recording.plain.entries.size();
        std::mt19937 random(seed);
        std::uniform_int_distribution<std::size_t> index(0, count - 1);
        std::uniform_int_distribution<std::int64_t> shift(-5000, 5000);
        std::uniform_int_distribution<int> pixels(1, 2000);
        std::vector<Point> out;
        for (int round = 0; round < 60; ++round) {
            const std::int64_t a = recording.microsOf(index(random)) + shift(random);
            const std::int64_t b = recording.microsOf(index(random)) + shift(random);
            const int columns = pixels(random);
            recording.history.columns(at(std::min(a, b)), at(std::max(a, b)), columns, out);
            expectSame(recording.plain.columns(at(std::min(a, b)), at(std::max(a, b)), columns), out);
        }
        recording.history.columns(Instant::min(), Instant::max(), 100, out);
        EXPECT_LE(out.size(), 500U);
    }
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

TEST(History, KeepsAOneSampleSpikeAtEveryZoom)
{
    constexpr int count = 300'000;
    constexpr int spike = 123'457;
    History history;
    for (int i = 0; i < count; ++i)
        history.append(at(i * 1000), i == spike ? 9.0 : (i == spike + 5000 ? -9.0 : 0.001 * (i % 7)));
    std::vector<Point> out;
    for (int pixels = 1; pixels <= 4000; pixels = pixels * 3 / 2 + 1) {
        for (std::int64_t window = 20'000'000; window <= 600'000'000; window = window * 3 / 2) {
            const Instant from = at(spike * 1000 - window / 2);
            history.columns(from, from + std::chrono::microseconds(window), pixels, out);
            for (const auto &[time, value] : {std::pair(spike, 9.0), std::pair(spike + 5000, -9.0)}) {
                const bool found = std::any_of(out.begin(), out.end(),
                    [&, wanted = Point{at(time * 1000), value}](const Point &p) { return same(p, wanted); });
                ASSERT_TRUE(found) << pixels << " pixels, " << window << " us";
            }
        }
    }
}

TEST(History, DoesNotShimmerWhileScrolling)
{
    History history;
    std::mt19937 random(9);
    std::normal_distribution<double> noise;
    for (int i = 0; i < 60'000; ++i) {
        if (i % 97 == 0)
            history.breakLine(1);
        history.append(at(i * 1000), noise(random));
    }
    const Instant from = at(10'000'123);
    const Instant to = at(40'000'456);
    const Duration width = History::columnWidth(from, to, 300);
    std::vector<Point> still;
    std::vector<Point> scrolled;
    history.columns(from, to, 300, still);
    ASSERT_GT(still.size(), 1000U);
    for (const Duration by : {width, 7 * width, 100 * width, width / 3, 20 * width + 17us}) {
        history.columns(from + by, to + by, 300, scrolled);
        // What both windows show is the same, but for the sample at the edge that closes each of them.
        const Instant begin = scrolled[1].time;
        const Instant end = still[still.size() - 2].time;
        const auto cut = [&](const std::vector<Point> &points) {
            std::vector<Point> both;
            std::copy_if(points.begin(), points.end(), std::back_inserter(both),
                [&](const Point &p) { return p.time >= begin && p.time <= end; });
            return both;
        };
        expectSame(cut(still), cut(scrolled));
        EXPECT_GT(cut(still).size(), 500U);
    }
    // Nor when the window breathes by a nanosecond.
    EXPECT_EQ(History::columnWidth(from, to + 1ns, 300), width);
}

TEST(History, AWindowThatIsKeptHasTheSameColumns)
{
    std::mt19937 random(14);
    std::uniform_int_distribution<int> dice(0, 99);
    std::normal_distribution<double> noise;
    History history;
    ColumnWindow window;
    std::vector<Point> expected;
    std::int64_t time = 0;
    Duration span = 2s;
    int pixels = 200;
    Duration back{};
    std::size_t longest = 0;
    for (int frame = 0; frame < 4000; ++frame) {
        for (int i = dice(random) / 5; i > 0; --i) {
            if (dice(random) == 0)
                time += 300'000;
            if (dice(random) < 3)
                history.breakLine(1);
            history.append(at(time += 1000), noise(random));
        }
        const int event = dice(random);
        if (event == 0)
            span = std::chrono::milliseconds(10 + 100 * dice(random));
        if (event == 1)
            pixels = 1 + 7 * dice(random);
        if (event == 2 && dice(random) < 5)
            history.clear();
        if (event > 90) // the user drags
            back = std::max(Duration::zero(), back + (dice(random) - 50) * 20ms);
        if (event == 3)
            back = Duration::zero();
        const Instant to = at(time) - back;
        history.columns(to - span, to, pixels, window);
        history.columns(to - span, to, pixels, expected);
        expectSame(expected, window.points());
        if (HasFatalFailure())
            FAIL() << "frame " << frame;
        longest = std::max(longest, history.size());
    }
    EXPECT_GT(longest, 5000U);
}

TEST(History, AWindowThatIsKeptCostsOnlyWhatIsNew)
{
    History history;
    for (int i = 0; i < 1'000'000; ++i)
        history.append(at(std::int64_t{1000} * i), i % 11);
    ColumnWindow window;
    const Instant to = at(900'000'000);
    history.columns(to - 800s, to, 1600, window);
    const std::uint64_t before = history.visited();
    history.columns(to - 800s + 17ms, to + 17ms, 1600, window);
    history.columns(to - 800s + 2s, to + 2s, 1600, window);
    history.columns(to - 800s, to, 1600, window);
    EXPECT_LE(history.visited() - before, 20U * 100U);
}

TEST(History, AWindowMaySwitchToAnotherHistory)
{
    History first;
    History second;
    for (int i = 0; i < 100; ++i) {
        first.append(at(1000 * i), 1.0);
        second.append(at(1000 * i), 2.0);
    }
    ColumnWindow window;
    first.columns(at(0), at(100'000), 50, window);
    second.columns(at(0), at(100'000), 50, window);
    ASSERT_EQ(window.points().size(), 100U);
    EXPECT_EQ(window.points().front().value, 2.0);
    History().columns(at(0), at(100'000), 50, window);
    EXPECT_TRUE(window.points().empty());
}

TEST(History, ColumnsAreAtMostAPixelWide)
{
    std::mt19937_64 random(10);
    std::uniform_int_distribution<std::int64_t> micros(1'000'000, 100'000'000'000);
    for (int round = 0; round < 1000; ++round) {
        const auto span = std::chrono::microseconds(micros(random));
        const Duration pixel = Duration(span) / 1600;
        const Duration width = History::columnWidth(at(0), at(0) + span, 1600);
        EXPECT_LE(width, pixel);
        EXPECT_GE(width, pixel - pixel / 64 - 1us);
    }
}

TEST(History, CostDependsOnTheWidthNotOnTheLength)
{
    constexpr int pixels = 1000;
    std::vector<std::uint64_t> costs;
    std::vector<Point> out;
    for (const int count : {100'000, 1'000'000, 4'000'000}) {
        History history;
        for (int i = 0; i < count; ++i)
            history.append(at(std::int64_t{1000} * i), i % 13);
        const std::uint64_t before = history.visited();
        history.columns(at(0), at(std::int64_t{1000} * count), pixels, out);
        costs.push_back(history.visited() - before);
        EXPECT_LE(out.size(), 4U * pixels * 65 / 64 + 8);
    }
    // 15 samples and 15 nodes a level at each end of a column are the worst; chunks and the search come on top.
    for (const std::uint64_t cost : costs)
        EXPECT_LE(cost, pixels * 100U);
    EXPECT_LE(costs[2], costs[1] * 3 / 2);
}

TEST(History, ShowsEveryGapThatIsWiderThanAColumn)
{
    History history;
    for (int i = 0; i < 10'000; ++i) {
        if (i == 2500)
            history.breakLine(10);
        if (i == 7500)
            history.breakLine();
        history.append(at(i * 1000 + (i >= 2500 ? 900'000 : 0) + (i >= 7500 ? 5'000'000 : 0)), 1.0);
    }
    EXPECT_EQ(history.lost(), 10U);
    std::vector<Point> out;
    history.columns(at(0), at(16'000'000), 100, out);
    const auto gaps = std::count_if(out.begin(), out.end(), [](const Point &p) { return p.isGap(); });
    EXPECT_EQ(gaps, 2);
    const auto first = std::find_if(out.begin(), out.end(), [](const Point &p) { return p.isGap(); });
    EXPECT_EQ(std::prev(first)->time, at(2'499'000));
    EXPECT_EQ(first->time, at(2'499'000));
    EXPECT_EQ(std::next(first)->time, at(3'400'000));
}

TEST(History, ListsTheGapsThatTouchAWindow)
{
    const Recording recording(11, 30'000);
    std::mt19937 random(11);
    std::uniform_int_distribution<std::size_t> index(0, recording.plain.entries.size() - 1);
    std::size_t seen = 0;
    for (int round = 0; round < 50; ++round) {
        const std::size_t a = index(random);
        const std::size_t b = std::min(a + index(random) / 10, recording.plain.entries.size() - 1);
        const auto expected = recording.plain.gaps(at(recording.microsOf(a)), at(recording.microsOf(b)));
        const auto actual = recording.history.gaps(at(recording.microsOf(a)), at(recording.microsOf(b)));
        ASSERT_EQ(expected.size(), actual.size());
        for (std::size_t i = 0; i < expected.size(); ++i) {
            ASSERT_EQ(expected[i].from, actual[i].from);
            ASSERT_EQ(expected[i].to, actual[i].to);
            ASSERT_EQ(expected[i].lost, actual[i].lost);
        }
        seen += actual.size();
    }
    EXPECT_GT(seen, 100U);
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
