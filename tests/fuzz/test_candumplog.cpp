// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/mutation.h"
#include "fuzz/soak.h"
#include "wire/candumplog.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace mb {
namespace {

/// What was read is legal, and reads the same after it was written.
void expectStableLine(const CandumpLine &line, const std::string &text)
{
    EXPECT_GE(line.time, Duration::zero()) << text;
    EXPECT_FALSE(line.link.empty()) << text;
    EXPECT_LE(line.frame.size, 8) << text;
    EXPECT_LE(line.frame.id, line.frame.extended || line.frame.error ? 0x1FFFFFFFU : 0x7FFU) << text;
    const std::string written = toCandumpLine(line);
    const auto again = parseCandumpLine(written);
    ASSERT_TRUE(again) << text;
    EXPECT_EQ(again->time, std::chrono::duration_cast<std::chrono::microseconds>(line.time)) << text;
    EXPECT_EQ(again->link, line.link) << text;
    EXPECT_TRUE(sameContent(again->frame, line.frame)) << text;
    EXPECT_EQ(toCandumpLine(*again), written) << text;
}

TEST(CandumpFuzz, EveryChangedLineIsReadRightOrNotAtAll)
{
    const std::vector<std::string> seeds{"(1436509052.249713) vcan0 044#2A366C2BBA",
        "(0000000001.000000) sim:can 02061405#0040110000000000", "(1.5) can0 20000004#0004000000000000",
        "(1.000000) can0 123#R8 T", "(1.000000) can0 123##1AABB", ""};
    test::Mutation mutation(5,
        {"(", ")", ") ", " ", "#", "##", "R", " T", ".", "999999999999", "\n", std::string(1, '\0'), "can0", "FF", "-",
            "_9"});
    int accepted = 0;
    const int total = test::rounds(50'000);
    for (int i = 0; i < total && !::testing::Test::HasFailure(); ++i) {
        const std::string text = mutation(seeds[mutation.below(seeds.size())]);
        if (const auto line = parseCandumpLine(text)) {
            ++accepted;
            expectStableLine(*line, text);
        }
    }
    EXPECT_GT(accepted, total / 100);
    EXPECT_LT(accepted, total / 2);
}

} // namespace
} // namespace mb
