// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/quadquad2drv/codec.h"
#include "families/quadquad2drv/decode.h"
#include "families/quadquad2drvbytes.h"
#include "wire/bytes.h"

#include <gtest/gtest.h>

#include <sstream>

namespace mb::quadquad2drv {
namespace {

/// What passes a board's SPI, packet by packet, as text: the message and its fields.
class QuadQuad2DrvDecode : public testing::Test {
protected:
    std::string asked(const Bytes &request) { return said(Direction::Sent, request); }
    std::string answered(PacketId id, const Bytes &payload)
    {
        return said(Direction::Received, encode(static_cast<std::uint8_t>(id), payload));
    }

private:
    std::string said(Direction direction, const Bytes &bytes)
    {
        std::vector<DecodedBytes> out;
        m_decoder->take({}, direction, bytes, out);
        EXPECT_EQ(out.size(), 1U);
        if (out.size() != 1 || !out[0].frame)
            return "nothing";
        std::ostringstream text;
        text << out[0].frame->message;
        for (const DecodedField &field : out[0].frame->fields)
            text << ' ' << field.name << '=' << field.value;
        return text.str();
    }

    std::unique_ptr<ByteDecoder> m_decoder = decodeBytes({});
};

TEST_F(QuadQuad2DrvDecode, MotionDataReadsAsTheMasksOfItsChannelsSay)
{
    EXPECT_EQ(asked(setDataMask(0x0F, 0)), "set data mask chan=15 data_mask=0");
    EXPECT_EQ(answered(PacketId::SetDataMask, {0}), "set data mask rc=0");
    EXPECT_EQ(asked(setDataMask(0x0A, 0x21)), "set data mask chan=10 data_mask=33");
    EXPECT_EQ(answered(PacketId::SetDataMask, {0}), "set data mask rc=0");
    EXPECT_EQ(answered(PacketId::GetMotion, {0, 0xFF, 0x81, 0x7F, 0x01}),
        "get motion data rc=0 position_2=-1 status_2=129 position_4=127 status_4=1");
    EXPECT_EQ(asked(setDataMask(0x01, 0x08)), "set data mask chan=1 data_mask=8");
    EXPECT_EQ(answered(PacketId::SetDataMask, {0}), "set data mask rc=0");
    EXPECT_EQ(answered(PacketId::GetMotion, {0, 0xFE, 0xFF, 0xFF, 0xFF, 0xFF, 0x81, 0x7F, 0x01}),
        "get motion data rc=0 velocity_1=-2 position_2=-1 status_2=129 position_4=127 status_4=1");
}

TEST_F(QuadQuad2DrvDecode, AMaskThatTheBoardRefusedChangesNothing)
{
    EXPECT_EQ(asked(setDataMask(0x0F, 0x20)), "set data mask chan=15 data_mask=32");
    EXPECT_EQ(answered(PacketId::SetDataMask, {0}), "set data mask rc=0");
    (void)asked(setDataMask(0x0F, 0x01));
    EXPECT_EQ(answered(PacketId::SetDataMask, {0xF5}), "set data mask rc=-11");
    EXPECT_EQ(answered(PacketId::GetMotion, {0, 1, 2, 3, 4}),
        "get motion data rc=0 status_1=1 status_2=2 status_3=3 status_4=4");
}

TEST_F(QuadQuad2DrvDecode, MasksThatWereReadCountAsThoseThatWereSet)
{
    EXPECT_EQ(answered(PacketId::GetDataMask, {0, 0, 0x01, 0, 0x20}),
        "get data mask rc=0 data_mask_1=0 data_mask_2=1 data_mask_3=0 data_mask_4=32");
    EXPECT_EQ(answered(PacketId::GetMotion, {0, 5, 6}), "get motion data rc=0 position_2=5 status_4=6");
}

TEST_F(QuadQuad2DrvDecode, AStreamReadsAsItsConfigurationSaysWhetherSetOrRead)
{
    (void)asked(setDataMask(0x0F, 0));
    (void)answered(PacketId::SetDataMask, {0});
    EXPECT_EQ(answered(PacketId::Stream, {}), "stream data");
    EXPECT_EQ(asked(setStreamConfig(3)), "set stream config config=3");
    EXPECT_EQ(answered(PacketId::Stream, {}), "stream data") << "it was on its way when the order came";
    EXPECT_EQ(answered(PacketId::SetStreamConfig, {0}), "set stream config rc=0");
    EXPECT_EQ(answered(PacketId::Stream, {0x10, 0x00, 0x07}), "stream data timing=16 elapsed=7");
    EXPECT_EQ(answered(PacketId::GetStreamConfig, {0, 2}), "get stream config rc=0 config=2");
    EXPECT_EQ(answered(PacketId::Stream, {0x07}), "stream data elapsed=7");
}

TEST_F(QuadQuad2DrvDecode, PositionsReadAsTheyWereAskedFor)
{
    EXPECT_EQ(asked(getPositions({1, 2, 3, 0})), "get position size_1=1 size_2=2 size_3=3 size_4=0");
    EXPECT_EQ(answered(PacketId::GetPosition, {0, 0xFF, 0x00, 0x01, 0x01, 0x00, 0x01, 0x00}),
        "get position rc=0 position_1=-1 position_2=256 position_3=65537");
    EXPECT_EQ(asked(getPositions(std::uint8_t{4})), "get position chan=4");
    EXPECT_EQ(answered(PacketId::GetPosition, {0, 0x01, 0x00, 0x00, 0x00}), "get position rc=0 position_3=1")
        << "as wide as the data mask of the third channel says";
    EXPECT_EQ(answered(PacketId::GetPosition, {0, 0x01, 0x00, 0x00, 0x00}), "get position rc=0")
        << "nobody asked: it could be any channel";
    (void)asked(getPositions({1, 2, 3, 0}));
    EXPECT_EQ(answered(PacketId::GetPosition, {0xF5}), "get position rc=-11");
}

TEST(QuadQuad2DrvDecodeControl, OnlyAnOrderToAMotorIsControlAndOnlyOnItsWayToTheBoard)
{
    const auto isControl = [](Direction direction, const Bytes &bytes) {
        const auto decoder = decodeBytes({});
        std::vector<DecodedBytes> out;
        decoder->take({}, direction, bytes, out);
        return out.size() == 1 && out[0].frame && out[0].frame->control;
    };
    const std::vector<Bytes> orders{setControlMode(1, ControlMode::Off), setPower(1, 5), setPositionTarget(1, 5),
        setVelocityTarget(1, 5.0, {}), rampPosition(1, 5, 5.0, 5.0), rampVelocity(1, 5, 5.0)};
    for (const Bytes &order : orders) {
        EXPECT_TRUE(isControl(Direction::Sent, order)) << static_cast<int>(order[2]);
        EXPECT_FALSE(isControl(Direction::Received, encode(order[2], Bytes{0})));
    }
    const std::vector<Bytes> others{getRequest(PacketId::GetVersion), getRequest(PacketId::GetMotion),
        getRequest(PacketId::GetDataMask), getRequest(PacketId::GetStreamConfig), getRequest(PacketId::GetPosition),
        setDataMask(1, 3), setStreamConfig(1), setStreamPeriod(50), setHistory(1, 2), setPosition(1, 3, 5),
        setPowerLimit(1, 5), setVelocityLimit(1, 5), setAccelerationLimit(1, 5), setPositionGains(1, {1, 2, 3, 4}),
        setVelocityGains(1, {1, 2, 3}), setInputMode(1, {})};
    for (const Bytes &other : others)
        EXPECT_FALSE(isControl(Direction::Sent, other)) << static_cast<int>(other[2]);
}

TEST_F(QuadQuad2DrvDecode, RepliesWithFieldsOfTheirOwnNeedNoQuestion)
{
    EXPECT_EQ(answered(PacketId::GetVersion, {0, 1, 3, 1}), "get version rc=0 major=1 minor=3 protocol=1");
    EXPECT_EQ(answered(PacketId::GetStreamPeriod, {0, 0x34, 0x12}), "get stream period rc=0 period=4660");
    EXPECT_EQ(answered(PacketId::GetHistory, {0, 31, 20}), "get history rc=0 length=31 time_bits=20");
}

TEST_F(QuadQuad2DrvDecode, EveryOrderIsReadFieldByField)
{
    struct Row {
        PacketId id;
        Bytes payload;
        std::string text;
    };
    const std::vector<Row> rows{
        {PacketId::SetStreamPeriod, {0x34, 0x12}, "set stream period period=4660"},
        {PacketId::SetHistory, {31, 20}, "set history length=31 time_bits=20"},
        {PacketId::SetControlMode, {0x01, 3, 0x02, 1}, "set control mode chan=1 mode=3 chan_2=2 mode_2=1"},
        {PacketId::SetPower, {0x01, 0x30, 0xF8}, "set motor power chan=1 power=-2000"},
        {PacketId::SetPower, {0x02, 0xFF, 0x1F}, "set motor power chan=2 power=8191"},
        {PacketId::SetPositionTarget, {0x04, 0x01, 0x02, 0x03, 0x84}, "position target chan=4 position=-2.08018e+09"},
        {PacketId::SetVelocityTarget, {0x02, 0x30, 0xF8, 0xFF, 0xFF}, "velocity target chan=2 velocity=-2000"},
        {PacketId::SetPowerLimit, {0x01, 0xFF, 0xFF}, "power limit chan=1 power=65535"},
        {PacketId::SetVelocityLimit, {0x01, 0x00, 0x08, 0x00, 0x00}, "velocity limit chan=1 velocity=0.5"},
        {PacketId::SetAccelerationLimit, {0x01, 0x00, 0x00, 0x24, 0xF4},
            "acceleration limit chan=1 acceleration=1e+06"},
        {PacketId::SetPositionGains, {0x01, 100, 0, 0xF4, 1, 0x58, 2, 0x00, 0x80},
            "position PID chan=1 p=100 i=500 d=600 windup=32768"},
        {PacketId::SetVelocityGains, {0x01, 100, 0, 0xC8, 0, 0xF4, 1}, "velocity PID chan=1 p=100 i=200 d=500"},
        {PacketId::RampPosition, {0x01, 0xFE, 0xFF, 0xFF, 0xFF, 0x00, 0x00, 0x7D, 0x00, 0x00, 0x40, 0x1F, 0x00},
            "position ramp chan=1 position=-2 velocity=2000 acceleration=500"},
        {PacketId::RampVelocity, {0x01, 0x30, 0xF8, 0xFF, 0xFF, 0x00, 0x40, 0x1F, 0x00},
            "velocity ramp chan=1 velocity=-2000 acceleration=500"},
        {PacketId::SetPosition, {0x08}, "set position chan=8 position=0"},
        {PacketId::SetPosition, {0x11, 0xFE}, "set position chan=17 position=-2"},
        {PacketId::SetPosition, {0x22, 0xFE, 0x7F}, "set position chan=34 position=32766"},
        {PacketId::SetPosition, {0x34, 0xA0, 0x86, 0x01, 0x00}, "set position chan=52 position=100000"},
        {PacketId::SetPosition, {0x21, 0xFE, 0xFF, 0x12, 0x05},
            "set position chan=33 position=-2 chan_2=18 position_2=5"},
        {PacketId::SetInputMode, {0x01, 0x19, 0x10, 0x27, 0xFE, 0xFF, 0xFF, 0xFF},
            "set input mode chan=1 cfg=25 spacing=10000 position=-2"},
        {PacketId::SetInputMode, {0x01, 0x00, 0x02, 0x11, 0x05, 0x00, 0x06, 0x00, 0x00, 0x00},
            "set input mode chan=1 cfg=0 chan_2=2 cfg_2=17 spacing_2=5 position_2=6"},
        {PacketId::SetDataMask, {1, 0x21, 2, 0x22, 4, 0x23, 8, 0x24},
            "set data mask chan=1 data_mask=33 chan_2=2 data_mask_2=34 chan_3=4 data_mask_3=35 chan_4=8 "
            "data_mask_4=36"},
    };
    for (const Row &row : rows)
        EXPECT_EQ(asked(encode(static_cast<std::uint8_t>(row.id), row.payload)), row.text);
}

TEST_F(QuadQuad2DrvDecode, AnOrderOfOtherThingsLeavesTheMasksAsTheyAre)
{
    (void)asked(setDataMask(0x0F, 0x20));
    (void)answered(PacketId::SetDataMask, {0});
    (void)asked(setControlMode(0x0F, ControlMode::Velocity));
    (void)answered(PacketId::SetControlMode, {0});
    EXPECT_EQ(answered(PacketId::Stream, {1, 2, 3, 4}), "stream data status_1=1 status_2=2 status_3=3 status_4=4");
    EXPECT_EQ(asked(getPositions({1, 0, 0, 0})), "get position size_1=1 size_2=0 size_3=0 size_4=0");
    EXPECT_EQ(answered(PacketId::GetHistory, {0, 1, 2}), "get history rc=0 length=1 time_bits=2")
        << "an answer to something else";
    EXPECT_EQ(answered(PacketId::GetPosition, {0, 7}), "get position rc=0");
    EXPECT_EQ(answered(PacketId::GetMotion, {0, 1, 2, 3, 4}),
        "get motion data rc=0 status_1=1 status_2=2 status_3=3 status_4=4");
    EXPECT_EQ(answered(PacketId::Stream, {1, 2, 3, 4}), "stream data status_1=1 status_2=2 status_3=3 status_4=4");
}

TEST_F(QuadQuad2DrvDecode, MasksOfOneOrderAreThoseOfItsChannels)
{
    (void)asked(encode(static_cast<std::uint8_t>(PacketId::SetDataMask), Bytes{1, 0x20, 2, 0x01, 4, 0, 8, 0x20}));
    (void)answered(PacketId::SetDataMask, {0});
    EXPECT_EQ(answered(PacketId::GetMotion, {0, 0x11, 0x12, 0x14}),
        "get motion data rc=0 status_1=17 position_2=18 status_4=20");
}

TEST_F(QuadQuad2DrvDecode, ABoardThatNobodyHasSetSendsPositionAndVelocityOfAllAndNoTimes)
{
    Bytes payload;
    std::string text = "stream data";
    for (std::uint8_t axis = 1; axis <= axes; ++axis) {
        payload.insert(payload.end(), {axis, 0, 0, 0, static_cast<std::uint8_t>(0x10 + axis), 0, 0, 0});
        const std::string of = "_" + std::to_string(axis);
        text += " position" + of + "=" + std::to_string(axis) + " velocity" + of + "=" + std::to_string(0x10 + axis);
    }
    EXPECT_EQ(answered(PacketId::Stream, payload), text);
}

TEST_F(QuadQuad2DrvDecode, AnAnswerThatLacksAFieldSetsNothing)
{
    (void)asked(setDataMask(0x0F, 0));
    (void)answered(PacketId::SetDataMask, {0});
    EXPECT_EQ(answered(PacketId::GetStreamConfig, {0, 2}), "get stream config rc=0 config=2");
    EXPECT_EQ(answered(PacketId::GetStreamConfig, {0}), "get stream config rc=0");
    EXPECT_EQ(answered(PacketId::Stream, {0x07}), "stream data elapsed=7") << "still as it said at first";
    EXPECT_EQ(answered(PacketId::GetStreamPeriod, {0, 0x34}), "get stream period rc=0");
}

TEST(QuadQuad2DrvDecodeUnits, AFieldHasTheUnitOfTheReference)
{
    const auto unitsOf = [](Direction direction, PacketId id, const Bytes &payload) {
        const auto decoder = decodeBytes({});
        std::vector<DecodedBytes> out;
        decoder->take({}, direction, encode(static_cast<std::uint8_t>(id), payload), out);
        std::string text;
        for (const DecodedField &field : out.at(0).frame->fields)
            text += std::string(field.name) + ":" + std::string(field.unit) + " ";
        return text;
    };
    EXPECT_EQ(unitsOf(Direction::Sent, PacketId::SetStreamPeriod, {1, 0}), "period:40.96 µs ");
    EXPECT_EQ(unitsOf(Direction::Received, PacketId::GetStreamPeriod, {0, 1, 0}), "rc: period:40.96 µs ");
    EXPECT_EQ(unitsOf(Direction::Sent, PacketId::SetPower, {1, 0, 0}), "chan: power:1/8191 ");
    EXPECT_EQ(unitsOf(Direction::Sent, PacketId::RampPosition, Bytes(13, 1)),
        "chan: position:counts velocity:counts/s acceleration:counts/s² ");
    EXPECT_EQ(unitsOf(Direction::Sent, PacketId::SetVelocityTarget, Bytes(5, 1)), "chan: velocity:counts/s ");
    EXPECT_EQ(unitsOf(Direction::Received, PacketId::Stream, Bytes(32, 0)),
        "position_1:counts velocity_1:counts/s position_2:counts velocity_2:counts/s position_3:counts "
        "velocity_3:counts/s position_4:counts velocity_4:counts/s ");
}

/// What passes in chunks, as "time direction bytes message", one line for each packet and for each run of other bytes.
class QuadQuad2DrvDecodeChunks : public testing::Test {
protected:
    void take(int milliseconds, Direction direction, const Bytes &chunk)
    {
        m_decoder->take(std::chrono::milliseconds(milliseconds), direction, chunk, m_out);
    }
    std::string text(bool finished = false)
    {
        if (finished)
            m_decoder->finish(m_out);
        std::ostringstream text;
        for (const DecodedBytes &part : std::exchange(m_out, {}))
            text << part.time / std::chrono::milliseconds(1) << (part.direction == Direction::Sent ? " > " : " < ")
                 << test::textOf(part.bytes) << (part.frame ? " " + std::string(part.frame->message) : "") << "; ";
        return text.str();
    }

private:
    std::unique_ptr<ByteDecoder> m_decoder = decodeBytes({});
    std::vector<DecodedBytes> m_out;
};

TEST_F(QuadQuad2DrvDecodeChunks, EachDirectionIsPutTogetherForItself)
{
    take(1, Direction::Sent, test::bytesOf("02 04"));
    take(2, Direction::Received, test::bytesOf("02 05 10"));
    EXPECT_EQ(text(), "");
    take(3, Direction::Sent, test::bytesOf("01 F9"));
    EXPECT_EQ(text(), "3 > 02 04 01 F9 get version; ");
    take(4, Direction::Received, test::bytesOf("00 E9"));
    EXPECT_EQ(text(), "4 < 02 05 10 00 E9 set control mode; ");
}

TEST_F(QuadQuad2DrvDecodeChunks, BytesOfNoPacketComeOutAtOnceAndBeforeWhatFollowsThem)
{
    take(1, Direction::Received, test::bytesOf("00 FF 02 05 10 00 E9 02 04 02 F8 55"));
    EXPECT_EQ(text(), "1 < 00 FF; 1 < 02 05 10 00 E9 set control mode; 1 < 02 04 02 F8 get motion data; 1 < 55; ");
}

TEST_F(QuadQuad2DrvDecodeChunks, WhatBeginsLikeAPacketAndIsNoneCostsOneByteAtATime)
{
    take(1, Direction::Sent, test::bytesOf("02 03 02 04 01 F9"));
    EXPECT_EQ(text(), "1 > 02 03; 1 > 02 04 01 F9 get version; ") << "no packet is shorter than 4 bytes";
    take(2, Direction::Sent, test::bytesOf("02 40 63 02 04 01 F9"));
    EXPECT_EQ(text(), "2 > 02 40 63; 2 > 02 04 01 F9 get version; ") << "a packet 99 is not waited for";
    take(3, Direction::Sent, test::bytesOf("02 04 01 F8 02 04 01 F9"));
    EXPECT_EQ(text(), "3 > 02 04 01 F8; 3 > 02 04 01 F9 get version; ") << "a checksum that is wrong";
    take(4, Direction::Sent, test::bytesOf("02 03"));
    EXPECT_EQ(text(), "4 > 02 03; ") << "its size says so at once";
    take(5, Direction::Sent, test::bytesOf("02 0A 63"));
    EXPECT_EQ(text(), "5 > 02 0A 63; ") << "its number does";
    take(6, Direction::Sent, test::bytesOf("55 02"));
    EXPECT_EQ(text(), "6 > 55; ");
    take(7, Direction::Sent, test::bytesOf("0A 01"));
    EXPECT_EQ(text(), "") << "a known packet is waited for";
}

TEST_F(QuadQuad2DrvDecodeChunks, AtTheEndWhatWasWaitedForComesOutOfBothDirections)
{
    take(1, Direction::Received, test::bytesOf("02 05 10"));
    take(2, Direction::Sent, test::bytesOf("02"));
    EXPECT_EQ(text(), "");
    EXPECT_EQ(text(true), "0 > 02; 0 < 02 05 10; ");
    EXPECT_EQ(text(true), "");
}

} // namespace
} // namespace mb::quadquad2drv
