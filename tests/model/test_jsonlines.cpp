// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/jsonlines.h"

#include <gtest/gtest.h>

namespace mb {
namespace {

std::string repeatedIn(const QByteArray &text)
{
    return linesOf(text).repeated;
}

TEST(JsonLines, FindsAKeyThatIsThereTwiceInAnObjectAndNotInTwoOfThem)
{
    EXPECT_EQ(repeatedIn(R"({"a":1,"b":{"a":1},"c":[{"a":1},{"a":2}]})"), "");
    EXPECT_EQ(repeatedIn(R"({"a":1,"b":{"a":1},"a":2})"), "a");
    EXPECT_EQ(repeatedIn(R"({"c":[{"a":1},{"a":1,"a":2}]})"), "c.1.a");
    EXPECT_EQ(repeatedIn(R"({"a":1,"\u0061":2})"), "a") << "one key, written in two ways";
    EXPECT_EQ(repeatedIn("\xEF\xBB\xBF"
                         R"({"a":1,"a":2})"),
        "a")
        << "behind the mark of an editor";
}

TEST(JsonLines, RefusesARepeatedKeyWithTheLineOfTheSecond)
{
    const auto checked = linesOf("{\n\"a\":1,\n\n\"a\":2\n}").checkKeys();
    ASSERT_FALSE(checked);
    EXPECT_EQ(checked.error().fault, Fault::OutOfRange);
    EXPECT_EQ(checked.error().text(), "line 4: the key 'a' is there twice");
    EXPECT_TRUE(linesOf("{\"a\":1}").checkKeys());
}

TEST(JsonLines, SpaceMayStandOnEitherSideOfAColon)
{
    EXPECT_EQ(repeatedIn("{\"a\" :\t1 , \"b\"\n:\r\n2 ,\"b\" : 3}"), "b");
    EXPECT_EQ(linesOf("{\"a\"\n:1,\n\"b\" :2}").of("b"), 3);
}

TEST(JsonLines, ReadsAsDeepAsQtDoes)
{
    const QByteArray twice = R"({"a":1,"a":2})"; // two deep
    EXPECT_NE(repeatedIn(QByteArray(1022, '[') + twice), "");
    EXPECT_EQ(repeatedIn(QByteArray(1023, '[') + twice), "");
}

TEST(JsonLines, AnOffsetIsInTheLineAfterTheEndsOfThoseBeforeIt)
{
    EXPECT_EQ(lineAt("", 0), 1);
    EXPECT_EQ(lineAt("\n{", 0), 1);
    EXPECT_EQ(lineAt("\n{", 1), 2);
    EXPECT_EQ(lineAt("{\n\n}", 99), 3);
    EXPECT_EQ(lineAt("{\n\n}", -1), 1);
}

TEST(JsonLines, EndsWhereATextStopsToBeJson)
{
    for (const char *text :
        {"", "}", "[}", "[,]", "{1:2}", "{\"a\" 1}", "{\"a\":}", "{\"a", "{\"a\\", "[[", "{\"a\":[}]}"})
        EXPECT_EQ(repeatedIn(text), "") << text;
    const JsonLines lines = linesOf("{\n\"a\":1,\n\"b\":[}\n\"c\":2}");
    EXPECT_EQ(lines.of("b"), 3);
    EXPECT_EQ(lines.lines.count("c"), 0U);
    EXPECT_EQ(repeatedIn(QByteArray(1'000'000, '[')), "") << "deeper than any stack";
    EXPECT_EQ(repeatedIn(QByteArray("{\"a\":").repeated(200'000)), "");
}

} // namespace
} // namespace mb
