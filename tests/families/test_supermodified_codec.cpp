// SPDX-License-Identifier: GPL-3.0-or-later
// Golden vectors (supermodified/README.md#vectors), with where they come from: DS the datasheet's examples, LIB the
// vendor's library executed, FW the vendor's D1 image executed, FW32 its D2 image.
#include "families/supermodified/codec.h"
#include "families/supermodifiedvectors.h"

#include <gtest/gtest.h>

#include <random>

namespace mb::supermodified {
namespace {

using test::bytesOf;
using test::examples;
using test::framesIn;

TEST(SupermodifiedFrame, EveryExampleOfTheDatasheetIsOneFrameAndOnlyFourHaveTheWrongChecksum)
{
    int frames = 0;
    int wrong = 0;
    for (const test::Example &example : examples) {
        const auto printed = framesIn(bytesOf(example.host));
        ++frames;
        if (!example.right.empty()) {
            ++wrong;
            EXPECT_TRUE(printed.empty()) << example.name;
        }
        const auto corrected = framesIn(test::correctedBytes(example));
        ASSERT_EQ(corrected.size(), 1U) << example.name;
        EXPECT_EQ(uartBytes(corrected.front()), test::correctedBytes(example)) << example.name;
        if (example.node.empty())
            continue;
        ++frames;
        const auto answer = framesIn(bytesOf(example.node));
        ASSERT_EQ(answer.size(), 1U) << example.name;
        EXPECT_EQ(uartBytes(answer.front()), bytesOf(example.node)) << example.name;
    }
    EXPECT_EQ(frames, 94);
    EXPECT_EQ(wrong, 4);
}

TEST(SupermodifiedCodec, EncodesEveryExampleOfTheDatasheet)
{
    for (const test::Example &example : examples) {
        const auto wanted = test::correctedBytes(example);
        const auto command = static_cast<Command>(wanted[4]);
        if (wanted[5] == 0) {
            EXPECT_EQ(uartBytes(request(wanted[2], 1, command)), wanted) << example.name;
            continue;
        }
        const auto made = request(wanted[2], 1, command, Dialect::D1, example.value.value_or(0));
        ASSERT_TRUE(made) << example.name;
        EXPECT_EQ(uartBytes(*made), wanted) << example.name;
    }
}

TEST(SupermodifiedCodec, DecodesEveryAnswerOfTheDatasheet)
{
    for (const test::Example &example : examples) {
        if (example.node.empty())
            continue;
        const Frame reply = framesIn(bytesOf(example.node)).front();
        EXPECT_TRUE(answers(reply, reply.from, 1, static_cast<Command>(reply.command))) << example.name;
        if (reply.size == 0 || !example.value)
            continue;
        EXPECT_EQ(valueOf(reply.payload(), formatOf(static_cast<Command>(reply.command), Dialect::D1)), example.value)
            << example.name;
    }
    const Frame analog = framesIn(bytesOf("55 AA 01 04 6E 08 00 02 00 02 00 02 00 02 66")).front();
    EXPECT_EQ(analogOf(analog.payload()), (std::array<std::uint16_t, 4>{512, 512, 512, 512}));
}

struct Made {
    std::string_view source;
    Dialect dialect;
    Command command;
    std::int64_t value;
    std::string_view bytes;
};
constexpr Made commands[]{
    {"S1 DS LIB FW", Dialect::D3, Command::P, 2000, "55 AA 04 01 00 02 D0 07 D5"},
    {"S2 DS LIB FW", Dialect::D2, Command::D, 10000, "55 AA 04 01 02 02 10 27 37"},
    {"S4 LIB FW32", Dialect::D2, Command::ProfileAcceleration, 800, "55 AA 04 01 03 04 20 03 00 00 24"},
    {"S4 LIB FW32", Dialect::D3, Command::ProfileAcceleration, 800, "55 AA 04 01 03 04 20 03 00 00 24"},
    {"S5 LIB FW32", Dialect::D2, Command::ProfileVelocity, 800, "55 AA 04 01 04 04 20 03 00 00 23"},
    {"S7 LIB FW", Dialect::D3, Command::CurrentLimitDuration, 10000, "55 AA 04 01 06 02 10 27 33"},
    {"S8 DS FW", Dialect::D1, Command::MoveVelocity, 500, "55 AA 04 01 07 02 F4 01 F0"},
    {"S10 LIB FW32", Dialect::D2, Command::MoveVelocity, -5000, "55 AA 04 01 07 04 78 EC FF FF 97"},
    {"S10 LIB FW32", Dialect::D3, Command::MoveVelocity, -5000, "55 AA 04 01 07 04 78 EC FF FF 97"},
    {"S11 FW", Dialect::D2, Command::MoveAbsolute, 10240, "55 AA 04 01 08 04 00 28 00 00 24"},
    {"S13 FW", Dialect::D1, Command::MoveRelative, -3000, "55 AA 04 01 09 04 48 F4 FF FF B1"},
    {"S14 LIB", Dialect::D3, Command::MoveRelative, -3000, "55 AA 04 01 09 08 48 F4 FF FF FF FF FF FF BD"},
    {"S16 DS FW", Dialect::D1, Command::MoveProfiledAbsolute, -3000, "55 AA 04 01 0B 04 48 F4 FF FF B3"},
    {"S17 LIB", Dialect::D3, Command::MoveProfiledAbsolute, -3000, "55 AA 04 01 0B 08 48 F4 FF FF FF FF FF FF BF"},
    {"S19 DS FW", Dialect::D1, Command::BufferProfiledVelocity, 783, "55 AA 04 01 10 02 0F 03 1E"},
    {"S20 FW", Dialect::D2, Command::BufferProfiledAbsolute, 0, "55 AA 04 01 11 04 00 00 00 00 15"},
    {"S22 DS LIB FW", Dialect::D2, Command::NodeId, 5, "55 AA 04 01 15 01 05 11"},
    {"S29 DS FW", Dialect::D1, Command::ErrorLevel, 1, "55 AA 04 01 1C 01 01 1C"},
    {"S31 LIB", Dialect::D3, Command::AntiWindup, 100000, "55 AA 04 01 1D 04 A0 86 01 00 3E"},
    {"LIB sample: 15×0, 1, 1, 2, 2, 1", Dialect::D3, Command::ErrorLevel, 0x1A5LL << 30,
        "55 AA 04 01 1C 14 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 01 01 02 02 01 09"},
};

TEST(SupermodifiedCodec, EncodesTheVectorsOfTheOtherDialects)
{
    for (const Made &row : commands) {
        const auto frame = request(4, 1, row.command, row.dialect, row.value);
        ASSERT_TRUE(frame) << row.source;
        EXPECT_EQ(uartBytes(*frame), bytesOf(row.bytes)) << row.source << ' ' << row.bytes;
    }
    EXPECT_EQ(uartBytes(request(4, 1, Command::ResetErrors)), bytesOf("55 AA 04 01 1E 00 1E")) << "S32 LIB FW";
}

struct Read {
    std::string_view source;
    Dialect dialect;
    std::string_view bytes;
    std::int64_t value;
};
constexpr Read reads[]{
    {"R2 LIB", Dialect::D3, "55 AA 01 04 6F 08 33 16 00 00 00 00 00 00 42", 5683},
    {"R3 LIB", Dialect::D3, "55 AA 01 04 6F 08 48 F4 FF FF FF FF FF FF DB", -3000},
    {"R5 LIB", Dialect::D2, "55 AA 01 04 71 04 0C FE FF FF 87", -500},
    {"R5 LIB", Dialect::D3, "55 AA 01 04 71 04 0C FE FF FF 87", -500},
    {"R6 FW", Dialect::D1, "55 AA 01 04 64 02 A0 0F C9", 4000},
    {"R8 FW", Dialect::D1, "55 AA 01 04 66 02 E8 03 8F", 1000},
    {"R9 FW32", Dialect::D2, "55 AA 01 04 67 04 20 03 00 00 40", 800},
    {"R11 DS FW", Dialect::D3, "55 AA 01 04 6C 01 FF 92", 255},
    {"R12 FW", Dialect::D1, "55 AA 01 04 6D 01 0F 63", 15},
    {"R14 FW", Dialect::D1, "55 AA 01 04 70 02 23 01 50", 291},
};

TEST(SupermodifiedCodec, DecodesTheVectorsOfTheOtherDialectsAndNoOthersLength)
{
    for (const Read &row : reads) {
        const Frame reply = framesIn(bytesOf(row.bytes)).at(0);
        const Format format = formatOf(static_cast<Command>(reply.command), row.dialect);
        EXPECT_EQ(valueOf(reply.payload(), format), row.value) << row.source;
        EXPECT_FALSE(valueOf(reply.payload().first(reply.size - 1U), format)) << row.source;
    }
}

TEST(SupermodifiedCodec, DecodesErrorFramesWithAllTheirCodes)
{
    const Frame one = framesIn(bytesOf("55 AA 01 04 FA 01 11 EA")).at(0); // R17 FW
    EXPECT_TRUE(answers(one, 4, 1, Command::Stop));
    EXPECT_EQ(codesText(*codesOf(one)), "it has no such command (11)");
    Frame eight = request(1, 4, Command::Error);
    eight.size = 8;
    for (std::uint8_t i = 0; i < 8; ++i)
        eight.data.at(i) = i;
    EXPECT_EQ(codesOf(eight)->size(), 8U);
    EXPECT_FALSE(codesOf(request(1, 4, Command::Error))) << "an error frame without a code";
    const Frame warnings = framesIn(bytesOf("55 AA 01 04 73 03 15 15 15 65")).at(0); // R15 FW
    EXPECT_EQ(warnings.size, 3);
    EXPECT_FALSE(codesOf(warnings));
}

TEST(SupermodifiedCodec, TellsTheDialectsByTheLengthsOfReplies)
{
    EXPECT_EQ(isThirdGeneration(framesIn(bytesOf("55 AA 01 04 6F 08 33 16 00 00 00 00 00 00 42")).at(0)), true);
    EXPECT_EQ(isThirdGeneration(framesIn(bytesOf("55 AA 01 04 6F 04 33 16 00 00 4E")).at(0)), false);
    EXPECT_EQ(isThirdGeneration(framesIn(bytesOf("55 AA 01 04 FA 01 15 EE")).at(0)), std::nullopt);
    EXPECT_EQ(dialectByVelocity(framesIn(bytesOf("55 AA 01 04 71 02 90 01 E2")).at(0)), Dialect::D1);
    EXPECT_EQ(dialectByVelocity(framesIn(bytesOf("55 AA 01 04 71 04 0C FE FF FF 87")).at(0)), Dialect::D2);
}

TEST(SupermodifiedCodec, RefusesWhatADialectHasNotOrCannotHold)
{
    EXPECT_EQ(request(4, 1, Command::AntiWindup, Dialect::D1, 5).error().fault, Fault::Unsupported);
    EXPECT_EQ(request(4, 1, Command::MoveVelocity, Dialect::D1, 32768).error().fault, Fault::OutOfRange);
    EXPECT_TRUE(request(4, 1, Command::MoveVelocity, Dialect::D2, 32768));
    EXPECT_EQ(request(4, 1, Command::MoveAbsolute, Dialect::D2, 2147483648LL).error().fault, Fault::OutOfRange);
    EXPECT_TRUE(request(4, 1, Command::MoveAbsolute, Dialect::D3, 2147483648LL));
    EXPECT_EQ(request(4, 1, Command::ErrorLevel, Dialect::D3, 3).error().fault, Fault::OutOfRange) << "no reaction 3";
}

TEST(SupermodifiedCodec, NoFrameOfDialectsD1AndD2HoldsMoreThanSixteenBytes)
{
    for (const CommandForm &message : messages()) {
        for (const Dialect dialect : {Dialect::D1, Dialect::D2})
            EXPECT_LE(sizeOf(message.formatIn(dialect)), mostDataD1D2) << message.name;
        EXPECT_LE(sizeOf(message.formatIn(Dialect::D3)), mostData) << message.name;
    }
}

TEST(SupermodifiedCodec, EveryWidthKeepsItsExtremes)
{
    for (int bit = 0; bit < 63; ++bit) {
        for (const std::int64_t value :
            {std::int64_t{1} << bit, -(std::int64_t{1} << bit), (std::int64_t{1} << bit) - 1}) {
            const auto frame = request(4, 1, Command::MoveAbsolute, Dialect::D3, value);
            ASSERT_TRUE(frame);
            EXPECT_EQ(valueOf(frame->payload(), Format::I64), value);
        }
    }
    for (std::int64_t value = -32768; value <= 32767; ++value)
        ASSERT_EQ(valueOf(request(4, 1, Command::MoveVelocity, Dialect::D1, value)->payload(), Format::I16), value);
}

// I2C

TEST(SupermodifiedI2c, CarriesAndIdAndNoHeader)
{
    // 5 + bCnt bytes, as the firmware and the vendor's library do it; the datasheet's frame without AndID is wrong
    EXPECT_EQ(i2cBytes(*request(4, 1, Command::P, Dialect::D1, 2000)), bytesOf("04 01 00 02 D0 07 D5"));
    EXPECT_EQ(i2cBytes(request(4, 1, Command::GetPosition)), bytesOf("04 01 6F 00 6F"));
    const auto reply = fromI2c(bytesOf("01 04 6F 04 33 16 00 00 4E"));
    ASSERT_TRUE(reply);
    EXPECT_EQ(valueOf(reply->payload(), Format::I32), 5683);
}

TEST(SupermodifiedI2c, EveryExampleOfTheDatasheetPassesWithoutItsHeaderAndItsTwinsDoNot)
{
    for (const test::Example &example : examples) {
        auto bytes = test::correctedBytes(example);
        bytes.erase(bytes.begin(), bytes.begin() + 2);
        const auto frame = fromI2c(bytes);
        ASSERT_TRUE(frame) << example.name;
        EXPECT_EQ(i2cBytes(*frame), bytes) << example.name;
        auto bad = bytes;
        bad.back() ^= 0x01U;
        EXPECT_FALSE(fromI2c(bad)) << example.name;
        bytes.push_back(0);
        EXPECT_FALSE(fromI2c(bytes)) << example.name << ": wrong length";
    }
}

// The stream

TEST(SupermodifiedStream, FindsAFrameBehindGarbageAndBehindHalfAFrame)
{
    const auto good = bytesOf("55 AA 01 04 6F 04 33 16 00 00 4E");
    for (const std::string_view before : {"55", "55 55", "55 AA", "55 AA 01", "55 AA 01 04 6F 04 33 16", "AA 55 AA 55",
             "55 AA 01 04 6F FF", "55 AA 01 04 FA 01 15 EF", "00 FF 55 AA AA"}) {
        auto bytes = bytesOf(before);
        bytes.insert(bytes.end(), good.begin(), good.end());
        const auto again = framesIn(bytes);
        ASSERT_FALSE(again.empty()) << before;
        EXPECT_EQ(uartBytes(again.back()), good) << before;
    }
}

TEST(SupermodifiedStream, TakesFramesInAnyPieces)
{
    std::vector<std::uint8_t> all;
    std::size_t wanted = 0;
    for (const test::Example &example : examples) {
        const auto bytes = test::correctedBytes(example);
        all.insert(all.end(), bytes.begin(), bytes.end());
        ++wanted;
    }
    for (std::size_t piece = 1; piece < 12; ++piece) {
        std::size_t frames = 0;
        FrameReader reader([&frames](const Frame &) { ++frames; });
        for (std::size_t at = 0; at < all.size(); at += piece)
            reader.feed(std::span(all).subspan(at, std::min(piece, all.size() - at)));
        EXPECT_EQ(frames, wanted) << piece;
        EXPECT_EQ(reader.discarded(), 0U);
        EXPECT_TRUE(reader.isEmpty());
    }
}

TEST(SupermodifiedStream, AFlippedBitUnderTheChecksumIsNeverAFrame)
{
    for (const test::Example &example : examples) {
        const auto good = test::correctedBytes(example);
        for (std::size_t bit = 4 * 8; bit < good.size() * 8;
             ++bit) { // header and ids are not covered (supermodified/README.md#frames)
            auto bad = good;
            bad[bit / 8] = static_cast<std::uint8_t>(bad[bit / 8] ^ (1U << (bit % 8)));
            const auto frames = framesIn(bad);
            EXPECT_TRUE(frames.empty()) << example.name << " bit " << bit;
        }
    }
}

TEST(SupermodifiedStream, RandomBytesAndFramesAmongThem)
{
    std::mt19937 random(1);
    const auto good = bytesOf("55 AA 01 04 71 04 0C FE FF FF 87");
    for (int round = 0; round < 2000; ++round) {
        std::vector<std::uint8_t> bytes;
        for (std::size_t i = random() % 40; i > 0; --i)
            bytes.push_back(static_cast<std::uint8_t>(random() % 3 == 0 ? 0x55 : random()));
        const std::size_t noise = bytes.size();
        bytes.insert(bytes.end(), good.begin(), good.end());
        bytes.insert(bytes.end(), mostData + frameOverhead, 0); // pushes out what garbage looked like a frame
        std::size_t found = 0;
        std::uint64_t used = 0;
        FrameReader reader([&](const Frame &frame) {
            used += frameOverhead + frame.size;
            found += uartBytes(frame) == good ? 1U : 0U;
        });
        reader.feed(bytes);
        EXPECT_LE(used + reader.discarded(), bytes.size());
        if (used == good.size()) {
            EXPECT_EQ(found, 1U) << "round " << round << " after " << noise;
        }
    }
}

TEST(SupermodifiedFrame, WhatItsBytesMayStillBecome)
{
    struct Row {
        std::string_view bytes;
        Shape shape;
    };
    for (const Row &row : {Row{"", Shape::Incomplete}, {"55", Shape::Incomplete}, {"AA", Shape::Garbage},
             {"AA AA", Shape::Garbage}, {"55 AB", Shape::Garbage}, {"55 AA", Shape::Incomplete},
             {"55 AA 04 01 19", Shape::Incomplete}, {"55 AA 04 01 19 00", Shape::Incomplete},
             {"55 AA 04 01 19 00 19", Shape::Frame}, {"55 AA 04 01 19 00 18", Shape::Garbage},
             {"55 AA 04 01 19 16", Shape::Incomplete}, {"55 AA 04 01 19 17", Shape::Garbage}})
        EXPECT_EQ(shapeOf(bytesOf(row.bytes)), row.shape) << row.bytes;
    Frame longest = request(4, 1, Command::P);
    longest.size = mostData;
    EXPECT_EQ(shapeOf(uartBytes(longest)), Shape::Frame);
    EXPECT_TRUE(fromI2c(i2cBytes(longest)));
    EXPECT_FALSE(fromI2c(bytesOf("04 01 19 00"))) << "too short";
    EXPECT_TRUE(fromI2c(bytesOf("04 01 19 00 19")));
}

TEST(SupermodifiedStream, WhatIsForgottenCountsAsDiscardedAndTheNextFrameIsRead)
{
    std::size_t frames = 0;
    FrameReader reader([&frames](const Frame &) { ++frames; });
    reader.feed(bytesOf("55 AA 04"));
    EXPECT_FALSE(reader.isEmpty());
    EXPECT_EQ(reader.discarded(), 0U);
    reader.forget();
    EXPECT_TRUE(reader.isEmpty());
    EXPECT_EQ(reader.discarded(), 3U);
    reader.feed(bytesOf("55 AA 04 01 19 00 19"));
    EXPECT_EQ(frames, 1U);
    EXPECT_EQ(reader.discarded(), 3U);
    EXPECT_TRUE(reader.isEmpty());
}

TEST(SupermodifiedCodec, TheRangeOfEachWidthIsWhatARefusalNames)
{
    struct Row {
        Command command;
        Dialect dialect;
        std::int64_t low;
        std::int64_t high;
    };
    for (const Row &row : {Row{Command::Outputs, Dialect::D1, 0, 255}, {Command::P, Dialect::D1, 0, 65535},
             {Command::Baudrate, Dialect::D1, 0, 4294967295}, {Command::MoveVelocity, Dialect::D1, -32768, 32767},
             {Command::MoveVelocity, Dialect::D2, -2147483648LL, 2147483647}}) {
        EXPECT_TRUE(request(4, 1, row.command, row.dialect, row.low));
        EXPECT_TRUE(request(4, 1, row.command, row.dialect, row.high));
        for (const std::int64_t beyond : {row.low - 1, row.high + 1}) {
            const auto refused = request(4, 1, row.command, row.dialect, beyond);
            ASSERT_FALSE(refused) << beyond;
            EXPECT_NE(refused.error().text().find(std::to_string(beyond) + " is outside " + std::to_string(row.low)
                          + " … " + std::to_string(row.high)),
                std::string::npos)
                << refused.error().text();
        }
    }
    constexpr std::int64_t allHalts = 0xAAAAAAAAAALL; // reaction 2 of all twenty
    EXPECT_TRUE(request(4, 1, Command::ErrorLevel, Dialect::D3, allHalts));
    EXPECT_FALSE(request(4, 1, Command::ErrorLevel, Dialect::D3, allHalts + 1)) << "there is no reaction 3";
    EXPECT_FALSE(request(4, 1, Command::ErrorLevel, Dialect::D3, std::int64_t{1} << 40)) << "there are twenty";
    EXPECT_FALSE(request(4, 1, Command::ErrorLevel, Dialect::D3, -1));
    const auto halts = request(4, 1, Command::ErrorLevel, Dialect::D3, allHalts);
    EXPECT_EQ(valueOf(halts->payload(), Format::Reactions), allHalts);
    Frame three = *halts;
    three.data[7] = 3;
    EXPECT_FALSE(valueOf(three.payload(), Format::Reactions));
}

TEST(SupermodifiedCodec, AnAnswerIsOfItsNodeToItsHost)
{
    const Frame reply = framesIn(bytesOf("55 AA 01 04 00 00 00")).at(0);
    EXPECT_TRUE(answers(reply, 4, 1, Command::P));
    EXPECT_FALSE(answers(reply, 5, 1, Command::P));
    EXPECT_FALSE(answers(reply, 4, 119, Command::P));
    EXPECT_FALSE(answers(reply, 4, 1, Command::I));
    EXPECT_EQ(dialectByVelocity(framesIn(bytesOf("55 AA 01 04 71 01 90 E0")).at(0)), std::nullopt);
    EXPECT_EQ(dialectByVelocity(reply), std::nullopt);
    EXPECT_EQ(isThirdGeneration(framesIn(bytesOf("55 AA 01 04 6F 01 33 5D")).at(0)), std::nullopt);
    for (const Dialect dialect : {Dialect::D1, Dialect::D2, Dialect::D3})
        EXPECT_EQ(dialectFrom(toString(dialect)), dialect);
    EXPECT_EQ(dialectFrom("D4"), std::nullopt);
    EXPECT_EQ(codeText(0x01).english(), "the motor stalled (01)");
    EXPECT_EQ(codeText(0xEE).english(), "error (EE)");
    EXPECT_EQ(codesText(std::array<std::uint8_t, 2>{0x14, 0x52}).english(),
        "not possible while the motor is not started (14), wrong checksum (52)");
}

} // namespace
} // namespace mb::supermodified
