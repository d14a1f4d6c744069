// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/firmwareimage.h"
#include "firmware/intelhex.h"
#include "support/hextext.h"

#include <gtest/gtest.h>

#include <array>
#include <numeric>
#include <string>
#include <vector>

namespace mb {
namespace {

using test::hexRecord;
using test::HexText;

constexpr const char *end = ":00000001FF\n";

std::string data(std::uint32_t address, std::initializer_list<std::uint8_t> bytes)
{
    return hexRecord(0, address, std::span(bytes.begin(), bytes.size()));
}

std::string record(int type, std::initializer_list<std::uint8_t> bytes)
{
    return hexRecord(type, 0, std::span(bytes.begin(), bytes.size()));
}

FirmwareImage read(const std::string &text)
{
    auto image = FirmwareImage::fromIntelHex(text);
    EXPECT_TRUE(image) << (image ? "" : image.error().text());
    return image.value_or(FirmwareImage());
}

std::string refusal(const std::string &text)
{
    const auto image = FirmwareImage::fromIntelHex(text);
    if (image)
        return "accepted";
    EXPECT_EQ(image.error().fault, Fault::OutOfRange);
    return image.error().text();
}

TEST(FirmwareImage, IsEmptyWithoutAFile)
{
    const FirmwareImage image;
    EXPECT_EQ(image.byteCount(), 0U);
    EXPECT_FALSE(image.has(0));
    EXPECT_FALSE(image.hasAny(0, 0xFFFFFFFF));
    EXPECT_FALSE(image.at(0));
}

TEST(FirmwareImage, KnowsItsBytesAndItsGaps)
{
    const FirmwareImage image = read(data(0x100, {1, 2, 3, 4}) + data(0x106, {7, 8}) + end);
    EXPECT_EQ(image.byteCount(), 6U);
    EXPECT_EQ(image.at(0x100), 1);
    EXPECT_TRUE(image.hasAny(0x103, 0x103)) << "one byte alone";
    EXPECT_FALSE(image.hasAny(0x104, 0x104));
    EXPECT_EQ(image.at(0x103), 4);
    EXPECT_EQ(image.at(0x107), 8);
    for (const std::uint32_t absent : {0U, 0xFFU, 0x104U, 0x105U, 0x108U, 0xFFFFFFFFU})
        EXPECT_FALSE(image.at(absent)) << absent;
    EXPECT_TRUE(image.hasAny(0, 0x100));
    EXPECT_TRUE(image.hasAny(0x105, 0x106));
    EXPECT_TRUE(image.hasAny(0x107, 0xFFFFFFFF));
    EXPECT_FALSE(image.hasAny(0, 0xFF));
    EXPECT_FALSE(image.hasAny(0x104, 0x105));
    EXPECT_FALSE(image.hasAny(0x108, 0xFFFFFFFF));
    EXPECT_FALSE(image.hasAny(0x103, 0x100));
    EXPECT_EQ(image.byteCount(0x102, 0x106), 3U);
    EXPECT_EQ(image.byteCount(0, 0xFFFFFFFF), 6U);
    EXPECT_EQ(image.byteCount(0x104, 0x105), 0U);
    EXPECT_EQ(image.byteCount(0x103, 0x100), 0U);
}

TEST(FirmwareImage, JoinsRecordsInAnyOrder)
{
    const FirmwareImage image = read(data(0x14, {5, 6}) + data(0x30, {9}) + data(0x10, {1, 2, 3, 4}) + end);
    ASSERT_EQ(image.segments().size(), 2U);
    const auto &segment = image.segments().front();
    EXPECT_EQ(segment.first, 0x10U);
    EXPECT_EQ(segment.last, 0x15U);
    const auto bytes = image.bytes(segment);
    EXPECT_EQ(std::vector<std::uint8_t>(bytes.begin(), bytes.end()), (std::vector<std::uint8_t>{1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(image.bytes(image.segments().back())[0], 9);
}

TEST(FirmwareImage, OverlaysOnlyWhatItHas)
{
    const FirmwareImage image = read(data(0x100, {1, 2, 3, 4}) + data(0x106, {7, 8}) + end);
    std::array<std::uint8_t, 6> out{};
    out.fill(0xEE);
    image.overlay(0x102, out);
    EXPECT_EQ(out, (std::array<std::uint8_t, 6>{3, 4, 0xEE, 0xEE, 7, 8}));
    out.fill(0xEE);
    image.overlay(0xFE, out);
    EXPECT_EQ(out, (std::array<std::uint8_t, 6>{0xEE, 0xEE, 1, 2, 3, 4}));
    out.fill(0xEE);
    image.overlay(0x200, out);
    image.overlay(0xFFFFFFFE, out);
    image.overlay(0x100, std::span(out).first(0));
    EXPECT_EQ(out, (std::array<std::uint8_t, 6>{0xEE, 0xEE, 0xEE, 0xEE, 0xEE, 0xEE}));
}

TEST(FirmwareImage, ReachesTheLastAddress)
{
    const FirmwareImage image = read(record(4, {0xFF, 0xFF}) + data(0xFFFE, {1, 2}) + end);
    EXPECT_EQ(image.at(0xFFFFFFFF), 2);
    EXPECT_EQ(image.segments().front().size(), 2U);
    std::array<std::uint8_t, 4> out{};
    image.overlay(0xFFFFFFFD, out);
    EXPECT_EQ(out, (std::array<std::uint8_t, 4>{0, 1, 2, 0}));
    EXPECT_EQ(image.byteCount(0xFFFFFFFF, 0xFFFFFFFF), 1U);
}

TEST(IntelHex, AppliesExtendedAddresses)
{
    const FirmwareImage image = read(data(0x10, {1}) + record(4, {0x01, 0x02}) + data(0x10, {2})
        + record(2, {0xF0, 0x01}) + data(0x10, {3}) + record(4, {0, 0}) + data(0x11, {4}) + end);
    EXPECT_EQ(image.at(0x00000010), 1);
    EXPECT_EQ(image.at(0x01020010), 2);
    EXPECT_EQ(image.at(0x000F0020), 3);
    EXPECT_EQ(image.at(0x00000011), 4);
    EXPECT_EQ(image.byteCount(), 4U);
}

TEST(IntelHex, GoesOnPastALinearWindow)
{
    const FirmwareImage image = read(record(4, {0, 1}) + data(0xFFFF, {1, 2}) + end);
    EXPECT_EQ(image.at(0x1FFFF), 1);
    EXPECT_EQ(image.at(0x20000), 2);
}

TEST(IntelHex, PassesOverStartAddresses)
{
    const FirmwareImage image = read(record(3, {0, 1, 2, 3}) + data(0, {1}) + record(5, {0, 1, 2, 3}) + end);
    EXPECT_EQ(image.byteCount(), 1U);
}

TEST(IntelHex, PassesOverEmptyDataRecords)
{
    EXPECT_EQ(read(data(0x10, {}) + data(0, {1}) + end).byteCount(), 1U);
}

TEST(IntelHex, ReadsEveryLineEndCaseAndBlank)
{
    const std::string plain = ":020000040000FA\n:04EFFC00ABcd0000"
                              "99\n:00000001FF\n";
    ASSERT_EQ(read(plain).at(0xEFFD), 0xCD);
    for (const std::string lineEnd : {"\n", "\r\n", "\r", " \t\r\n", "\n\n", "\n  \n"}) {
        const std::string text
            = "\xEF\xBB\xBF:020000040000fa" + lineEnd + ":04effc00abcd000099" + lineEnd + ":00000001FF" + lineEnd;
        EXPECT_EQ(read(text).at(0xEFFD), 0xCD);
        EXPECT_EQ(read(lineEnd + text.substr(3)).byteCount(), 4U);
    }
    EXPECT_EQ(read(":04EFFC00ABCD000099\n:00000001FF").byteCount(), 4U);
}

TEST(IntelHex, CountsLinesWhateverEndsThem)
{
    for (const std::string lineEnd : {"\n", "\r\n", "\r"})
        EXPECT_EQ(refusal(lineEnd + lineEnd + "x" + lineEnd).substr(0, 7), "line 3:");
}

TEST(IntelHex, AllowsOverlapOfEqualBytes)
{
    const FirmwareImage image
        = read(data(0x10, {1, 2, 3, 4}) + data(0x12, {3, 4, 5}) + data(0x10, {1, 2, 3, 4}) + data(0x11, {2}) + end);
    EXPECT_EQ(image.byteCount(), 5U);
    EXPECT_EQ(image.at(0x14), 5);
    EXPECT_EQ(image.segments().size(), 1U);
}

TEST(IntelHex, NamesBothLinesOfAConflict)
{
    EXPECT_EQ(refusal(data(0x400, {1, 2}) + data(0x500, {0}) + data(0x401, {0xAB}) + end),
        "line 3: address 0x00401 is 0xAB here and 0x02 in line 1");
    EXPECT_EQ(refusal(data(0x401, {0xAB}) + data(0x400, {1, 2}) + end),
        "line 2: address 0x00401 is 0x02 here and 0xAB in line 1");
    // An equal repetition, then a different byte deep inside what is known already.
    EXPECT_EQ(refusal(data(0, {1, 2, 3, 4}) + data(0, {1, 2}) + data(2, {9}) + end),
        "line 3: address 0x00002 is 0x09 here and 0x03 in line 1");
}

struct Malformed {
    std::string name;
    std::string text;
    std::string detail;
};

std::vector<Malformed> malformedLines()
{
    return {
        {"no colon", "00000001FF\n", "line 1: '0' where a record begins with a colon, is this an Intel HEX file?"},
        {"blank in front", " :00000001FF\n",
            "line 1: ' ' where a record begins with a colon, is this an Intel HEX file?"},
        {"odd digits", data(0, {1}) + ":00000001F\n", "line 2: 9 digits, an even number is needed"},
        {"no digits", ":\n", "line 1: the record is cut off after 0 bytes"},
        {"short", ":000000FF\n", "line 1: the record is cut off after 4 bytes"},
        {"not hexadecimal", ":0000000lFF\n", "line 1: 'l' is not a hexadecimal digit"},
        {"sign", ":-1000001FF\n", "line 1: '-' is not a hexadecimal digit"},
        {"two records", ":00000001FF:00000001FF\n", "line 1: ':' is not a hexadecimal digit"},
        {"too few bytes", ":04000000010203F6\n", "line 1: 4 data bytes are announced, 3 are there"},
        {"too many bytes", ":0100000001020304F5\n", "line 1: 1 data bytes are announced, 4 are there"},
        {"checksum", "\n\n" + data(0, {1}) + ":04EFFC0017010000F8\n", "line 4: checksum is 0xF8, 0xF9 is needed"},
        {"unknown type", record(6, {}), "line 1: record type 0x06 is unknown"},
        {"type FF", record(0xFF, {1, 2}), "line 1: record type 0xFF is unknown"},
        {"size of 01", record(1, {0}), "line 1: a record of type 01 has 0 data bytes, not 1"},
        {"size of 02", record(2, {0}), "line 1: a record of type 02 has 2 data bytes, not 1"},
        {"size of 03", record(3, {0, 0}), "line 1: a record of type 03 has 4 data bytes, not 2"},
        {"size of 04", record(4, {}), "line 1: a record of type 04 has 2 data bytes, not 0"},
        {"size of 05", record(5, {0, 0, 0, 0, 0}), "line 1: a record of type 05 has 4 data bytes, not 5"},
    };
}

std::vector<Malformed> malformedFiles()
{
    const std::string segment = "the data runs past the end of its 64 KiB segment";
    return {
        {"empty", "", "line 1: the file is empty"},
        {"blank", " \n\r\n\t\n", "line 3: the file is empty"},
        {"only a mark", "\xEF\xBB\xBF", "line 1: the file is empty"},
        {"no data", end, "line 1: the file holds no data"},
        {"no end", data(0, {1}) + data(1, {1}), "line 2: the end-of-file record is missing, the file may be cut off"},
        {"cut in a line", data(0, {1}) + ":0400", "line 2: the record is cut off after 2 bytes"},
        {"data after end", data(0, {1}) + end + data(1, {2}), "line 3: something follows the end-of-file record"},
        {"two ends", data(0, {1}) + end + end, "line 3: something follows the end-of-file record"},
        {"NUL after end", data(0, {1}) + end + std::string(1, '\0'),
            "line 3: something follows the end-of-file record"},
        {"program",
            std::string("\x7F"
                        "ELF\x02\x01\0\0",
                8),
            "line 1: byte 0x7F where a record begins with a colon, is this an Intel HEX file?"},
        {"16-bit text",
            std::string("\xFF\xFE:\0"
                        "0\0",
                6),
            "line 1: byte 0xFF where a record begins with a colon, is this an Intel HEX file?"},
        {"NUL as digit",
            std::string(":00\0"
                        "0001FF\n",
                11),
            "line 1: byte 0x00 is not a hexadecimal digit"},
        {"high byte",
            ":0000\xC3\xA4"
            "01FF\n",
            "line 1: byte 0xC3 is not a hexadecimal digit"},
        {"no base", data(0xFFFF, {1, 2}) + end, "line 1: " + segment},
        {"segment wrap", record(2, {0x10, 0}) + data(0xFFFF, {1, 2}) + end, "line 2: " + segment},
        {"address overflow", record(4, {0xFF, 0xFF}) + data(0xFFFF, {1, 2}) + end,
            "line 2: the data runs past the end of 32-bit addresses"},
    };
}

TEST(IntelHex, RefusesEachMalformedLineWithItsCause)
{
    for (const Malformed &file : malformedLines())
        EXPECT_EQ(refusal(file.text), file.detail) << file.name;
}

TEST(IntelHex, RefusesEachMalformedFileWithItsCause)
{
    for (const Malformed &file : malformedFiles())
        EXPECT_EQ(refusal(file.text), file.detail) << file.name;
}

TEST(IntelHex, AcceptsTheLastAddressOfASegment)
{
    EXPECT_EQ(read(record(2, {0xFF, 0xFF}) + data(0xFFFE, {1, 2}) + end).at(0x10FFEF), 2);
    EXPECT_EQ(read(data(0xFFFE, {1, 2}) + end).at(0xFFFF), 2);
}

TEST(IntelHex, SeesEveryFlippedDigit)
{
    const std::string text = data(0x400, {0x12, 0x34, 0x56, 0x78}) + end;
    for (std::size_t i = 1; i + 1 < data(0x400, {0x12, 0x34, 0x56, 0x78}).size(); ++i) {
        for (const char digit : std::string("0123456789ABCDEF")) {
            std::string changed = text;
            changed[i] = digit;
            if (changed != text) {
                EXPECT_NE(refusal(changed), "accepted") << changed;
            }
        }
    }
}

TEST(IntelHex, IsWrittenInLinesOfSixteenBytesThatEndWhereAWindowDoes)
{
    std::vector<std::uint8_t> bytes(20);
    std::iota(bytes.begin(), bytes.end(), std::uint8_t(1));
    const auto part = [&bytes](std::uint32_t address, std::size_t from, std::size_t size) {
        return hexRecord(0, address, std::span(bytes).subspan(from, size));
    };
    EXPECT_EQ(toIntelHex(read(part(0x400, 0, 20) + end)), part(0x400, 0, 16) + part(0x410, 16, 4) + end);
    const std::string upper = record(4, {0x00, 0x01});
    const std::string across = part(0xFFF8, 0, 8) + upper + part(0x0000, 8, 12);
    EXPECT_EQ(toIntelHex(read(across + end)), across + end);
}

TEST(IntelHex, RefusesATextThatIsTooLong)
{
    std::string text(FirmwareImage::maxTextSize + 1, '\n');
    EXPECT_EQ(refusal(text), "the text is longer than 16 MiB");
    text.resize(FirmwareImage::maxTextSize);
    EXPECT_EQ(refusal(text), "line 16777216: the file is empty");
}

TEST(IntelHex, NeedsNoMemoryForGaps)
{
    std::string text;
    for (int i = 0; i < 256; ++i)
        text += record(4, {static_cast<std::uint8_t>(i), 0}) + data(0x8000, {static_cast<std::uint8_t>(i)});
    const FirmwareImage image = read(text + end);
    EXPECT_EQ(image.byteCount(), 256U);
    EXPECT_EQ(image.segments().size(), 256U);
    EXPECT_EQ(image.at(0xAB008000), 0xAB);
}

TEST(IntelHex, ReadsWhatTheTestTextBuilderWrites)
{
    std::vector<std::uint8_t> bytes(300);
    for (std::size_t i = 0; i < bytes.size(); ++i)
        bytes[i] = static_cast<std::uint8_t>((i * 7) & 0xFFU);
    const FirmwareImage image = read(HexText().add(0x1FFF0, bytes).text());
    ASSERT_EQ(image.segments().size(), 1U);
    const auto got = image.bytes(image.segments().front());
    EXPECT_TRUE(std::equal(bytes.begin(), bytes.end(), got.begin(), got.end()));
    EXPECT_EQ(image.segments().front().first, 0x1FFF0U);
}

} // namespace
} // namespace mb
