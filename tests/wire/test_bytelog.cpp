// SPDX-License-Identifier: GPL-3.0-or-later
#include "wire/bytelog.h"

#include <gtest/gtest.h>

#include <array>

using namespace mb;
using namespace std::chrono_literals;

TEST(ByteLog, WritesTimeLinkDirectionAndDigits)
{
    const std::array<std::uint8_t, 3> bytes{0x55, 0xAA, 0x0F};
    EXPECT_EQ(toByteLine(1436509052s + 249713us, "ttyUSB0", LogDirection::Sent, bytes),
        "(1436509052.249713) ttyUSB0 tx 55AA0F");
    EXPECT_EQ(
        toByteLine(1500ms, "sim:serial", LogDirection::Received, bytes), "(0000000001.500000) sim:serial rx 55AA0F");
}

TEST(ByteLog, ReadsWhatItWritesAndBytesWithBlanksBetweenThem)
{
    for (const char *text : {"(0000000001.500000) sim:serial rx 55AA0F", "(1.5) sim:serial rx 55 aa 0f\r\n",
             "(0000000001.500000) sim:serial rx 55AA 0F "}) {
        const auto line = parseByteLine(text);
        ASSERT_TRUE(line) << text;
        EXPECT_EQ(line->time, 1500ms);
        EXPECT_EQ(line->link, "sim:serial");
        EXPECT_EQ(line->direction, LogDirection::Received);
        EXPECT_EQ(toHexText(line->bytes), "55AA0F");
    }
}

TEST(ByteLog, ReadsEveryDigitInBothPlaces)
{
    const auto line = parseByteLine("(1.5) ttyUSB0 tx 0123456789 ABCDEF abcdef 1032547698BADCFE 00");
    ASSERT_TRUE(line);
    EXPECT_EQ(toHexText(line->bytes), "0123456789ABCDEFABCDEF1032547698BADCFE00");
}

TEST(ByteLog, TakesNothingElse)
{
    for (const char *text : {"", "()", "(1.5) ttyUSB0 tx", "(1.5) ttyUSB0 tx 5", "(1.5) ttyUSB0 tx 5G",
             "(1.5) ttyUSB0 tx G5", "(1.5) ttyUSB0 tx 55 555", "(1.5) ttyUSB0 tx 55 g5", "(1.5) ttyUSB0 up 55",
             "(x) ttyUSB0 tx 55", "(1.5) can0 123#55", "1.5 ttyUSB0 tx 55", "(1.5) ttyUSB0 tx 5 5", "(1.5)  ",
             "x1.5) ttyUSB0 tx 55", "(1.5) tty\x1FUSB0 tx 55", "(1.5) tty\x7FUSB0 tx 55"})
        EXPECT_FALSE(parseByteLine(text)) << text;
}
