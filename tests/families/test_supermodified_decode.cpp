// SPDX-License-Identifier: GPL-3.0-or-later
// What the monitor names of frames and of the bytes between them (supermodified/README.md#vectors).
#include "families/supermodified/codec.h"
#include "families/supermodified/decode.h"
#include "families/supermodifiedvectors.h"

#include <gtest/gtest.h>

#include <sstream>

namespace mb::supermodified {
namespace {

using test::bytesOf;
using test::examples;
using test::framesIn;

TEST(SupermodifiedDecode, NamesEveryExampleOfTheDatasheetInBothDirections)
{
    for (const test::Example &example : examples) {
        const Frame sent = framesIn(test::correctedBytes(example)).at(0);
        const auto request = decodeFrame(sent);
        ASSERT_TRUE(request) << example.name;
        EXPECT_EQ(request->address, sent.to) << example.name;
        if (sent.size > 0) {
            EXPECT_EQ(request->fields.back().value, static_cast<double>(*example.value)) << example.name;
        }
        if (example.node.empty())
            continue;
        const Frame reply = framesIn(bytesOf(example.node)).at(0);
        const auto answer = decodeFrame(reply);
        ASSERT_TRUE(answer) << example.name;
        EXPECT_EQ(answer->address, reply.from) << example.name;
        EXPECT_EQ(answer->message, request->message) << example.name;
        EXPECT_FALSE(answer->control) << example.name;
    }
}

TEST(SupermodifiedDecode, EveryByteOfAStreamComesOutOnceAndEachDirectionForItself)
{
    const auto decoder = decodeBytes({});
    std::vector<DecodedBytes> out;
    const auto request = bytesOf("FF 55 AA 04 01 6F 00 6F");
    const auto reply = bytesOf("55 AA 01 04 6F 04 33 16 00 00 4E 55 AA 01");
    decoder->take({}, Direction::Sent, std::span(request).first(5), out);
    decoder->take({}, Direction::Received, std::span(reply).first(3), out);
    decoder->take({}, Direction::Sent, std::span(request).subspan(5), out);
    decoder->take({}, Direction::Received, std::span(reply).subspan(3), out);
    decoder->finish(out);
    ASSERT_EQ(out.size(), 4U);
    EXPECT_EQ(out[0].bytes, bytesOf("FF"));
    EXPECT_FALSE(out[0].frame);
    EXPECT_EQ(out[1].frame->message, "get position");
    EXPECT_EQ(out[2].frame->fields.back().value, 5683.0);
    EXPECT_EQ(out[3].bytes, bytesOf("55 AA 01"));
    EXPECT_FALSE(out[3].frame);
}

TEST(SupermodifiedDecode, MarksWhatMovesAMotorAndNamesErrors)
{
    EXPECT_TRUE(decodeFrame(framesIn(bytesOf("55 AA 04 01 19 00 19")).at(0))->control);
    EXPECT_TRUE(decodeFrame(framesIn(bytesOf("55 AA 00 01 C8 00 C8")).at(0))->control);
    EXPECT_FALSE(decodeFrame(framesIn(bytesOf("55 AA 04 01 1B 00 1B")).at(0))->control);
    const auto error = decodeFrame(framesIn(bytesOf("55 AA 01 04 FA 01 14 EF")).at(0));
    EXPECT_EQ(error->message, "error");
    EXPECT_EQ(error->fields.back().name, "c1");
    EXPECT_EQ(error->fields.back().value, 20.0);
    for (int command = 0; command < 256; ++command) {
        const auto frame = request(4, 1, static_cast<Command>(command));
        EXPECT_EQ(decodeFrame(frame).has_value(), messageOf(frame.command) && command != 0xFA) << command;
    }
}

std::string decodedText(std::string_view bytes)
{
    const auto frames = framesIn(bytesOf(bytes));
    const auto decoded = frames.size() == 1 ? decodeFrame(frames[0]) : std::nullopt;
    if (!decoded)
        return "nothing";
    std::ostringstream text;
    text << decoded->message << ' ' << decoded->address << (decoded->control ? " !" : "");
    for (const DecodedField &field : decoded->fields)
        text << ' ' << field.name << '=' << field.value << (field.unit.empty() ? "" : " ") << field.unit;
    return text.str();
}

/// Whose frame it is: the address of a request is the node that it goes to, of an answer the node that it comes from.
TEST(SupermodifiedDecode, TellsAnswersFromRequestsByWhatTheyCarry)
{
    EXPECT_EQ(decodedText("55 AA 04 01 6F 00 6F"), "get position 4 AndID=4 OndID=1");
    EXPECT_EQ(decodedText("55 AA 01 04 6F 04 33 16 00 00 4E"), "get position 4 AndID=1 OndID=4 position=5683 ticks");
    EXPECT_EQ(decodedText("55 AA 04 01 00 02 D0 07 D5"), "PID P 4 AndID=4 OndID=1 P=2000");
    EXPECT_EQ(decodedText("55 AA 01 04 00 00 00"), "PID P 4 AndID=1 OndID=4") << "a set is answered without data";
    EXPECT_EQ(decodedText("55 AA 04 01 19 00 19"), "start 4 ! AndID=4 OndID=1");
    EXPECT_EQ(decodedText("55 AA 01 04 19 00 19"), "start 4 AndID=1 OndID=4");
    EXPECT_EQ(decodedText("55 AA 77 04 19 00 19"), "start 4 AndID=119 OndID=4") << "our own id";
    EXPECT_EQ(decodedText("55 AA 04 77 19 00 19"), "start 4 ! AndID=4 OndID=119");
    EXPECT_EQ(decodedText("55 AA 05 04 19 00 19"), "start 5 ! AndID=5 OndID=4") << "no host is in it";
    EXPECT_EQ(decodedText("55 AA 01 77 19 00 19"), "start 1 ! AndID=1 OndID=119") << "both are usual ids of a host";
    EXPECT_EQ(decodedText("55 AA 04 01 73 00 73"), "get warnings 4 AndID=4 OndID=1");
    EXPECT_EQ(decodedText("55 AA 01 04 73 00 73"), "get warnings 4 AndID=1 OndID=4") << "it has none";
    EXPECT_EQ(decodedText("55 AA 01 04 73 01 15 67"), "get warnings 4 AndID=1 OndID=4 c1=21");
}

TEST(SupermodifiedDecode, GivesEachValueOfAMessageThatHasSeveral)
{
    EXPECT_EQ(decodedText("55 AA 01 04 6E 08 01 00 00 02 FF 03 34 01 AC"),
        "get analog inputs 4 AndID=1 OndID=4 AIN1=1 1/1024 of 5 V AIN2=512 1/1024 of 5 V AIN3=1023 1/1024 of 5 V "
        "AIN4=308 1/1024 of 5 V");
    EXPECT_EQ(decodedText("55 AA 01 04 FA 08 01 02 03 11 12 13 14 15 E3"),
        "error 4 AndID=1 OndID=4 c1=1 c2=2 c3=3 c4=17 c5=18 c6=19 c7=20 c8=21");
    EXPECT_EQ(decodedText("55 AA 01 04 73 08 15 15 15 15 15 15 15 15 7B"),
        "get warnings 4 AndID=1 OndID=4 c1=21 c2=21 c3=21 c4=21 c5=21 c6=21 c7=21 c8=21");
    EXPECT_EQ(decodedText("55 AA 04 01 1C 14 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 01 01 02 02 01 09"),
        "error reaction 4 AndID=4 OndID=1 r0=0 r1=0 r2=0 r3=0 r4=0 r5=0 r6=0 r7=0 r8=0 r9=0 r10=0 r11=0 r12=0 r13=0 "
        "r14=0 r15=1 r16=1 r17=2 r18=2 r19=1");
    EXPECT_EQ(decodedText("55 AA 04 01 1C 01 01 1C"), "error-reporting level 4 AndID=4 OndID=1 level=1");
}

TEST(SupermodifiedDecode, AnAnswerOfOneByteComesFromItsNodeWhateverTheHostsId)
{
    Frame frame = request(9, 4, Command::GetWarnings); // to a host whose id is none of the usual ones
    frame.from = 4;
    frame.to = 9;
    frame.size = 1;
    const auto one = decodeFrame(frame);
    ASSERT_TRUE(one);
    EXPECT_EQ(one->address, 4) << "as with eight of them";
}

TEST(SupermodifiedDecode, DataOfALengthThatNoDialectHasIsNoMessage)
{
    EXPECT_EQ(decodedText("55 AA 01 04 6F 01 33 5D"), "nothing");
    EXPECT_EQ(decodedText("55 AA 04 01 19 01 00 18"), "nothing") << "a start has no data";
    EXPECT_EQ(decodedText("55 AA 01 04 1E 01 00 1F"), "nothing");
    Frame nine = request(1, 4, Command::GetWarnings);
    nine.size = mostCodes + 1;
    EXPECT_FALSE(decodeFrame(nine));
}

TEST(SupermodifiedDecode, BytesOfNoFrameComeOutBeforeTheFrameThatFollowsThemWithTheTimeOfTheirChunk)
{
    using namespace std::chrono_literals;
    const auto decoder = decodeBytes({});
    std::vector<DecodedBytes> out;
    decoder->take(1ms, Direction::Received, bytesOf("00 FF 55 AA 01 04 00 00 00 12 55 AA 01 04 19"), out);
    ASSERT_EQ(out.size(), 3U);
    EXPECT_EQ(out[0].bytes, bytesOf("00 FF"));
    EXPECT_EQ(out[1].bytes, bytesOf("55 AA 01 04 00 00 00"));
    EXPECT_EQ(out[2].bytes, bytesOf("12"));
    EXPECT_EQ(out[2].time, 1ms);
    EXPECT_EQ(out[2].direction, Direction::Received);
    out.clear();
    decoder->take(2ms, Direction::Received, bytesOf("00"), out);
    EXPECT_TRUE(out.empty());
    decoder->finish(out);
    ASSERT_EQ(out.size(), 1U);
    EXPECT_EQ(out[0].bytes, bytesOf("55 AA 01 04 19 00"));
    EXPECT_EQ(out[0].time, 2ms);
    EXPECT_EQ(out[0].direction, Direction::Received);
}

} // namespace
} // namespace mb::supermodified
