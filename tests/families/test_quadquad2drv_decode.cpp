// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/quadquad2drv/codec.h"
#include "families/quadquad2drv/decode.h"
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

} // namespace
} // namespace mb::quadquad2drv
