// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/parameter.h"

#include <gtest/gtest.h>

#include <limits>

namespace mb {
namespace {

Parameter row(WireType type, double one, double minimum, double maximum)
{
    Parameter p;
    p.key = "test.row";
    p.type = type;
    p.one = one;
    p.minimum = minimum;
    p.maximum = maximum;
    return p;
}

const Parameter gain = row(WireType::Fixed16x16, 65536.0, -32768.0, 32767.5);
const Parameter whole = row(WireType::Uint16, 1.0, 10.0, 500.0);
const Parameter flag = row(WireType::Boolean, 1.0, 0.0, 1.0);

TEST(Parameter, TakesNumbersWithADot)
{
    EXPECT_EQ(parseRaw(gain, "1.5"), 98304);
    EXPECT_EQ(parseRaw(gain, " 1.5 "), 98304);
    EXPECT_EQ(parseRaw(gain, "+1.5"), 98304);
    EXPECT_EQ(parseRaw(gain, "-0.25"), -16384);
    EXPECT_EQ(parseRaw(gain, "1e-1"), 6554) << "the nearest raw value";
    EXPECT_EQ(parseRaw(whole, "0x1F"), 31);
}

TEST(Parameter, EveryTypeHasItsNameAndItsRange)
{
    const auto textOf = [](WireType type, double one = 1.0) {
        const RawRange range = rangeOf(type);
        return std::string(typeName(row(type, one, 0.0, 1.0))) + ' ' + std::to_string(range.low) + " … "
            + std::to_string(range.high);
    };
    EXPECT_EQ(textOf(WireType::Boolean), "boolean 0 … 1");
    EXPECT_EQ(textOf(WireType::Int16), "integer -32768 … 32767");
    EXPECT_EQ(textOf(WireType::Int16, 10.0), "number -32768 … 32767");
    EXPECT_EQ(textOf(WireType::Int32), "integer -2147483648 … 2147483647");
    EXPECT_EQ(textOf(WireType::Uint8), "integer 0 … 255");
    EXPECT_EQ(textOf(WireType::Uint16), "integer 0 … 65535");
    EXPECT_EQ(textOf(WireType::Uint31), "integer 0 … 2147483647");
    EXPECT_EQ(textOf(WireType::Uint32), "integer 0 … 4294967295");
    EXPECT_EQ(textOf(WireType::Fixed16x16, 65536.0), "number -2147483648 … 2147483647");
    EXPECT_EQ(textOf(WireType::Flags32), "flags 0 … 4294967295");
    EXPECT_EQ(textOf(WireType::Flags64), "flags 0 … 9007199254740992");
}

TEST(Parameter, RefusesACommaBecauseItMayMeanThousands)
{
    for (const char *text : {"1,5", "1,500", "1.500,0",
             "\xE2\x88\x92"
             "1"}) {
        const auto raw = parseRaw(gain, text);
        ASSERT_FALSE(raw) << text;
        EXPECT_EQ(raw.error().fault, Fault::OutOfRange);
    }
    EXPECT_EQ(parseRaw(gain, "1,500").error().remedy, "write it with a dot, like 1.5, and no comma");
}

TEST(Parameter, TakesEveryWordForOnAndOff)
{
    for (const char *word : {"on", "true", "yes", "1", "ON", "True"})
        EXPECT_EQ(parseRaw(flag, word), 1) << word;
    for (const char *word : {"off", "false", "no", "0", "OFF"})
        EXPECT_EQ(parseRaw(flag, word), 0) << word;
    for (const char *word : {"", "2", "maybe", "on off"})
        EXPECT_FALSE(parseRaw(flag, word)) << word;
}

TEST(Parameter, RefusesWhatIsNoNumber)
{
    for (const char *text : {"", " ", "abc", "1.5x", "1 5", "--1", "1.2.3", "nan", "inf", "-inf", "+-1", "0x", "0xG",
             "0x1FFFFFFFF", "1e400"}) {
        const auto raw = parseRaw(gain, text);
        ASSERT_FALSE(raw) << text;
        EXPECT_EQ(raw.error().fault, Fault::OutOfRange);
    }
}

TEST(Parameter, RefusesWhatIsOutOfRangeAndNamesTheRange)
{
    const auto above = parseRaw(whole, "501");
    ASSERT_FALSE(above);
    EXPECT_NE(above.error().text().find("10 … 500"), std::string::npos) << above.error().text();
    EXPECT_FALSE(parseRaw(whole, "9"));
    EXPECT_FALSE(parseRaw(whole, "20.5")) << "not a whole number";
    EXPECT_EQ(parseRaw(whole, "10"), 10);
    EXPECT_EQ(parseRaw(whole, "500"), 500);
    EXPECT_FALSE(toRaw(gain, std::numeric_limits<double>::quiet_NaN()));
    EXPECT_FALSE(toRaw(gain, std::numeric_limits<double>::infinity()));
}

TEST(Parameter, ShowsATextThatComesBackAsTheSameRawValue)
{
    std::int64_t raw = 1;
    for (int i = 0; i < 2000; ++i) {
        raw = (raw * 1103515245 + 12345) % 2147483647;
        const std::int64_t value = raw % 2 == 0 ? raw : -raw;
        if (static_cast<double>(value) / gain.one <= gain.maximum) {
            EXPECT_EQ(parseRaw(gain, toText(gain, value)), value) << toText(gain, value);
        }
    }
    EXPECT_EQ(toText(gain, 98304), "1.5");
    EXPECT_EQ(toText(gain, 6554), "0.1") << "the shortest, not 0.100006";
    EXPECT_EQ(toText(flag, 1), "on");
}

TEST(Parameter, PeopleSeeAGainWithFourDigitsOrWithThoseThatItTakes)
{
    Parameter p = gain;
    p.role = Role::Proportional;
    for (const auto &[raw, text] :
        std::vector<std::pair<std::int64_t, std::string>>{{227, "0.003464"}, {55, "0.0008392"}, {-55, "-0.0008392"},
            {98304, "1.500"}, {82123, "1.2531"}, {6554000, "100.0061"}, {0, "0"}}) {
        EXPECT_EQ(shownText(p, raw), text);
        EXPECT_EQ(parseRaw(p, shownText(p, raw)), raw);
    }
    EXPECT_EQ(shownText(gain, 98304), toText(gain, 98304)) << "no gain";
    p.one = 1.0;
    EXPECT_EQ(shownText(p, 5), "5") << "an integer says all of it";
}

TEST(Parameter, ARawValueIsLegalWithinHalfAStepOfItsBounds)
{
    EXPECT_TRUE(isLegal(whole, 10));
    EXPECT_TRUE(isLegal(whole, 500));
    EXPECT_FALSE(isLegal(whole, 9));
    EXPECT_FALSE(isLegal(whole, 501));
    const Parameter tenths = row(WireType::Int16, 10.0, -1.25, 1.25);
    EXPECT_TRUE(isLegal(tenths, 13)) << "12.5, rounded";
    EXPECT_FALSE(isLegal(tenths, 14));
    EXPECT_TRUE(isLegal(tenths, -13));
    EXPECT_FALSE(isLegal(tenths, -14));
    const Parameter below = row(WireType::Int16, 10.0, -1.245, 1.245);
    EXPECT_TRUE(isLegal(below, 12) && isLegal(below, -12)) << "12.45, rounded";
    EXPECT_FALSE(isLegal(below, 13) || isLegal(below, -13));
    EXPECT_TRUE(isLegal(gain, 32767 * 65536LL + 32768));
    EXPECT_FALSE(isLegal(gain, 32767 * 65536LL + 32769));
}

TEST(Parameter, ShowsAWholeNumberWithoutADot)
{
    EXPECT_EQ(toText(whole, 480), "480");
    EXPECT_EQ(toText(flag, 0), "off");
    EXPECT_EQ(toText(row(WireType::Int16, 10.0, -100.0, 100.0), -15), "-1.5");
    EXPECT_EQ(toText(row(WireType::Int16, 10.0, -100.0, 100.0), 20), "2");
    EXPECT_EQ(toText(row(WireType::Int32, 0.5, -100.0, 100.0), 3), "6") << "a raw step of 2";
}

TEST(Parameter, TakesAChoiceByItsName)
{
    static constexpr std::array choices{Choice{3, "slow"}, Choice{7, "fast"}};
    Parameter p = row(WireType::Uint8, 1.0, 0.0, 7.0);
    p.choices = choices;
    EXPECT_EQ(parseRaw(p, "fast"), 7);
    EXPECT_EQ(parseRaw(p, "3"), 3);
    EXPECT_FALSE(parseRaw(p, "middling"));
}

TEST(Parameter, WritesNumbersWithADotAndWithoutNoise)
{
    EXPECT_EQ(numberText(0.0), "0");
    EXPECT_EQ(numberText(-0.0), "0");
    EXPECT_EQ(numberText(0.1), "0.1");
    EXPECT_EQ(numberText(123456789.0), "123456789");
    EXPECT_EQ(numberText(-2.5), "-2.5");
}

} // namespace
} // namespace mb
