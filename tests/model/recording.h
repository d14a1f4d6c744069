// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "telemetry/history.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

/// What the tests of History compare it with.
namespace mb::test {

using namespace std::chrono_literals;

inline Instant at(std::int64_t micros)
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

inline std::int64_t columnOf(Instant time, Duration width)
{
    const auto count = time.time_since_epoch().count();
    const auto w = width.count();
    return count >= 0 ? count / w : -((-count + w - 1) / w);
}

inline std::vector<Point> Plain::columns(Instant from, Instant to, int pixels) const
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

inline bool same(const Point &a, const Point &b)
{
    return a.time == b.time && ((a.isGap() && b.isGap()) || a.value == b.value);
}

inline void expectSame(const std::vector<Point> &expected, const std::vector<Point> &actual)
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

} // namespace mb::test
