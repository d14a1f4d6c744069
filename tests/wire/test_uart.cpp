// SPDX-License-Identifier: GPL-3.0-or-later
#include "wire/uart.h"

#include <gtest/gtest.h>

#include <array>
#include <numeric>

using namespace mb;

namespace {

std::vector<std::uint8_t> valuesOf(const std::vector<UartByte> &heard)
{
    std::vector<std::uint8_t> values;
    for (const UartByte &byte : heard) {
        EXPECT_FALSE(byte.framingError);
        values.push_back(byte.value);
    }
    return values;
}

std::vector<std::uint8_t> everyByte()
{
    std::vector<std::uint8_t> all(256);
    std::iota(all.begin(), all.end(), std::uint8_t{0});
    return all;
}

} // namespace

TEST(Uart, HearsEveryByteAtTheSameRateAndAtRatesAFewPercentOff)
{
    const auto all = everyByte();
    for (const double ratio : {1.0, 0.96, 1.04, 57600.0 / 59524.0, 119048.0 / 115200.0})
        EXPECT_EQ(valuesOf(sampledAt(all, ratio)), all) << ratio;
}

TEST(Uart, AByteSentAtHalfTheRateIsReadAsItsFirstBitsTwiceEach)
{
    const std::array<std::uint8_t, 1> sent{0xFC};
    // Low: the start bit and bits 0 and 1. In half bits: start, 0 0 0 0 0 1 1 1, stop.
    EXPECT_EQ(sampledAt(sent, 0.5), (std::vector<UartByte>{{0xE0, false}}));
}

TEST(Uart, AByteSentTwelveTimesSlowerIsABreakForEachOfItsLowRuns)
{
    const std::array<std::uint8_t, 1> sent{0x55};
    const auto heard = sampledAt(sent, 9600.0 / 115200.0);
    ASSERT_EQ(heard.size(), 5U); // the start bit and four zeros
    for (const UartByte &byte : heard)
        EXPECT_EQ(byte, (UartByte{0, true}));
}

TEST(Uart, AStopBitIsLookedForInItsMiddle)
{
    // A receiver that is 4.9 % too slow still meets the stop bit of 00, one that is 5.9 % too slow the start of what follows.
    const std::array<std::uint8_t, 2> sent{0x00, 0x00};
    EXPECT_EQ(sampledAt(sent, 1.049), (std::vector<UartByte>{{0, false}, {0, false}}));
    EXPECT_EQ(sampledAt(sent, 1.059).front(), (UartByte{0, true}));
    EXPECT_EQ(sampledAt(sent, 0.951), (std::vector<UartByte>{{0, false}, {0, false}}));
    EXPECT_EQ(sampledAt(sent, 0.941).front(), (UartByte{0, true})) << "its stop bit is still the last bit of the byte";
}

TEST(Uart, AByteSentThreeTimesFasterIsWhatIsThereInTheMiddleOfEachBit)
{
    // FF is low for its start bit only. It is over before its middle: a spike, and no byte.
    const std::array<std::uint8_t, 1> spike{0xFF};
    EXPECT_TRUE(sampledAt(spike, 3.0).empty());
    // F0: low for five bits, middles at 1.5, 4.5 and 7.5 bits: a start bit, a zero, and ones.
    const std::array<std::uint8_t, 1> low{0xF0};
    EXPECT_EQ(sampledAt(low, 3.0), (std::vector<UartByte>{{0xFE, false}}));
    // A spike is passed over, and what comes after it is heard.
    const std::array<std::uint8_t, 2> both{0xFF, 0xF0};
    EXPECT_EQ(sampledAt(both, 3.0), (std::vector<UartByte>{{0xFE, false}}));
}

TEST(Uart, NothingSentIsNothingHeard)
{
    EXPECT_TRUE(sampledAt({}, 1.0).empty());
}

TEST(Uart, AFallInTheMomentInWhichAByteEndsBeginsTheNext)
{
    // At half the rate the last look at the first byte is in bit 22: low, and the bit before it high, as a start has to be.
    const std::array<std::uint8_t, 3> sent{0x03, 0x00, 0x01};
    EXPECT_EQ(sampledAt(sent, 2.0), (std::vector<UartByte>{{0, true}, {0xFC, false}}));
}
