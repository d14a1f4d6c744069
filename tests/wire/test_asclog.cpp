// SPDX-License-Identifier: GPL-3.0-or-later
// Lines as the public descriptions of the format have them (the tables of Vector's CAN_LOG_TRIGGER_ASC_Format document
// and the samples that open readers of it are tested with).
#include "wire/ascdate.h"
#include "wire/framelog.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace mb {
namespace {

using namespace std::chrono_literals;

constexpr Duration september = 1506783973s + 191ms; // 30 Sep 2017 15:06:13.191 UTC

const std::vector<std::string> sample{
    "date Sat Sep 30 15:06:13.191 2017",
    "base hex  timestamps absolute",
    "internal events logged",
    "// version 9.0.0",
    "Begin Triggerblock Sat Sep 30 15:06:13.191 2017",
    "   0.000000 Start of measurement",
    "   0.015991 CAN 1 Status:chip status error passive - TxErr: 131 RxErr: 0",
    "   0.015991 1  Statistic: D 0 R 0 XD 0 XR 0 E 0 O 0 B 0.00%",
    "   2.501000 1  ErrorFrame",
    "   2.510001 2  100             Tx   r",
    "   3.107923 2  14C5638x        Rx   d 8 00 40 11 00 00 00 00 00",
    "   4.000000 1  300             Rx   r 8 Length = 1704000 BitCount = 145 ID = 88888888x",
    "  20.305233 2  1CEFF83x        Rx   d 6 02 00 00 00 00 FF  Length = 0 BitCount = 0 ID = 0",
    "  21.000000 3  SV: 1 0 1 ::Variable = 5",
    "End TriggerBlock",
};

std::vector<LoggedFrame> read(const std::vector<std::string> &lines)
{
    FrameLogParser parser;
    std::vector<LoggedFrame> frames;
    for (const std::string &line : lines) {
        const auto frame = parser.parse(line);
        EXPECT_TRUE(frame) << line << ": " << (frame ? "" : frame.error().text());
        if (frame && *frame)
            frames.push_back(**frame);
    }
    return frames;
}

TEST(AscLog, ReadsFramesOfThePublishedSample)
{
    const auto frames = read(sample);
    ASSERT_EQ(frames.size(), 5U);
    EXPECT_TRUE(frames[0].frame.error);
    EXPECT_EQ(frames[0].time, september + 2501ms);
    EXPECT_EQ(toText(frames[1].frame), "100#R");
    EXPECT_EQ(frames[1].direction, LogDirection::Sent);
    EXPECT_EQ(frames[1].link, "ch2");
    EXPECT_EQ(toText(frames[2].frame), "014C5638#0040110000000000");
    EXPECT_EQ(frames[2].direction, LogDirection::Received);
    EXPECT_EQ(frames[2].time, september + 3107923us);
    EXPECT_EQ(toText(frames[3].frame), "300#R8");
    EXPECT_EQ(toText(frames[4].frame), "01CEFF83#0200000000FF");
}

TEST(AscLog, ReadsDecimalNumbersAndRelativeTimes)
{
    const auto frames
        = read({"date Mit Okt 4 01:02:03 am 2017", "base dec timestamps relative", "no internal events logged",
            "0.5 1 1091 Rx d 3 42 255 0", "0.25 1 536870911x Tx d 0", "1.0 1 Statistic: D 0", "0.25 1 2047 Rx d 1 7"});
    ASSERT_EQ(frames.size(), 3U);
    EXPECT_EQ(toText(frames[0].frame), "443#2AFF00");
    EXPECT_EQ(toText(frames[1].frame), "1FFFFFFF#");
    EXPECT_EQ(toText(frames[2].frame), "7FF#07");
    EXPECT_EQ(frames[1].time - frames[0].time, 250ms);
    EXPECT_EQ(frames[2].time - frames[1].time, 1250ms) << "an event that is no frame takes its time too";
    EXPECT_EQ(frames[0].time, 1507078923s + 500ms);
}

TEST(AscLog, CountsFromTheStartWhenTheDateIsInAnUnknownLanguage)
{
    const auto frames = read({"date sam. sept. 30 15:06:13 2017", "base hex timestamps absolute", "1.5 1 1 Rx d 0"});
    ASSERT_EQ(frames.size(), 1U);
    EXPECT_EQ(frames[0].time, 1500ms);
}

TEST(AscLog, TheNamesOfItsChannelsAreThoseOfTheRemarksThatWeWrite)
{
    const auto frames = read({"base hex timestamps absolute", "// MotorBench channel 2 can7",
        "// MotorBench channel 255 last", "// MotorBench channel 256 beyond", "// MotorBench channel 0 before",
        "// MotorBench channel 3", "// MotorBench channel x none", "// channel 1 foreign", "1.0 1 1 Rx d 0",
        "1.0 2 1 Rx d 0", "1.0 3 1 Rx d 0", "1.0 255 1 Rx d 0", "1.0 256 1 Rx d 0"});
    std::string links;
    for (const LoggedFrame &frame : frames)
        links += frame.link + ' ';
    EXPECT_EQ(links, "ch1 can7 ch3 last ch256 ");
}

TEST(AscLog, AnErrorFrameIsThatOfItsRemarkWhereTheRemarkIsOne)
{
    const auto frames = read({"base hex timestamps absolute", "1.0 1  ErrorFrame // 20000004#0004000000000000",
        "1.0 1  ErrorFrame // 20000004#0004000000000000 Tx", "1.0 1  ErrorFrame // 123#0004", "1.0 1  ErrorFrame",
        "1.0 1  ErrorFrame : 20000004#0004000000000000 Tx"});
    ASSERT_EQ(frames.size(), 5U);
    EXPECT_EQ(toText(frames[0].frame), "20000004#0004000000000000");
    EXPECT_EQ(frames[0].direction, LogDirection::Received);
    EXPECT_EQ(frames[1].direction, LogDirection::Sent);
    for (std::size_t other = 2; other < frames.size(); ++other) {
        EXPECT_EQ(toText(frames[other].frame), "20000008#0000000000000000") << "which is not known";
        EXPECT_EQ(frames[other].direction, LogDirection::Received);
    }
}

TEST(AscLog, NamesTheLineAndWhatIsWrongWithIt)
{
    const std::vector<std::pair<std::string, std::string>> wrong{
        {"1.0 1 123 Rx d 8 00 01 02 03 04 05 06", "7 of 8 bytes"},
        {"1.0 1 123 Rx d 2 00 100", "1 of 2 bytes"},
        {"1.0 1 EngineData Rx d 1 00", "'EngineData' is no CAN identifier"},
        {"1.0 1 800 Rx d 1 00", "'800' is no CAN identifier"},
        {"1.0 1 20000000x Rx d 1 00", "is no CAN identifier"},
        {"1.0 1 123 Up d 1 00", "'Up'"},
        {"1.0 1 123", "Rx or Tx"},
        {"1.0 1 123 Rx x 1 00", "not d or r"},
        {"1.0 1 123 Rx d", "length"},
        {"1.0 1 123 Rx d 10 00", "length"},
        {"1,0 1 123 Rx d 1 00", "time stamp"},
        {"99999999999999.0 1 123 Rx d 1 00", "time stamp"},
        {"9223372035.0 1 123 Rx d 1 00", "out of range"},
        {"base octal", "'octal'"},
        {"base hex timestamps never", "'never'"},
        {"rubbish", "'rubbish' begins no line"},
        {"(1.0) can0 123#00", "begins no line"},
    };
    for (const auto &[line, says] : wrong) {
        FrameLogParser parser;
        ASSERT_TRUE(parser.parse("date Sat Sep 30 15:06:13.191 2017"));
        ASSERT_TRUE(parser.parse("base hex timestamps absolute"));
        const auto parsed = parser.parse(line);
        ASSERT_FALSE(parsed) << line;
        EXPECT_EQ(parsed.error().fault, Fault::OutOfRange);
        EXPECT_NE(parsed.error().text().find("line 3 is not a line of a Vector ASC log: "), std::string::npos);
        EXPECT_NE(parsed.error().text().find(says), std::string::npos) << line << ": " << parsed.error().text();
        EXPECT_NE(parsed.error().text().find("; such a line reads"), std::string::npos);
    }
}

TEST(AscLog, WritesWhatTheDescriptionsShow)
{
    FrameLogWriter writer(LogFormat::Asc);
    std::string text;
    writer.write(
        {september + 713us, "can0", *canFrameFromText("02061405#0040110000000000"), LogDirection::Received}, text);
    writer.write({september + 1s, "can1", *canFrameFromText("123#R4"), LogDirection::Sent}, text);
    writer.finish(text);
    EXPECT_EQ(text,
        "date Sat Sep 30 15:06:13.191 2017\n"
        "base hex  timestamps absolute\n"
        "internal events logged\n"
        "// MotorBench writes dates in UTC\n"
        "// MotorBench start 1506783973.191000\n"
        "Begin Triggerblock Sat Sep 30 15:06:13.191 2017\n"
        "   0.000000 Start of measurement\n"
        "// MotorBench channel 1 can0\n"
        "   0.000713 1  2061405x        Rx   d 8 00 40 11 00 00 00 00 00\n"
        "// MotorBench channel 2 can1\n"
        "   1.000000 2  123             Tx   r 4\n"
        "End TriggerBlock\n");
}

TEST(AscLog, WritesTheSecondsOfItsStartWithoutZerosBefore)
{
    FrameLogWriter writer(LogFormat::Asc);
    std::string text;
    writer.write({7s + 250ms, "can0", *canFrameFromText("123#R4"), LogDirection::Sent}, text);
    EXPECT_NE(text.find("// MotorBench start 7.250000\n"), std::string::npos) << text;
}

TEST(AscLog, WritesADateThatItReads)
{
    for (const Duration time : {0ns, Duration(september), Duration(4102444799s + 999ms)})
        EXPECT_EQ(unixTimeOfAscDate(toAscDate(time)), time) << toAscDate(time);
    EXPECT_EQ(unixTimeOfAscDate("Sat Sep 30 03:06:13.191 pm 2017"), september);
    EXPECT_EQ(unixTimeOfAscDate("Sam M\xC3\xA4r 4 00:00:00 2017"), 1488585600s);
    for (const char *const wrong : {"", "Sat", "Sat Sep 31 00:00:00 2017", "Sat Sep 30 25:00:00 2017",
             "Sat Sep 30 00:61:00 2017", "Sat Sep 30 00-00-00 2017", "Sat Sep -3 00:00:00 2017",
             "Sat Sep 30 00:00:00 1", "Sat Sep 30 00:00:00 xm 2017"})
        EXPECT_FALSE(unixTimeOfAscDate(wrong)) << wrong;
}

TEST(AscLog, ReadsDatesToTheirBoundsAndNoFurther)
{
    constexpr Duration day = 1506729600s; // 30 Sep 2017
    for (const auto &[text, time] : std::vector<std::pair<std::string, Duration>>{{"23:59:60.999", 86400s + 999ms},
             {"00:00:00", 0s}, {"12:00:00 am", 0s}, {"12:00:00 pm", 12h}, {"01:00:00 am", 1h}, {"11:59:59 pm", 86399s},
             {"01:02:03.5", 3723s + 500ms}})
        EXPECT_EQ(unixTimeOfAscDate("Sat Sep 30 " + text + " 2017"), day + time) << text;
    for (const char *wrong : {"24:00:00", "00:60:00", "00:00:61", "0:00:00", "00:00:0", "00:00-00", "00-00:00",
             "x0:00:00", "00:x0:00", "00:00:x0", "1x:00:00", "00:1x:00", "-1:00:00"})
        EXPECT_FALSE(unixTimeOfAscDate("Sat Sep 30 " + std::string(wrong) + " 2017")) << wrong;
    EXPECT_EQ(unixTimeOfAscDate("Thu Jan 01 00:00:00 1970"), 0s);
    EXPECT_EQ(unixTimeOfAscDate("Wed Dec 31 00:00:00 2200"), 7289568000s);
    for (const char *wrong : {"Wed Dec 31 00:00:00 1969", "Thu Jan 01 00:00:00 2201", "Sat Sep 30x 00:00:00 2017",
             "Sat Sep 99999999999 00:00:00 2017", "Sat Sep 30 00:00:00 2017 2017 2017",
             "Sat Sep 30 00:00:00 am 2017 x y z"})
        EXPECT_FALSE(unixTimeOfAscDate(wrong)) << wrong;
    EXPECT_EQ(toAscDate(day + 23h + 59min + 58s + 7ms), "Sat Sep 30 23:59:58.007 2017");
    for (const auto &[name, month] : std::vector<std::pair<std::string, int>>{
             {"Jan", 1}, {"Mrz", 3}, {"Mai", 5}, {"May", 5}, {"Okt", 10}, {"Dez", 12}, {"Dec", 12}, {"Sept", 9}})
        EXPECT_EQ(unixTimeOfAscDate("x " + name + " 1 00:00:00 2017"),
            std::chrono::sys_days(std::chrono::year(2017) / month / 1).time_since_epoch())
            << name;
}

TEST(AscLog, ALengthOfNineToFifteenMeansEightAndItsWordsMayBeInAnyCase)
{
    const auto frames = read({"BASE HEX TIMESTAMPS ABSOLUTE", "0.000001 1 7FF RX D F 01 02 03 04 05 06 07 08",
        "0.000002 1 7FF Tx R 9", "0.000003 1 7FF rX d 1 ff"});
    ASSERT_EQ(frames.size(), 3U);
    EXPECT_EQ(toText(frames[0].frame), "7FF#0102030405060708");
    EXPECT_EQ(toText(frames[1].frame), "7FF#R8");
    EXPECT_EQ(toText(frames[2].frame), "7FF#FF");
    EXPECT_EQ(frames[2].time, 3us);
}

TEST(AscLog, ARemarkQuotesFortyCharactersThatCanBePrinted)
{
    const auto quotedBy = [](const std::string &word) {
        FrameLogParser parser;
        EXPECT_TRUE(parser.parse("base hex timestamps absolute"));
        const std::string text = parser.parse("1.0 1 " + word + " Rx d 0").error().text();
        return text.substr(text.find('\''), text.rfind('\'') - text.find('\'') + 1);
    };
    EXPECT_EQ(quotedBy("zz\x1F\x7Fz!"), "'zz??z!'");
    EXPECT_EQ(quotedBy(std::string(41, 'z')), "'" + std::string(40, 'z') + "'");
}

/// Everything that a line of candump can say, in one log.
const std::vector<std::string> candump{
    "(1436509052.249713) can0 02061405#0040110000000000",
    "(1436509052.250000) can0 123#",
    "(1436509052.250001) vcan1 00000240#",
    "(1436509052.250002) can0 7FF#R",
    "(1436509052.250003) can0 1FFFFFFF#R8",
    "(1436509052.249999) can0 000#00", // earlier than the one before
    "(1436509051.000000) can0 001#FF", // earlier than the first
    "(1436509053.000000) can0 20000004#0004000000000000",
    "(1436509053.000001) can0 20000088#00000000000000FF",
    "(1436509053.000002) can0 02060005#0F00000000000000 T",
    "(1436509053.000003) can0 02060005#0F00000000000000 R",
    "(1436509053.000004) can0 20000004#0004000000000000 T",
    "(1436509053.000005) sim:can 02060005#0F00000000000000",
    "(9223372035.999999) can0 123#AA",
};

TEST(FrameLog, LosesNothingBetweenCandumpAndAsc)
{
    FrameLogWriter toAsc(LogFormat::Asc);
    std::string asc;
    for (const LoggedFrame &frame : read(candump))
        toAsc.write(frame, asc);
    toAsc.finish(asc);
    std::vector<std::string> lines;
    for (std::size_t at = 0; at < asc.size(); at = asc.find('\n', at) + 1)
        lines.push_back(asc.substr(at, asc.find('\n', at) - at));
    FrameLogWriter toCandump(LogFormat::Candump);
    std::string back;
    for (const LoggedFrame &frame : read(lines))
        toCandump.write(frame, back);
    std::string expected;
    for (const std::string &line : candump)
        expected += line + '\n';
    EXPECT_EQ(back, expected) << asc;
}

TEST(FrameLog, LosesNothingOfAForeignAscLogOnItsWayThroughCandump)
{
    const auto frames = read(sample);
    FrameLogWriter toCandump(LogFormat::Candump);
    for (const LoggedFrame &frame : frames) {
        std::string line;
        toCandump.write(frame, line);
        const auto again = parseCandumpLine(line);
        ASSERT_TRUE(again) << line;
        EXPECT_EQ(again->time, frame.time);
        EXPECT_EQ(again->link, frame.link);
        EXPECT_EQ(again->direction, frame.direction);
        EXPECT_TRUE(sameContent(again->frame, frame.frame));
    }
}

TEST(FrameLog, KnowsTheFormatByContent)
{
    const auto formatOf = [](const std::vector<std::string> &lines) {
        FrameLogParser parser;
        for (const std::string &line : lines)
            EXPECT_TRUE(parser.parse(line)) << line;
        return parser.format();
    };
    EXPECT_EQ(formatOf({"", "  ", candump[0]}), LogFormat::Candump);
    EXPECT_EQ(formatOf({"\r\n", "// comment", sample[0]}), LogFormat::Asc);
    EXPECT_EQ(formatOf({"\xEF\xBB\xBF"
                        "date Sat Sep 30 15:06:13.191 2017\r\n"}),
        LogFormat::Asc);
    EXPECT_EQ(formatOf({}), std::nullopt);
    FrameLogParser parser;
    EXPECT_NE(parser.parse("LOGG\x90").error().text().find("BLF"), std::string::npos);
    EXPECT_NE(FrameLogParser().parse("rubbish").error().text().find("line 1 is neither"), std::string::npos);
    FrameLogParser long1;
    ASSERT_TRUE(long1.parse(candump[0]));
    EXPECT_FALSE(long1.parse(std::string(5000, 'x')));
    const auto blanksBehind = [](std::size_t size) { return candump[0] + std::string(size - candump[0].size(), ' '); };
    EXPECT_TRUE(long1.parse(blanksBehind(FrameLogParser::longestLine)));
    EXPECT_FALSE(long1.parse(blanksBehind(FrameLogParser::longestLine + 1)));
    EXPECT_EQ(formatOfName(".asc"), LogFormat::Asc);
    EXPECT_EQ(formatOfName("z.ASZ"), LogFormat::Candump);
    EXPECT_EQ(formatOfName("a.ASC"), LogFormat::Asc);
    EXPECT_EQ(formatOfName("asc"), LogFormat::Candump);
    EXPECT_EQ(formatOfName("a.asc.log"), LogFormat::Candump);
}

} // namespace
} // namespace mb
