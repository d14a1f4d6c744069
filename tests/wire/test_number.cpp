// SPDX-License-Identifier: GPL-3.0-or-later
#include "wire/number.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

namespace mb {
namespace {

TEST(Number, IsDigitsWithADotAndNothingAroundThem)
{
    EXPECT_EQ(numberFrom("1.5"), 1.5);
    EXPECT_EQ(numberFrom("+2"), 2.0);
    EXPECT_EQ(numberFrom("-2.5e3"), -2500.0);
    for (const char *text : {"", "+", "-", "+-1", "++1", " 1", "1 ", "1,5", "1,500", "1.5.2", "0x10", "1e", "nan",
             "inf", "-inf", "1e999", "1s"})
        EXPECT_FALSE(numberFrom(text)) << text;
}

TEST(Number, AWholeOneFitsItsType)
{
    EXPECT_EQ(wholeFrom<int>("-12"), -12);
    EXPECT_EQ(wholeFrom<std::uint16_t>("1f", 16), 31);
    EXPECT_EQ(wholeFrom<std::uint8_t>("255"), 255);
    for (const char *text : {"", "256", "-1", "1.5", "1e2", "12x", " 1", "+1"})
        EXPECT_FALSE(wholeFrom<std::uint8_t>(text)) << text;
}

TEST(Number, APlaceKeepsItsValueWhenNothingIsRead)
{
    double fraction = 0.25;
    EXPECT_FALSE(takeNumber("0,5", fraction));
    EXPECT_EQ(fraction, 0.25);
    EXPECT_TRUE(takeNumber("0.5", fraction));
    EXPECT_EQ(fraction, 0.5);
    int whole = 3;
    EXPECT_FALSE(takeNumber("4.0", whole));
    EXPECT_EQ(whole, 3);
    EXPECT_TRUE(takeNumber("4", whole));
    EXPECT_EQ(whole, 4);
}

} // namespace
} // namespace mb
