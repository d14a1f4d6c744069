// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a loop has settled is asked at every beat of its hold: what that takes must not grow with the hold.
#include "experiment/recentextremes.h"

#include <gtest/gtest.h>

#include <random>

namespace mb::tuning {
namespace {

std::size_t comparisons = 0;

struct Counted {
    double value = 0.0;
    friend bool operator<(const Counted &a, const Counted &b)
    {
        ++comparisons;
        return a.value < b.value;
    }
    friend Counted operator-(const Counted &a, const Counted &b) { return {a.value - b.value}; }
};

TEST(RecentExtremes, AreThoseOfAllValuesSinceThen)
{
    std::mt19937 random(7);
    std::uniform_int_distribution<int> value(-20, 20);
    RecentExtremes<int, int> recent;
    std::vector<int> all;
    EXPECT_FALSE(recent.spread(0));
    for (int now = 0; now < 300; ++now) {
        all.push_back(value(random));
        recent.add(2 * now, all.back());
        for (int since = 0; since <= now; ++since) {
            const auto [least, greatest] = std::minmax_element(all.begin() + since, all.end());
            ASSERT_EQ(recent.spread(2 * since), *greatest - *least);
            ASSERT_EQ(recent.spread(2 * since - 1), *greatest - *least);
        }
        ASSERT_FALSE(recent.spread(2 * now + 1));
    }
}

TEST(RecentExtremes, OfALongHoldTakeNoMoreASampleThanThoseOfAShortOne)
{
    const auto workOf = [](int samples) {
        std::mt19937 random(7);
        std::normal_distribution<double> noise;
        RecentExtremes<Counted, Counted> recent;
        comparisons = 0;
        for (int now = 0; now < samples; ++now) {
            recent.add({static_cast<double>(now)}, {noise(random)});
            (void)recent.spread({now / 2.0});
        }
        return static_cast<double>(comparisons) / samples;
    };
    EXPECT_LT(workOf(1'000), 20.0);
    EXPECT_LT(workOf(100'000), 20.0) << "half of the hold each time would be 25 000";
}

} // namespace
} // namespace mb::tuning
