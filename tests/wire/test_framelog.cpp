// SPDX-License-Identifier: GPL-3.0-or-later
#include "wire/framelog.h"

#include <gtest/gtest.h>

namespace mb {
namespace {

constexpr const char *good = "(1.000000) can0 123#00";

/// What a log ends with, after one good line.
std::string remarkOf(const std::string &first, const std::string &last, bool isRead)
{
    FrameLogParser parser;
    EXPECT_TRUE(parser.parse(first));
    const auto parsed = parser.parseLast(last);
    EXPECT_EQ(parsed && *parsed, isRead) << last;
    return parsed ? parser.remark().english() : "an error: " + parsed.error().text();
}

TEST(FrameLog, ALastLineThatWasCutIsLeftOutAndTold)
{
    for (const char *last : {"(", "(1.00", "(1.000000) can0", "(1.000000) can0 12", "(1.000000) can0 123#0",
             "(1.000000) can0 123##", "(1.000000) can0 123##11"})
        EXPECT_EQ(remarkOf(good, last, false), "the last line is cut off, and left out") << last;
    EXPECT_EQ(remarkOf("base hex timestamps absolute", "1.0 1 123 Rx d 2 00", false),
        "the last line is cut off, and left out");
}

TEST(FrameLog, ALastLineWithoutAnEndMayBeCutInItsData)
{
    EXPECT_EQ(
        remarkOf(good, "(1.000000) can0 123#0011", true), "the last line has no end, so its frame may be cut short");
    EXPECT_EQ(remarkOf(good, "(1.000000) can0 123#0011 R", true), "") << "the direction follows the data";
    EXPECT_EQ(remarkOf(good, "", false), "") << "it ends with the end of a line";
    EXPECT_EQ(remarkOf("base hex timestamps absolute", "1.0 1 123 Rx d 1 00", true), "") << "it counts its bytes";
}

TEST(FrameLog, WhatCannotBeTheBeginningOfALineIsAnError)
{
    EXPECT_NE(remarkOf(good, "rubbish", false).find("line 2 is not"), std::string::npos);
    FrameLogParser alone;
    EXPECT_FALSE(alone.parseLast("(1.00")) << "one line that is cut could be anything";
}

TEST(FrameLog, CanFdFramesAreCountedAndNotRead)
{
    FrameLogParser parser;
    for (const char *line : {good, "(1.000000) can0 123##311223344", "(1.000000) can0 12345678##0 R"})
        EXPECT_TRUE(parser.parse(line)) << line;
    EXPECT_EQ(parser.remark().english(), "2 CAN FD frames are left out, because only classic CAN is read");
    for (const char *line : {"(1.000000) can0 12##311", "(1.000000) can0 123##", "(1.000000) can0 123##3112",
             "(1.000000) can0 123##x", "(1.000000) can0 123##1##1"})
        EXPECT_FALSE(FrameLogParser(parser).parse(line)) << line;
    FrameLogParser asc;
    ASSERT_TRUE(asc.parse("base hex timestamps absolute"));
    const auto passed = asc.parse("1.0 CANFD 1 Rx 123 1 0 8 8 00 00 00 00 00 00 00 00 0 0 0 0 0 0");
    ASSERT_TRUE(passed);
    EXPECT_FALSE(*passed);
    EXPECT_EQ(asc.remark().english(), "1 CAN FD frame is left out, because only classic CAN is read");
}

} // namespace
} // namespace mb
