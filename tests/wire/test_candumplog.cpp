// SPDX-License-Identifier: GPL-3.0-or-later
#include "wire/candumplog.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace mb {
namespace {

using namespace std::chrono_literals;

TEST(CandumpLine, ReadsTheExampleOfCanUtils)
{
    const auto line = parseCandumpLine("(1436509052.249713) vcan0 044#2A366C2BBA");
    ASSERT_TRUE(line);
    EXPECT_EQ(line->time, 1436509052s + 249713us);
    EXPECT_EQ(line->link, "vcan0");
    EXPECT_EQ(toText(line->frame), "044#2A366C2BBA");
    EXPECT_EQ(line->frame.time, Instant{});
    EXPECT_EQ(toCandumpLine(*line), "(1436509052.249713) vcan0 044#2A366C2BBA");
}

TEST(CandumpLine, PadsShortTimesAsCandumpDoes)
{
    const CanFrame frame = extendedFrame(0x240, {});
    EXPECT_EQ(toCandumpLine(0ns, "sim:can", frame), "(0000000000.000000) sim:can 00000240#");
    EXPECT_EQ(toCandumpLine(1s + 7us, "sim:can", frame), "(0000000001.000007) sim:can 00000240#");
    EXPECT_EQ(toCandumpLine(1999ns, "c", frame), "(0000000000.000001) c 00000240#");
    EXPECT_EQ(toCandumpLine(-5s, "c", frame), "(0000000000.000000) c 00000240#");
    EXPECT_EQ(toCandumpLine(Duration::max(), "c", frame), "(9223372036.854775) c 00000240#");
}

TEST(CandumpLine, ReadsEveryPrecisionUpToNanoseconds)
{
    const std::vector<std::pair<std::string, Duration>> times{{"1.5", 1500ms}, {"0.000000001", 1ns},
        {"12.000001", 12s + 1us}, {"0.0", 0ns}, {"9223372035.999999999", 9223372035s + 999999999ns},
        {"0001.100", 1100ms}};
    for (const auto &[text, expected] : times) {
        const auto line = parseCandumpLine("(" + text + ") can0 123#");
        ASSERT_TRUE(line) << text;
        EXPECT_EQ(line->time, expected) << text;
    }
}

TEST(CandumpLine, AcceptsLineEndsBlanksAndDirection)
{
    const std::string plain = "(1.000000) can0 123#00";
    for (const std::string end : {"\n", "\r\n", "  ", "\t\r\n", " R", " T", " T\n"})
        EXPECT_TRUE(parseCandumpLine(plain + end)) << end;
    EXPECT_TRUE(parseCandumpLine("(1.000000)    can0   123#00")); // names padded to a common width
}

TEST(CandumpLine, ReadsErrorAndRemoteFrames)
{
    const auto error = parseCandumpLine("(1.000000) can0 20000004#0004000000000000");
    ASSERT_TRUE(error);
    EXPECT_TRUE(error->frame.error);
    const auto remote = parseCandumpLine("(1.000000) can0 123#R4");
    ASSERT_TRUE(remote);
    EXPECT_TRUE(remote->frame.remote);
    EXPECT_EQ(toCandumpLine(*remote), "(0000000001.000000) can0 123#R4");
}

TEST(CandumpLine, HasNothingForWhatItDoesNotSupport)
{
    EXPECT_FALSE(parseCandumpLine("(1436509052.249713) vcan0 123##1AABBCC"));
    EXPECT_FALSE(parseCandumpLine("(1436509052.249713) vcan0 12345678##0"));
    EXPECT_FALSE(parseCandumpLine("(0000000001.000000) serial:/dev/ttyUSB0 tx 5501"));
    EXPECT_FALSE(parseCandumpLine("  vcan0  044   [5]  2A 36 6C 2B BA"));
}

TEST(CandumpLine, HasNothingForMalformedLines)
{
    const std::vector<std::string> malformed{"", " ", "\n", "(", "()", ") ", "() can0 123#", "(1) can0 123#",
        "(1.) can0 123#", "(.5) can0 123#", "(-1.0) can0 123#", "(+1.0) can0 123#", "(1.-1) can0 123#",
        "(1.0000000001) can0 123#", "(9223372036.9) can0 123#", "(99999999999999999999.0) can0 123#",
        "(1.0 ) can0 123#", "( 1.0) can0 123#", "(1.0)can0 123#", "(1.0) can0", "(1.0) can0 ", "(1.0) 123#",
        "(1.0) can0 123", "(1.0) can0 123#0", "(1.0) can0 123#00 X", "(1.0) can0 123#00 R T", "1.0) can0 123#00",
        "(1.0 can0 123#00", "[1.0] can0 123#00", "# comment", "(1,5) can0 123#00", " (1.0) can0 123#00",
        "(1.0) ca\nn0 123#00", "x1.0) can0 123#00", "(1.0) can\x1F 123#00", "(1.0) can\x7F 123#00",
        std::string("(1.0) can0\0 123#00", 18), "(1e3.0) can0 123#00"};
    for (const std::string &text : malformed)
        EXPECT_FALSE(parseCandumpLine(text)) << text;
}

TEST(CandumpLine, OneOfAFlexibleRateHasFlagsAndUpTo64WholeBytes)
{
    const std::string head = "(1.000000) can0 12345678##";
    EXPECT_TRUE(isCandumpFdLine("(1436509052.249713) vcan0 123##1AABBCC"));
    EXPECT_TRUE(isCandumpFdLine(head + '1'));
    EXPECT_TRUE(isCandumpFdLine(head + '1' + std::string(128, 'A')));
    EXPECT_FALSE(isCandumpFdLine(head + '1' + std::string(130, 'A')));
    EXPECT_FALSE(isCandumpFdLine(head + "1A"));
    EXPECT_FALSE(isCandumpFdLine(head));
    EXPECT_FALSE(isCandumpFdLine("(1.000000) can0 123#AABBCC"));
}

} // namespace
} // namespace mb
