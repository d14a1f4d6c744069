// SPDX-License-Identifier: GPL-3.0-or-later
// Golden vectors (quadquad2drv/README.md#vectors): DS from the data sheet, LIB what the vendor's library sent or decoded
// when it was run against a stand-in.
#include "families/quadquad2drv/codec.h"
#include "families/quadquad2drvbytes.h"

#include <gtest/gtest.h>

namespace mb::quadquad2drv {
namespace {

using test::bytesOf;
using test::textOf;

struct EncodedRow {
    std::string_view name;
    Bytes made;
    std::string_view text;
};

TEST(QuadQuad2DrvCodec, RequestsAreTheBytesOfTheReference)
{
    const std::vector<EncodedRow> vectors{
        {"S1 DS LIB get version", getRequest(PacketId::GetVersion), "02 04 01 F9"},
        {"S2 LIB get motion", getRequest(PacketId::GetMotion), "02 04 02 F8"},
        {"S4 LIB stream off", setStreamPeriod(0), "02 06 04 00 00 F4"},
        {"S5 LIB get stream period", getRequest(PacketId::GetStreamPeriod), "02 04 05 F5"},
        {"S8 LIB get data mask", getRequest(PacketId::GetDataMask), "02 04 07 F3"},
        {"S10 LIB get stream config", getRequest(PacketId::GetStreamConfig), "02 04 09 F1"},
        {"S13 LIB get position ch3", getPositions(std::uint8_t{4}), "02 05 0B 04 EA"},
        {"S14 LIB get position by size", getPositions({1, 2, 3, 0}), "02 08 0B 01 02 03 00 E5"},
        {"S16 LIB get history", getRequest(PacketId::GetHistory), "02 04 0D ED"},
        {"S19 LIB all off", setControlMode(0x0F, ControlMode::Off), "02 06 10 0F 00 D9"},
        {"S20 LIB power", setPower(1, -2000), "02 07 12 01 30 F8 BC"},
        {"S22 LIB velocity target, unshifted", setVelocityTarget(2, -2000.0, {}), "02 09 16 02 30 F8 FF FF B7"},
        {"S23 LIB power limit", setPowerLimit(1, 2000), "02 07 18 01 D0 07 07"},
        {"S25 LIB velocity limit 0.5", setVelocityLimit(1, 2048), "02 09 1A 01 00 08 00 00 D2"},
        {"S26 LIB acceleration limit 2000", setAccelerationLimit(1, 2000U << 12U), "02 09 1C 01 00 00 7D 00 5B"},
        {"S28 LIB position gains", setPositionGains(1, {100, 500, 500, 600}), "02 0D 1E 01 64 00 F4 01 F4 01 58 02 2A"},
        {"S29 LIB velocity gains", setVelocityGains(1, {100, 200, 500}), "02 0B 20 01 64 00 C8 00 F4 01 B1"},
        {"S31 LIB velocity ramp", rampVelocity(1, 2000, 500.0), "02 0D 24 01 D0 07 00 00 00 40 1F 00 96"},
        {"S32 LIB probe", setControlMode(0, ControlMode::Off), "02 06 10 00 00 E8"},
    };
    for (const EncodedRow &vector : vectors)
        EXPECT_EQ(textOf(vector.made), vector.text) << vector.name;
}

TEST(QuadQuad2DrvCodec, TuplesThatTheLibraryPacksTogetherAreTheSameBytesOneByOne)
{
    // S7, S11 and S17 hold several tuples in a packet; these are theirs.
    EXPECT_EQ(textOf(setDataMask(0x01, 0x0B)).substr(0, 14), "02 06 06 01 0B");
    EXPECT_EQ(textOf(setPosition(0x01, 2, -2)).substr(9, 8), "21 FE FF");
    EXPECT_EQ(textOf(setPosition(0x02, 3, 100000)).substr(9, 14), "32 A0 86 01 00");
    EXPECT_EQ(textOf(setPosition(0x08, 0, 0)).substr(9, 2), "08");
    EXPECT_EQ(textOf(setInputMode(0x01, {0x19, 0, 0})).substr(9, 23), "01 19 00 00 00 00 00 00");
    EXPECT_EQ(textOf(setInputMode(0xFE, {0x00, 7, 7})).substr(0, 14), "02 06 0E FE 00") << "2 bytes when disabled";
}

TEST(QuadQuad2DrvCodec, AFullRangeAccelerationNeedsUnsigned32Bits)
{
    EXPECT_EQ(textOf(rampPosition(1, 0, 100'000.0, 1'000'000.0)).substr(24, 23), "00 00 6A 18 00 00 24 F4");
}

TEST(QuadQuad2DrvCodec, TheVelocityTargetIsShiftedOnlyWhenTheDeviceIsSetSo)
{
    EXPECT_EQ(textOf(setVelocityTarget(1, 2000.0, {})).substr(12, 11), "D0 07 00 00");
    EXPECT_EQ(textOf(setVelocityTarget(1, 2000.0, {.velocityTargetShifted = true})).substr(12, 11), "00 00 7D 00");
}

std::optional<Packet> read(std::string_view text)
{
    PacketReader reader;
    reader.feed(bytesOf(text));
    return reader.next();
}

TEST(QuadQuad2DrvCodec, RepliesDecodeToTheValuesOfTheReference)
{
    const auto version = parseVersion(*read("02 08 01 00 01 03 01 F0")); // R2 LIB
    ASSERT_TRUE(version);
    EXPECT_EQ(version->major, 1);
    EXPECT_EQ(version->minor, 3);
    EXPECT_EQ(version->protocol, 1);
    EXPECT_EQ(returnCode(*read("02 05 10 00 E9")), 0);                 // R3 LIB
    EXPECT_EQ(returnCode(*read("02 05 10 F6 F3")), -10);               // R5 LIB
    EXPECT_EQ(returnCode(*read("02 05 0E 00 EB")), 0);                 // R6 LIB
    EXPECT_EQ(parseStreamPeriod(*read("02 07 05 00 13 13 CC")), 4883); // R8 LIB
    const auto history = parseHistory(*read("02 07 0D 00 1F 14 B7"));  // R9 LIB
    ASSERT_TRUE(history);
    EXPECT_EQ(history->length, 31);
    EXPECT_EQ(history->timeBits, 20);
    const auto positions = parsePositions(*read("02 0C 0B 00 FF FE FF 01 00 00 00 EA"), {1, 2, 3, 0}); // R11 LIB
    ASSERT_TRUE(positions);
    EXPECT_EQ((*positions)[0], -1);
    EXPECT_EQ((*positions)[1], -2);
    EXPECT_EQ((*positions)[2], 1);
    EXPECT_FALSE((*positions)[3]);
}

TEST(QuadQuad2DrvCodec, MotionFollowsTheDataMasks)
{
    // R12 LIB
    const auto packet = read("02 15 02 00 88 13 00 00 30 F8 FF FF C8 FF 7F 10 27 00 00 80 29");
    ASSERT_TRUE(packet);
    const auto motion = parseMotion(*packet, {0x2B, 0x0A, 0x01, 0x00}, 0);
    ASSERT_TRUE(motion);
    EXPECT_EQ(motion->channels[0].position, 5000);
    EXPECT_EQ(motion->channels[0].velocity, -2000);
    EXPECT_EQ(motion->channels[0].status, 200);
    EXPECT_EQ(motion->channels[1].position, 32767);
    EXPECT_EQ(motion->channels[1].velocity, 10000);
    EXPECT_FALSE(motion->channels[1].status);
    EXPECT_EQ(motion->channels[2].position, -128);
    EXPECT_FALSE(motion->channels[3].position);
    EXPECT_FALSE(parseMotion(*packet, {0x2B, 0x0B, 0x01, 0x00}, 0)) << "masks that do not fit its length";
}

TEST(QuadQuad2DrvCodec, AStreamPacketHasNoReturnCode)
{
    Bytes payload{0x13, 0x13, 0x02, 0xFF};
    const Packet packet{3, payload};
    const auto motion = parseMotion(packet, {0x01, 0, 0, 0}, 0x03);
    ASSERT_TRUE(motion);
    EXPECT_EQ(motion->timing, 4883);
    EXPECT_EQ(motion->elapsed, 2);
    EXPECT_EQ(motion->channels[0].position, -1);
}

TEST(QuadQuad2DrvCodec, EveryWrongChecksumIsRefused)
{
    const Bytes good = bytesOf("02 08 01 00 01 03 01 F0");
    for (int wrong = 1; wrong < 256; ++wrong) {
        Bytes bad = good;
        bad.back() = static_cast<std::uint8_t>(bad.back() + wrong);
        PacketReader reader;
        reader.feed(bad);
        EXPECT_FALSE(reader.next()) << wrong;
    }
}

TEST(QuadQuad2DrvCodec, ThePacketReaderFindsItsWayThroughRubbish)
{
    PacketReader reader;
    reader.feed(bytesOf("00 FF 02 03 02 02 05 10 00 E9 00 02 05 0E")); // a size below 4, an STX in front of a packet
    const auto first = reader.next();
    ASSERT_TRUE(first);
    EXPECT_EQ(first->id, 16);
    EXPECT_FALSE(reader.next());
    EXPECT_EQ(reader.missing(), 2U);
    reader.feed(bytesOf("00 EB"));
    const auto second = reader.next();
    ASSERT_TRUE(second);
    EXPECT_EQ(second->id, 14);
    EXPECT_GT(reader.bad(), 0U);
}

TEST(QuadQuad2DrvCodec, AllPacketsOfAnySizeComeThroughInSingleBytes)
{
    PacketReader reader;
    for (std::size_t size = 0; size <= 251; ++size) {
        const Bytes payload(size, 0x02); // nothing is escaped
        std::optional<Packet> got;
        for (const std::uint8_t byte : encode(7, payload)) {
            EXPECT_FALSE(got);
            reader.feed({&byte, 1});
            got = reader.next();
        }
        ASSERT_TRUE(got) << size;
        EXPECT_EQ(got->payload, payload);
    }
}

TEST(QuadQuad2DrvCodec, ReplySizesAreThoseOfTheReference)
{
    const DataMasks masks{datamask::startUp, datamask::startUp, datamask::startUp, datamask::startUp};
    EXPECT_EQ(replySize(getRequest(PacketId::GetVersion), masks), 8U); // quadquad2drv/README.md#ready-line
    EXPECT_EQ(replySize(getRequest(PacketId::GetMotion), masks), 37U);
    EXPECT_EQ(replySize(getRequest(PacketId::GetMotion), {0x2B, 0x2B, 0x2B, 0x2B}), 41U);
    EXPECT_EQ(replySize(getRequest(PacketId::GetMotion), {0x03, 0, 0, 0}), 9U);
    EXPECT_EQ(streamPacketSize(masks, 0), 36U);
    EXPECT_EQ(streamPacketSize({0x2B, 0x2B, 0x2B, 0x2B}, 0x03), 43U);
    EXPECT_EQ(replySize(getRequest(PacketId::GetDataMask), masks), 9U); // the code, and a byte for each channel
    EXPECT_EQ(replySize(getRequest(PacketId::GetStreamPeriod), masks), 7U);
    EXPECT_EQ(replySize(getRequest(PacketId::GetHistory), masks), 7U);
    EXPECT_EQ(replySize(getRequest(PacketId::GetStreamConfig), masks), 6U);
    EXPECT_EQ(replySize(getRequest(PacketId::GetPosition), masks), 21U);
    EXPECT_EQ(replySize(getRequest(PacketId::GetPosition), {1, 0, 2, 3}), 12U);
    EXPECT_EQ(replySize(setPositionTarget(1, 0), masks), 5U);
    EXPECT_EQ(replySize(getPositions({1, 2, 3, 0}), masks), 12U);
    EXPECT_EQ(replySize(getPositions(std::uint8_t{4}), masks), 9U);
    EXPECT_EQ(replySize(getPositions({3, 0, 0, 1}), masks), 10U);
    EXPECT_EQ(replySize(getPositions({0, 2, 0, 0}), masks), 7U);
    const DataMasks different{1, 0, 2, 3};
    EXPECT_EQ(replySize(getPositions(std::uint8_t{1}), different), 6U);
    EXPECT_EQ(replySize(getPositions(std::uint8_t{4}), different), 7U);
    EXPECT_EQ(replySize(getPositions(std::uint8_t{8}), different), 9U);
}

TEST(QuadQuad2DrvCodec, ThePacketReaderSaysHowMuchIsMissing)
{
    const auto missing = [](std::string_view text) {
        PacketReader reader;
        reader.feed(bytesOf(text));
        EXPECT_FALSE(reader.next()) << text;
        return reader.missing();
    };
    EXPECT_EQ(missing("00 11"), 0U) << "nothing has begun";
    EXPECT_EQ(missing("00 02"), 1U) << "its size is not known";
    EXPECT_EQ(missing("02 08"), 6U);
    EXPECT_EQ(missing("02 08 01 00 01 03 01"), 1U);
    EXPECT_EQ(missing("02 04 01 F8"), 0U) << "given up, and nothing else has begun";
    PacketReader reader;
    reader.feed(bytesOf("00 02 05 10 00 E9"));
    EXPECT_EQ(reader.missing(), 0U) << "it is whole";
    EXPECT_TRUE(reader.next());
    reader.feed(bytesOf("FF 02"));
    EXPECT_EQ(reader.missing(), 1U) << "what stands before it is passed over";
    EXPECT_EQ(reader.bad(), 0U);
    reader.feed(bytesOf("03"));
    EXPECT_FALSE(reader.next());
    EXPECT_EQ(reader.bad(), 1U) << "no packet has three bytes";
}

TEST(QuadQuad2DrvCodec, AWordForEveryReturnCodeOfTheReference)
{
    for (const auto &[code, words] : std::vector<std::pair<int, std::string>>{{0, "accepted"},
             {-1, "the packet is too long for the board"}, {-10, "the board does not know this command"},
             {-11, "the board refused a value"}, {-12, "the board found the packet malformed"},
             {-127, "the board answered with an error that its documents do not name"},
             {-2, "the board answered with an error that its documents do not name"}})
        EXPECT_EQ(explain(static_cast<std::int8_t>(code)).english(), words) << code;
}

TEST(QuadQuad2DrvCodec, AReplyThatSaysNoIsNoAnswer)
{
    EXPECT_FALSE(parseVersion({1, {0xF6, 1, 3, 1}}));
    EXPECT_FALSE(parseVersion({2, {0, 1, 3, 1}})) << "of another request";
    EXPECT_FALSE(parseVersion({1, {0, 1, 3}}));
    EXPECT_FALSE(parseStreamPeriod({5, {0xF6, 1, 3}}));
    EXPECT_FALSE(parseStreamConfig({9, {0xF6, 1}}));
    EXPECT_FALSE(parseHistory({13, {0xF6, 1, 3}}));
    EXPECT_FALSE(parseDataMasks({7, {0xF6, 1, 2, 3, 4}}));
    EXPECT_FALSE(parsePositions({11, {0xF6, 1}}, {1, 0, 0, 0}));
    EXPECT_FALSE(parseMotion({2, {0xF6, 1}}, {1, 0, 0, 0}, 0));
    EXPECT_TRUE(parseMotion({2, {0, 1}}, {1, 0, 0, 0}, 0));
    EXPECT_TRUE(parseMotion({3, {1}}, {1, 0, 0, 0}, 0));
    EXPECT_FALSE(returnCode({16, {}}));
}

} // namespace
} // namespace mb::quadquad2drv
