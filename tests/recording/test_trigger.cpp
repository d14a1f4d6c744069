// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/trigger.h"
#include "signals.h"

#include <gtest/gtest.h>

namespace mb {
namespace {

using namespace test;
using Kind = TriggerRule::Kind;

std::vector<std::int64_t> firedAt(const TriggerRule &rule, const std::vector<double> &values)
{
    TriggerScanner scanner(rule);
    std::vector<std::int64_t> fired;
    std::int64_t time = 0;
    for (const double value : values) {
        if (const auto at = scanner.feed({ms(time++ * 10), value}))
            fired.push_back(at->time_since_epoch() / 1ms);
    }
    return fired;
}

const double gap = std::numeric_limits<double>::quiet_NaN();

TEST(Trigger, ARisingEdgeFiresWhereTheLineCrossesTheLevel)
{
    EXPECT_EQ(firedAt({Kind::Rising, 5.0, 0.0}, {0, 0, 10, 10, 0, 10}), (std::vector<std::int64_t>{15, 45}));
    EXPECT_EQ(firedAt({Kind::Rising, 2.0, 0.0}, {0, 10}), (std::vector<std::int64_t>{2}));
}

TEST(Trigger, AFallingEdgeFiresDownwardsOnly)
{
    EXPECT_EQ(firedAt({Kind::Falling, 5.0, 0.0}, {0, 10, 0, 0, 10, 0}), (std::vector<std::int64_t>{15, 45}));
    EXPECT_EQ(firedAt({Kind::Falling, -5.0, 0.0}, {0, -10}), (std::vector<std::int64_t>{5}));
}

TEST(Trigger, EitherFiresBothWays)
{
    EXPECT_EQ(firedAt({Kind::Either, 5.0, 0.0}, {0, 10, 0}), (std::vector<std::int64_t>{5, 15}));
}

TEST(Trigger, WhatBeginsAboveTheLevelHasNotCrossedIt)
{
    EXPECT_TRUE(firedAt({Kind::Rising, 5.0, 0.0}, {10, 10, 20}).empty());
    EXPECT_TRUE(firedAt({Kind::Falling, 5.0, 0.0}, {0, 0, 1}).empty());
}

TEST(Trigger, NoiseAtTheLevelIsOneEdgeWithHysteresis)
{
    const std::vector<double> noisy{0, 5.1, 4.9, 5.1, 4.9, 10, 0, 5.1, 4.9, 5.1};
    EXPECT_EQ(firedAt({Kind::Rising, 5.0, 0.0}, noisy).size(), 5U);
    EXPECT_EQ(firedAt({Kind::Rising, 5.0, 1.0}, noisy).size(), 2U);
}

TEST(Trigger, AnEdgeIsNotMadeUpAcrossAGap)
{
    EXPECT_TRUE(firedAt({Kind::Rising, 5.0, 0.0}, {0, gap, 10}).empty());
    EXPECT_TRUE(firedAt({Kind::Either, 5.0, 0.0}, {10, gap, 0}).empty());
    EXPECT_EQ(firedAt({Kind::Rising, 5.0, 0.0}, {0, gap, 0, 10}).size(), 1U);
}

TEST(Trigger, LevelFiresWhileItHolds)
{
    EXPECT_EQ(firedAt({Kind::Above, 5.0, 0.0}, {0, 6, 7, 0}), (std::vector<std::int64_t>{10, 20}));
    EXPECT_EQ(firedAt({Kind::Below, 5.0, 0.0}, {6, 4, 6}), (std::vector<std::int64_t>{10}));
}

TEST(TriggerSearch, GoesOnWhereItWasWhenMoreIsRecorded)
{
    const auto recording = telemetry();
    TriggerSearch search({Kind::Rising, 5.0, 0.0}, recording, velocity, ms(0));
    EXPECT_FALSE(search.poll(ms(0)));
    put(*recording, velocity, 10, 0);
    EXPECT_FALSE(search.poll(ms(0)));
    put(*recording, velocity, 20, 10); // the edge lies between two looks
    EXPECT_EQ(search.poll(ms(0)), ms(15));
    EXPECT_FALSE(search.poll(ms(0)));
}

TEST(TriggerSearch, LeavesOutWhatIsBeforeAndAnswersOneAtATime)
{
    const auto recording = telemetry();
    for (int i = 0; i < 100; ++i)
        put(*recording, velocity, i * 10, i % 2 == 0 ? 0 : 10);
    TriggerSearch search({Kind::Rising, 5.0, 0.0}, recording, velocity, ms(105));
    EXPECT_EQ(search.poll(ms(200)), ms(205));
    EXPECT_EQ(search.poll(ms(300)), ms(305));
}

TEST(TriggerSearch, StartsAnewAfterTheRecordingWasCleared)
{
    const auto recording = telemetry();
    for (int i = 0; i < 10; ++i)
        put(*recording, velocity, i * 10, 0);
    TriggerSearch search({Kind::Rising, 5.0, 0.0}, recording, velocity, ms(0));
    EXPECT_FALSE(search.poll(ms(0)));
    recording->clear();
    put(*recording, velocity, 200, 0);
    put(*recording, velocity, 210, 10);
    EXPECT_EQ(search.poll(ms(0)), ms(205));
}

} // namespace
} // namespace mb
