// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/dmc60c/statusstream.h"

#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <memory>

namespace mb::dmc60c {

using namespace std::chrono_literals;

inline constexpr std::array<Channel, 2> streamTable{{{"a", "", "A", Quantity::Other}, {"b", "", "B", Quantity::Other}}};
inline constexpr ChannelIndex a{0};
inline constexpr ChannelIndex b{1};

/// Two channels with a period of 10 ms, from the first second on.
class Dmc60cStream : public testing::Test {
protected:
    /// One frame `gap` after the last.
    void after(Duration gap)
    {
        time += gap;
        stream.add(time, {static_cast<double>(++sent), 0.0});
    }
    std::uint64_t lost()
    {
        telemetry->commit();
        EXPECT_EQ(telemetry->lost(a), telemetry->lost(b));
        return telemetry->lost(a);
    }
    std::size_t recorded()
    {
        telemetry->commit();
        return telemetry->size(a);
    }

    std::shared_ptr<Telemetry> telemetry = std::make_shared<Telemetry>(streamTable);
    StatusStream stream{telemetry, {a, b}, 10ms};
    Instant time{1s};
    std::size_t sent = 0;
};

} // namespace mb::dmc60c
