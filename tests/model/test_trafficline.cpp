// SPDX-License-Identifier: GPL-3.0-or-later
#include "traffic/trafficline.h"

#include <gtest/gtest.h>

#include <array>

namespace mb {
namespace {

using namespace std::chrono_literals;

TEST(TrafficLine, IsTheLineThatProductMdShows)
{
    const std::array<std::uint8_t, 3> bytes{0x55, 0x04, 0xFF};
    EXPECT_EQ(
        bytesLine(1436509052249713us, "ttyUSB0", Direction::Sent, bytes), "(1436509052.249713) ttyUSB0 tx 5504FF");
    EXPECT_EQ(bytesLine(0s, "spi0.0", Direction::Received, {}), "(0000000000.000000) spi0.0 rx ");
    EXPECT_EQ(bytesLine(-1s, "ttyUSB0", Direction::Received, bytes), "(0000000000.000000) ttyUSB0 rx 5504FF");
    EXPECT_EQ(hexText(bytes), "5504FF");
}

} // namespace
} // namespace mb
