// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/recording.h"

using namespace mb;
using namespace mb::test;

TEST(HistoryColumns, GivesTheColumnsThatBruteForceGives)
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

TEST(HistoryColumns, KeepsAOneSampleSpikeAtEveryZoom)
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

TEST(HistoryColumns, DoesNotShimmerWhileScrolling)
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

TEST(HistoryColumns, AWindowThatIsKeptHasTheSameColumns)
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

TEST(HistoryColumns, AWindowThatIsKeptCostsOnlyWhatIsNew)
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

TEST(HistoryColumns, AWindowMaySwitchToAnotherHistory)
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

TEST(HistoryColumns, ColumnsAreAtMostAPixelWide)
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

TEST(HistoryColumns, CostDependsOnTheWidthNotOnTheLength)
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

TEST(HistoryColumns, ShowsEveryGapThatIsWiderThanAColumn)
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

TEST(HistoryColumns, ListsTheGapsThatTouchAWindow)
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
