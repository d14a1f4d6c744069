// SPDX-License-Identifier: GPL-3.0-or-later
#include "wire/canframe.h"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

namespace mb {
namespace {

CanFrame randomFrame(std::mt19937 &random)
{
    CanFrame frame;
    frame.extended = (random() & 1U) != 0U;
    frame.remote = random() % 8 == 0;
    frame.id = static_cast<std::uint32_t>(random()) & (frame.extended ? 0x1FFFFFFFU : 0x7FFU);
    frame.size = static_cast<std::uint8_t>(random() % 9);
    const bool plain = random() % 4 == 0; // long runs need many stuff bits
    for (std::size_t i = 0; i < frame.size; ++i)
        frame.data[i] = plain ? (random() % 2 != 0 ? 0xFF : 0x00) : static_cast<std::uint8_t>(random() & 0xFFU);
    return frame;
}

/// Length of a frame on the wire the long way round: all bits as text, the CRC by long division, stuffing by rewriting.
namespace reference {

std::string binary(std::uint32_t value, int width)
{
    std::string bits;
    for (int i = width - 1; i >= 0; --i)
        bits += ((value >> i) & 1U) != 0U ? '1' : '0';
    return bits;
}

std::string crc15(const std::string &bits)
{
    const std::string polynomial = "1100010110011001";
    std::string rest = bits + std::string(15, '0');
    for (std::size_t i = 0; i < bits.size(); ++i) {
        if (rest[i] == '0')
            continue;
        for (std::size_t k = 0; k < polynomial.size(); ++k)
            rest[i + k] = rest[i + k] == polynomial[k] ? '0' : '1';
    }
    return rest.substr(bits.size());
}

std::string stuffed(std::string bits)
{
    for (std::size_t i = 0; i + 5 <= bits.size(); ++i) {
        const std::string five = bits.substr(i, 5);
        if (five == "00000" || five == "11111")
            bits.insert(i + 5, 1, five[0] == '0' ? '1' : '0');
    }
    return bits;
}

std::string headAndData(const CanFrame &frame)
{
    const std::string rtr = frame.remote ? "1" : "0";
    std::string bits = "0";
    if (frame.extended)
        bits += binary(frame.id >> 18U, 11) + "11" + binary(frame.id & 0x3FFFFU, 18) + rtr + "00";
    else
        bits += binary(frame.id, 11) + rtr + "00";
    bits += binary(frame.size, 4);
    for (std::size_t i = 0; i < frame.size && !frame.remote; ++i)
        bits += binary(frame.data[i], 8);
    return bits;
}

int bitsOnWire(const CanFrame &frame)
{
    const std::string bits = headAndData(frame);
    const std::string tail = "1"
                             "11"
                             "1111111"
                             "111"; // delimiter, acknowledge, end of frame, intermission
    return static_cast<int>((stuffed(bits + crc15(bits)) + tail).size());
}

} // namespace reference

TEST(CanFrameText, IsThatOfCandump)
{
    const std::vector<std::uint8_t> bytes{0x00, 0x40, 0x11, 0xAB};
    EXPECT_EQ(toText(extendedFrame(0x02061405, bytes)), "02061405#004011AB");
    EXPECT_EQ(toText(standardFrame(0x044, bytes)), "044#004011AB");
    EXPECT_EQ(toText(extendedFrame(0x00000240, {})), "00000240#");
    CanFrame remote = standardFrame(0x7FF, {});
    remote.remote = true;
    EXPECT_EQ(toText(remote), "7FF#R");
    remote.size = 8;
    EXPECT_EQ(toText(remote), "7FF#R8");
    CanFrame error = standardFrame(0x4, std::vector<std::uint8_t>(8, 0));
    error.error = true;
    EXPECT_EQ(toText(error), "20000004#0000000000000000");
}

TEST(CanFrameText, TellsThreeDigitsFromEight)
{
    const auto standard = canFrameFromText("044#01");
    const auto extended = canFrameFromText("00000044#01");
    ASSERT_TRUE(standard && extended);
    EXPECT_FALSE(standard->extended);
    EXPECT_TRUE(extended->extended);
    EXPECT_EQ(standard->id, extended->id);
    EXPECT_FALSE(sameContent(*standard, *extended));
}

TEST(CanFrameText, ReadsLowerCase)
{
    const auto frame = canFrameFromText("0206fcc5#0a0bff");
    ASSERT_TRUE(frame);
    EXPECT_EQ(toText(*frame), "0206FCC5#0A0BFF");
    for (int size = 0; size <= 8; ++size)
        EXPECT_EQ(canFrameFromText("123#R" + std::to_string(size))->size, size);
    EXPECT_EQ(canFrameFromText("123#R")->size, 0);
    for (const char *wrong : {"123#R9", "123#R/", "123#R10", "123#R:"})
        EXPECT_FALSE(canFrameFromText(wrong)) << wrong;
    const auto remote = canFrameFromText("123#r2");
    ASSERT_TRUE(remote);
    EXPECT_TRUE(remote->remote);
    EXPECT_EQ(remote->size, 2);
}

TEST(CanFrameText, ReadsErrorFrames)
{
    const auto frame = canFrameFromText("20000004#0004000000000000");
    ASSERT_TRUE(frame);
    EXPECT_TRUE(frame->error);
    EXPECT_FALSE(frame->extended);
    EXPECT_EQ(frame->id, 0x4U);
    EXPECT_EQ(frame->data[1], 0x04);
}

TEST(CanFrameText, ComesBackAsItWas)
{
    std::mt19937 random(1);
    for (int i = 0; i < 5000; ++i) {
        CanFrame frame = randomFrame(random);
        if (i % 10 == 0) {
            frame.error = true;
            frame.extended = frame.remote = false;
        }
        const auto back = canFrameFromText(toText(frame));
        ASSERT_TRUE(back) << toText(frame);
        EXPECT_TRUE(sameContent(frame, *back)) << toText(frame);
    }
}

TEST(CanFrameText, RefusesWhatIsNoFrame)
{
    const std::vector<std::string> malformed{"", "#", "044", "44#00", "0044#00", "000000044#00", "044#0", "044#001",
        "044#0G", "04G#00", "-44#00", "+44#00", "0x4#00", " 44#00", "044 #00", "044#00 ", "044# 00", "044#-1", "044#+1",
        "044#0x", "044#000102030405060708", "800#00", "FFF#", "40000000#", "80000044#00", "A0000004#00", "FFFFFFFF#",
        "044##1AABB", "044##0", "00000044##1", "044#R9", "044#R-", "044#RR", "044#R10", "044#00#00",
        std::string("044#0\0", 6), std::string("044#\0\0", 6)};
    for (const std::string &text : malformed)
        EXPECT_FALSE(canFrameFromText(text)) << text;
}

TEST(CanFrame, KeepsAtMostEightBytes)
{
    const std::vector<std::uint8_t> many(12, 0x5A);
    EXPECT_EQ(standardFrame(1, many).size, 8);
    EXPECT_EQ(extendedFrame(1, many).bytes().size(), 8U);
}

TEST(CanFrame, ContentLeavesTimeAndUnusedBytesAside)
{
    CanFrame a = standardFrame(1, std::vector<std::uint8_t>{1, 2});
    CanFrame b = a;
    b.time += Duration(5);
    b.data[7] = 9;
    EXPECT_TRUE(sameContent(a, b));
    b.data[1] = 9;
    EXPECT_FALSE(sameContent(a, b));
    b = a;
    b.remote = true;
    EXPECT_FALSE(sameContent(a, b));
    b = a;
    b.error = true;
    EXPECT_FALSE(sameContent(a, b));
    b = a;
    b.extended = true;
    EXPECT_FALSE(sameContent(a, b));
    b = a;
    b.id = 2;
    EXPECT_FALSE(sameContent(a, b));
    b = a;
    b.size = 1;
    EXPECT_FALSE(sameContent(a, b));
    a.remote = b.remote = true;
    b.size = a.size;
    b.data[0] = 9;
    EXPECT_TRUE(sameContent(a, b)) << "a remote frame has no data";
}

TEST(CanReference, HasTheCheckValueOfCrc15)
{
    std::string bits;
    for (const char c : std::string("123456789"))
        bits += reference::binary(static_cast<std::uint32_t>(c), 8);
    EXPECT_EQ(reference::crc15(bits), reference::binary(0x059E, 15));
}

TEST(BitsOnWire, CountsEveryStuffBit)
{
    std::mt19937 random(2);
    for (int i = 0; i < 20000; ++i) {
        const CanFrame frame = randomFrame(random);
        ASSERT_EQ(bitsOnWire(frame), reference::bitsOnWire(frame)) << toText(frame);
    }
}

TEST(BitsOnWire, CountsAStuffBitBehindTheCrc)
{
    int found = 0;
    for (std::uint32_t id = 0; id < 0x800; ++id) {
        const CanFrame frame = standardFrame(id, {});
        const std::string bits = reference::headAndData(frame);
        const std::string stuffed = reference::stuffed(bits + reference::crc15(bits));
        const std::string end = stuffed.substr(stuffed.size() - 6);
        if (end != "000001" && end != "111110")
            continue;
        ++found;
        EXPECT_EQ(bitsOnWire(frame), static_cast<int>(stuffed.size()) + 13) << toText(frame);
    }
    EXPECT_GT(found, 0);
}

TEST(BitsOnWire, StaysWithinTheLimitsOfEachFormat)
{
    std::mt19937 random(3);
    for (int i = 0; i < 20000; ++i) {
        CanFrame frame = randomFrame(random);
        frame.remote = false;
        const int bare = (frame.extended ? 54 : 34) + 8 * frame.size + 13;
        const int stuffable = bare - 13;
        EXPECT_GE(bitsOnWire(frame), bare) << toText(frame);
        EXPECT_LE(bitsOnWire(frame), bare + (stuffable - 1) / 4) << toText(frame);
    }
}

TEST(BitsOnWire, OfAnExtendedFrameWithEightBytesIs131To160)
{
    int shortest = 1000;
    std::mt19937 random(4);
    for (int i = 0; i < 20000; ++i) {
        CanFrame frame = randomFrame(random);
        frame.extended = true;
        frame.remote = false;
        frame.size = 8;
        const int bits = bitsOnWire(frame);
        shortest = std::min(shortest, bits);
        ASSERT_GE(bits, 131);
        ASSERT_LE(bits, 160);
    }
    EXPECT_LE(shortest, 134);
}

TEST(BitsOnWire, OfAStandardFrameWithoutDataIs47PlusStuffBits)
{
    const CanFrame frame = standardFrame(0x555, {});
    const std::string bits = reference::headAndData(frame);
    ASSERT_EQ(bits + reference::crc15(bits),
        "0"
        "10101010101"
        "000"
        "0000"
            + reference::crc15(bits));
    EXPECT_EQ(bits.size() + 15 + 13, 47U);
    EXPECT_EQ(bitsOnWire(frame), reference::bitsOnWire(frame));
    EXPECT_GE(bitsOnWire(frame), 48); // seven dominant bits in a row need a stuff bit
}

TEST(BitsOnWire, OfARemoteFrameHasNoData)
{
    CanFrame frame = extendedFrame(0x02061405, {1, 2, 3, 4, 5, 6, 7, 8});
    frame.remote = true;
    EXPECT_LT(bitsOnWire(frame), 90);
    EXPECT_EQ(bitsOnWire(frame), reference::bitsOnWire(frame));
}

} // namespace
} // namespace mb
