// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/mutation.h"
#include "fuzz/soak.h"
#include "wire/framelog.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace mb {
namespace {

/// What was read is legal, and reads the same after it was written.
void expectStable(const LoggedFrame &frame, const std::string &text)
{
    EXPECT_GE(frame.time, Duration::zero()) << text;
    EXPECT_FALSE(frame.link.empty()) << text;
    EXPECT_LE(frame.frame.size, 8) << text;
    EXPECT_LE(frame.frame.id, frame.frame.extended || frame.frame.error ? 0x1FFFFFFFU : 0x7FFU) << text;
    FrameLogWriter writer(LogFormat::Asc);
    std::string log;
    writer.write(frame, log);
    FrameLogParser parser;
    std::optional<LoggedFrame> again;
    for (std::size_t at = 0; at < log.size(); at = log.find('\n', at) + 1) {
        const auto parsed = parser.parse(std::string_view(log).substr(at, log.find('\n', at) - at));
        ASSERT_TRUE(parsed) << text << '\n' << log;
        if (*parsed)
            again = *parsed;
    }
    ASSERT_TRUE(again) << text << '\n' << log;
    EXPECT_EQ(again->time, std::chrono::duration_cast<std::chrono::microseconds>(frame.time)) << text << '\n' << log;
    EXPECT_EQ(again->link, frame.link) << text;
    EXPECT_EQ(again->direction, frame.direction) << text;
    EXPECT_TRUE(sameContent(again->frame, frame.frame)) << text << '\n' << log;
}

TEST(AscFuzz, EveryChangedLogIsReadRightOrNotAtAll)
{
    const std::vector<std::string> seeds{"date Sat Sep 30 15:06:13.191 2017", "base hex  timestamps absolute",
        "base dec timestamps relative", "// MotorBench start 1506783973.191000", "// MotorBench channel 1 can0",
        "// MotorBench directions unknown", "   2.501000 1  ErrorFrame",
        "1.0 1 ErrorFrame // 20000004#0004000000000000", "   2.510001 2  100 Tx r",
        "   3.107923 2  14C5638x  Rx   d 8 00 40 11 00 00 00 00 00", "   4.000000 1  300  Rx   r 8 Length = 1704000",
        "20.305233 2 66 Rx d 6 2 0 0 0 0 255"};
    test::Mutation mutation(7,
        {" ", "x", "Rx", "Tx", "d", "r", ".", "999999999999", "\n", std::string(1, '\0'), "//", "date", "base", "FF",
            "-", "CANFD", "9223372035.9"});
    int accepted = 0;
    const int total = test::rounds(20'000);
    for (int i = 0; i < total && !::testing::Test::HasFailure(); ++i) {
        FrameLogParser parser; // a log of a few lines, each perhaps changed
        ASSERT_TRUE(parser.parse("base hex timestamps absolute"));
        std::string text;
        for (std::size_t line = 0; line < 4; ++line) {
            std::string one = seeds[mutation.below(seeds.size())];
            if (mutation.below(2) == 0)
                one = mutation(one);
            text += one + '\n';
            const auto parsed = parser.parse(one);
            if (!parsed)
                break;
            accepted += *parsed ? 1 : 0;
            if (*parsed)
                expectStable(**parsed, text);
        }
    }
    EXPECT_GT(accepted, total / 10);
}

} // namespace
} // namespace mb
