// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/registry.h"
#include "model/unknownframes.h"
#include "support/simulatedsession.h"

#include <gtest/gtest.h>

#include <array>

using namespace mb;

TEST(UnknownFrames, OnlyWhatNoFamilyKnowsIsCounted)
{
    UnknownFrames unknown(families());
    const CanFrame ours = extendedFrame(0x02061405, {0x00, 0x40, 0x11, 0, 0, 0, 0, 0}); // DMC60C status, unit 5
    const CanFrame theirs = extendedFrame(0x18FEF100, {1, 2, 3, 4, 5, 6, 7, 8});        // J1939 cruise control
    for (int i = 0; i < 100; ++i) {
        unknown.take(ours);
        unknown.take(theirs);
        unknown.take(theirs);
    }
    EXPECT_EQ(unknown.count(), 200U);
    CanFrame error;
    error.error = true;
    unknown.take(error);
    EXPECT_EQ(unknown.count(), 200U) << "an error frame is nobody's";
}

TEST(UnknownFrames, WhatAFamilyKnowsInAnyDialectIsKnown)
{
    constexpr std::array<std::uint8_t, 4> value{};
    UnknownFrames unknown(families());
    for (const std::uint32_t id : {1669U, 1004U, 1204U}) // voltage of dialect D, speed and current of dialect L
        unknown.take(standardFrame(id, value));
    EXPECT_EQ(unknown.count(), 0U);
    unknown.take(standardFrame(1764, value));
    EXPECT_EQ(unknown.count(), 1U);
}

TEST(UnknownFrames, NothingThatAScanSendsIsUnknown)
{
    test::SimulatedSession bench;
    UnknownFrames unknown(families());
    int sent = 0;
    const Subscription watching = bench.link->traffic().add([&](const Traffic &traffic) {
        sent += traffic.direction == Direction::Sent ? 1 : 0;
        unknown.take(*traffic.can);
    });
    bench.scan();
    bench.clock.advance(std::chrono::seconds(5));
    EXPECT_GT(sent, 100) << "probes of two families, and polls";
    EXPECT_EQ(unknown.count(), 0U);
}

TEST(UnknownFrames, AFloodOfIdentifiersStaysExact)
{
    UnknownFrames unknown(families());
    for (std::uint32_t i = 0; i < 50'000; ++i)
        unknown.take(extendedFrame(0x18000000 + i, {}));
    EXPECT_EQ(unknown.count(), 50'000U);
}

TEST(UnknownFrames, ARequestForAFrameIsNotThatFrame)
{
    UnknownFrames unknown(families());
    const CanFrame ours = extendedFrame(0x02061405, {0x00, 0x40, 0x11, 0, 0, 0, 0, 0});
    CanFrame request = ours;
    request.remote = true;
    for (int i = 0; i < 3; ++i) {
        unknown.take(ours);
        unknown.take(request);
    }
    EXPECT_EQ(unknown.count(), 3U);
    CanFrame shorter = ours;
    shorter.size = 3;
    unknown.take(shorter);
    EXPECT_EQ(unknown.count(), 4U) << "nor is a part of it";
}
