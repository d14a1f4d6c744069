// SPDX-License-Identifier: GPL-3.0-or-later
// Vectors of abstractdc/README.md#vectors: fed to the compiled firmware (SRC, SRC-L) or bytes of the published master's
// compiled structures (MASTER); none comes from our own encoder.
#include "families/abstractdc/codec.h"
#include "families/abstractdc/decode.h"
#include "families/abstractdc/parameters.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace mb::abstractdc {
namespace {

struct Request {
    const char *name;
    CanFrame frame;
    const char *text;
};

TEST(AbstractDcCodec, EncodesWhatTheFirmwareAndTheMasterUnderstand)
{
    const auto &f = dialectF;
    const auto &l = dialectL;
    const std::vector<Request> requests{
        {"S1", encodeSettings(f, 0, Loop::Velocity, Field::P, 1'000'000), "0C8#010040420F00"},
        {"S2", encodeSettings(f, 0, Loop::Velocity, Field::I, 1000), "0C8#0101E8030000"},
        {"S4", encodeSettings(f, 0, Loop::Velocity, Field::Divisor, 1'000'000), "0C8#010340420F00"},
        {"S5", encodeSettings(f, 0, Loop::Current, Field::P, 300'000), "0C8#0200E0930400"},
        {"S7", encodeSettings(f, 0, Loop::Current, Field::Divisor, -1'000'000), "0C8#0203C0BDF0FF"},
        {"S8", encodeSettings(f, 0, Loop::Position, Field::P, 800'000), "0C8#030000350C00"},
        {"S10", encodeSave(f, 0, Loop::Velocity), "0C8#01"},
        {"S11", encodeSave(f, 0, Loop::Position), "0C8#03"},
        {"S13", encodeSetPoint(f, 0, Loop::Position, 200), "064#03C8000000"},
        {"S14", encodeSetPoint(f, 0, Loop::Direct, 100), "064#0464000000"},
        {"S16", stopFrames(0)[0], "064#0000000000"},
        {"S17", stopFrames(0)[1], "064#0000000000000000"},
        {"S19", encodeLogRequest(f, 0, Log::Velocity), "384#01"},
        {"S20", encodeLogRequest(f, 5, Log::Temperature), "389#03"},
        {"S22", encodeSettings(l, 0, Loop::Velocity, Field::P, 1'000'000), "0C8#0100000040420F00"},
        {"S23", encodeSettings(l, 0, Loop::Current, Field::D, 7), "0C8#2200000007000000"},
        {"S25", encodeSetPoint(l, 0, Loop::Direct, 100), "064#0400000064000000"},
        {"S26", encodeSetPoint(dialectD, 0, Loop::Position, 10000), "064#0410270000"},
        {"stop of F is a set-point of its mode none", encodeSetPoint(f, 7, Loop::None, 0), "06B#0000000000"},
        {"LL asks at 800", encodeLogRequest(dialectLL, 9, Log::Position), "329#00"},
        {"a field of D in the wide form", encodeSettings(l, 3, Loop::Velocity, Field::Divisor, -2),
            "0CB#31000000FEFFFFFF"},
        {"averaging of F", encodeSettings(f, 99, Loop::Current, Field::Averaging, 500), "12B#0204F4010000"},
        {"a save of another drive", encodeSave(f, 99, Loop::Current), "12B#02"},
        {"a stop of another drive", stopFrames(99)[1], "0C7#0000000000000000"},
    };
    for (const Request &request : requests)
        EXPECT_EQ(toText(request.frame), request.text) << request.name;
}

struct Reply {
    const char *name;
    int offset;
    const char *text;
    Log log;
    std::int32_t value;
};

TEST(AbstractDcCodec, DecodesWhatTheFirmwareSends)
{
    const std::vector<Reply> replies{
        {"R1", 0, "400#F4010000", Log::Velocity, 500},
        {"R2", 5, "405#00000000", Log::Velocity, 0},
        {"R4", 0, "480#FFFFFFFF", Log::Position, -1},
        {"R5", 0, "500#F4010000", Log::Current, 500},
        {"R7", 5, "605#00000000", Log::Temperature, 0},
        {"R8", 5, "680#9CFFFFFF", Log::Voltage, -100},
    };
    for (const Reply &reply : replies) {
        const auto decoded = decodeLog(dialectF, reply.offset, *canFrameFromText(reply.text));
        ASSERT_TRUE(decoded) << reply.name;
        EXPECT_EQ(decoded->log, reply.log) << reply.name;
        EXPECT_EQ(decoded->value, reply.value) << reply.name;
        EXPECT_EQ(canFrameFromText(reply.text)->id, replyId(dialectF, reply.offset, reply.log)) << reply.name;
    }
}

TEST(AbstractDcCodec, CorruptedTwinsYieldNothing)
{
    for (const char *text : {"00000400#F4010000", "400#F40100", "400#F401000000", "400#R4", "401#F4010000", "401#"})
        EXPECT_FALSE(decodeLog(dialectF, 0, *canFrameFromText(text))) << text;
    EXPECT_FALSE(decodeLog(dialectF, 5, *canFrameFromText("685#9CFFFFFF")))
        << "the firmware adds no offset to the voltage";
    EXPECT_TRUE(decodeLog(dialectD, 5, *canFrameFromText("685#9CFFFFFF"))) << "the document does";
    EXPECT_FALSE(decodeLog(dialectL, 0, *canFrameFromText("600#00000000"))) << "the legacy has no temperature";
    EXPECT_FALSE(decodeSetPoint(dialectF, 3, *canFrameFromText("064#0464000000000000"))) << "another length";
    EXPECT_FALSE(decodeSetPoint(dialectF, 3, *canFrameFromText("064#0564000000"))) << "no such type";
    EXPECT_FALSE(decodeSettings(dialectF, 3, *canFrameFromText("0CB#010540420F00"))) << "no such field";
}

TEST(AbstractDcCodec, EveryIdentifierOfEveryOffsetHasOneMeaning)
{
    std::set<std::uint32_t> requests;
    for (int offset = 1; offset <= maxOffset; ++offset) {
        for (const CanFrame &frame : {encodeSetPoint(dialectF, offset, Loop::Direct, 1),
                 encodeSave(dialectF, offset, Loop::Velocity), encodeLogRequest(dialectF, offset, Log::Current)})
            EXPECT_TRUE(requests.insert(frame.id).second) << frame.id;
        for (const Log log : {Log::Position, Log::Velocity, Log::Current, Log::Temperature})
            EXPECT_TRUE(requests.insert(replyId(dialectF, offset, log)).second) << offset;
    }
}

TEST(AbstractDcCodec, AFrameOfAnotherHostIsReadWithItsOwnDialect)
{
    EXPECT_EQ(decodeSetPoint(dialectF, 3, *canFrameFromText("067#0464000000")), Loop::Direct);
    EXPECT_EQ(decodeSetPoint(dialectF, 3, *canFrameFromText("064#0000000000")), Loop::None) << "broadcast";
    EXPECT_EQ(decodeSetPoint(dialectD, 3, *canFrameFromText("067#0464000000")), Loop::Position);
    EXPECT_EQ(decodeSetPoint(dialectLL, 3, *canFrameFromText("067#0300000064000000")), Loop::Direct);
    const auto settings = decodeSettings(dialectL, 0, *canFrameFromText("0C8#2200000007000000"));
    ASSERT_TRUE(settings);
    EXPECT_EQ(settings->loop, Loop::Current);
    EXPECT_EQ(settings->field, Field::D);
    EXPECT_EQ(settings->value, 7);
}

TEST(AbstractDcCodec, ASaveIsThatOfALoopWithGains)
{
    for (const Dialect *dialect : {&dialectF, &dialectL}) {
        for (const Loop loop : {Loop::Velocity, Loop::Current, Loop::Position})
            EXPECT_EQ(decodeSave(*dialect, 3, encodeSave(*dialect, 3, loop)), loop);
        for (const char *none : {"0CB#00", "0CB#04", "0CB#05", "0CB#", "0CB#0100", "0CC#01", "067#01", "000000CB#01"})
            EXPECT_FALSE(decodeSave(*dialect, 3, *canFrameFromText(none))) << none;
    }
}

std::string text(const char *frame, std::string_view dialect = {})
{
    const auto decoded = decodeCan(*canFrameFromText(frame), dialect);
    if (!decoded)
        return "nothing";
    std::string line
        = std::string(decoded->message) + ' ' + std::to_string(decoded->address) + (decoded->control ? " !" : "");
    for (const DecodedField &field : decoded->fields)
        line
            += ' ' + std::string(field.name) + '=' + std::to_string(std::lround(field.value)) + std::string(field.unit);
    return line;
}

TEST(AbstractDcDecode, NamesEveryMessageInBothDirections)
{
    EXPECT_EQ(text("0C8#010040420F00"), "settings 0 TYPE=1 FIELD=0 value=1000000");
    EXPECT_EQ(text("0CD#01"), "save 5 TYPE=1");
    EXPECT_EQ(text("067#0410270000"), "setpoint 3 ! TYPE=4 value=10000PWM");
    EXPECT_EQ(text("067#0000000000"), "setpoint 3 TYPE=0 value=0");
    EXPECT_EQ(text("389#03"), "log request 5 LOG=3");
    EXPECT_EQ(text("405#F4010000"), "speed log 5 value=500counts/s");
    EXPECT_EQ(text("480#FFFFFFFF"), "position log 0 value=-1counts");
    EXPECT_EQ(text("680#9CFFFFFF"), "voltage log -1 value=-100PWM");
}

TEST(AbstractDcDecode, TheSameBitsMeanSomethingElseInAnotherDialect)
{
    EXPECT_EQ(text("067#0410270000", "D"), "setpoint 3 ! TYPE=4 value=10000counts");
    EXPECT_EQ(text("067#0400000064000000", "L"), "setpoint 3 ! TYPE=4 value=100PWM");
    EXPECT_EQ(text("067#0300000064000000", "LL"), "setpoint 3 ! TYPE=3 value=100PWM");
    EXPECT_EQ(text("454#01000000", "L"), "position log 8 value=1counts");
    EXPECT_EQ(text("329#00", "LL"), "log request 9 LOG=0");
    EXPECT_EQ(text("685#9CFFFFFF", "D"), "voltage log 5 value=-100PWM");
}

/// A scan asks in all dialects, and a stop goes out in both lengths.
TEST(AbstractDcDecode, WhatAsksOrStopsIsReadWhateverTheDialect)
{
    for (const char *dialect : {"", "F", "L", "D"}) {
        EXPECT_EQ(text("320#00", dialect), "log request 0 LOG=0");
        EXPECT_EQ(text("383#00", dialect), "log request 99 LOG=0");
        EXPECT_EQ(text("389#05", dialect), "log request 5 LOG=5");
        EXPECT_EQ(text("067#0000000000", dialect), "setpoint 3 TYPE=0 value=0");
        EXPECT_EQ(text("067#0000000000000000", dialect), "setpoint 3 TYPE=0 value=0");
    }
    EXPECT_EQ(text("067#0000000000000000", "LL"), "setpoint 3 ! TYPE=0 value=0counts/s") << "it has no stop";
}

TEST(AbstractDcDecode, AVoltageLogIsThatOfTheDriveThatWasAskedForIt)
{
    const CanDecoder follow = followCan({});
    const auto address = [&follow](const char *text, Duration time) {
        CanFrame frame = *canFrameFromText(text);
        frame.time = Instant(time);
        const auto decoded = follow(frame);
        EXPECT_TRUE(decoded);
        return decoded ? decoded->address : -2;
    };
    using namespace std::chrono_literals;
    EXPECT_EQ(address("680#01000000", 1s), -1) << "nobody was asked";
    EXPECT_EQ(address("387#04", 2s), 3);
    EXPECT_EQ(address("680#01000000", 2s + 1ms), 3);
    EXPECT_EQ(address("387#04", 3s), 3);
    EXPECT_EQ(address("680#01000000", 4s + 1ms), -1) << "too late";
    EXPECT_EQ(address("387#04", 5s), 3);
    EXPECT_EQ(address("388#04", 5s), 4);
    EXPECT_EQ(address("680#01000000", 5s + 1ms), -1) << "one of two";
}

TEST(AbstractDcCodec, AnErrorFrameOrARemoteFrameIsNoOrder)
{
    CanFrame setPoint = *canFrameFromText("067#0464000000");
    CanFrame settings = *canFrameFromText("0C8#010040420F00");
    CanFrame log = *canFrameFromText("400#F4010000");
    EXPECT_TRUE(decodeSetPoint(dialectF, 3, setPoint));
    EXPECT_TRUE(decodeSettings(dialectF, 3, settings)) << "for every drive";
    EXPECT_TRUE(decodeLog(dialectF, 0, log));
    EXPECT_FALSE(decodeSetPoint(dialectF, 4, setPoint)) << "for another drive";
    EXPECT_FALSE(decodeSetPoint(dialectF, 3, settings));
    EXPECT_FALSE(decodeSettings(dialectF, 3, setPoint));
    for (bool CanFrame::*const kind : {&CanFrame::extended, &CanFrame::remote, &CanFrame::error}) {
        for (CanFrame *frame : {&setPoint, &settings, &log})
            frame->*kind = true;
        EXPECT_FALSE(decodeSetPoint(dialectF, 3, setPoint));
        EXPECT_FALSE(decodeSettings(dialectF, 0, settings));
        EXPECT_FALSE(decodeLog(dialectF, 0, log));
        for (CanFrame *frame : {&setPoint, &settings, &log}) {
            EXPECT_FALSE(decodeCan(*frame, {}));
            frame->*kind = false;
        }
    }
}

TEST(AbstractDcDecode, AnErrorFrameSaysNothingNotEvenStop)
{
    for (const char *said : {"067#0000000000", "0CD#01", "389#03", "405#F4010000"}) {
        CanFrame frame = *canFrameFromText(said);
        EXPECT_TRUE(decodeCan(frame, {})) << said;
        frame.error = true;
        EXPECT_FALSE(decodeCan(frame, {})) << said;
    }
}

TEST(AbstractDcDecode, SettingsOfTheWideDialectsHaveTheirFieldInTheUpperHalfOfTheFirstByte)
{
    EXPECT_EQ(text("0CB#31000000FEFFFFFF", "L"), "settings 3 TYPE=1 FIELD=3 value=-2");
    EXPECT_EQ(text("0CB#51000000FEFFFFFF", "L"), "nothing") << "there is no field 5";
    EXPECT_EQ(text("0CB#30000000FEFFFFFF", "L"), "nothing") << "nothing has no gains";
    EXPECT_EQ(text("0CB#34000000FEFFFFFF", "L"), "nothing") << "a duty has none";
    EXPECT_EQ(text("0CB#03", "L"), "save 3 TYPE=3");
    EXPECT_EQ(text("0CB#13", "L"), "nothing") << "what saves has a type only";
    EXPECT_EQ(text("0CB#00"), "nothing");
    EXPECT_EQ(text("0CB#0104FEFFFFFF"), "settings 3 TYPE=1 FIELD=4 value=-2");
    EXPECT_EQ(text("0CB#0105FEFFFFFF"), "nothing");
    EXPECT_EQ(text("0CB#0400FEFFFFFF"), "nothing");
    EXPECT_EQ(text("0CB#5100FEFFFFFF"), "nothing") << "the short form has one byte of each";
}

TEST(AbstractDcDecode, EveryLogHasItsNameAndUnitAndTheBoundsOfItsIdentifiers)
{
    EXPECT_EQ(text("563#01000000"), "current log 99 value=1ADC");
    EXPECT_EQ(text("663#FEFFFFFF"), "temperature log 99 value=-2ADC");
    EXPECT_EQ(text("463#01000000"), "speed log 99 value=1counts/s");
    EXPECT_EQ(text("464#01000000"), "nothing") << "no drive is beyond 99";
    EXPECT_EQ(text("4E3#01000000"), "position log 99 value=1counts");
    EXPECT_EQ(text("0C7#0164000000"), "setpoint 99 ! TYPE=1 value=100counts/s");
    EXPECT_EQ(text("066#0264000000"), "setpoint 2 ! TYPE=2 value=100ADC");
    EXPECT_EQ(text("066#0364000000"), "setpoint 2 ! TYPE=3 value=100counts");
    EXPECT_EQ(text("066#0564000000"), "nothing");
    EXPECT_EQ(text("066#04640000"), "nothing");
}

TEST(AbstractDcDecode, WhatIsNotExactlyItsOwnIsNothing)
{
    for (const char *frame : {"044#2A366C2B", "067#0400000064000000", "0C8#0100", "0C8#04", "384#06", "384#",
             "480#FFFFFF", "00000480#FFFFFFFF", "480#R", "7FF#00000000", "681#00000000"})
        EXPECT_EQ(text(frame), "nothing") << frame;
    EXPECT_EQ(text("067#0410270000", "X"), "nothing");
}

ParameterIndex index(Loop loop, Field field)
{
    return *parameterOf(loop, field);
}

TEST(AbstractDcParameters, AreWrittenInTheOrderInWhichNothingGetsStrongerThanItMust)
{
    ParameterStore known(parameterTable());
    const auto order = [&](std::vector<ParameterChange> changes) {
        arrange(known, changes);
        std::string keys;
        for (const ParameterChange &change : changes)
            keys += std::string(parameterTable()[change.index.value].key).substr(9) + ' ';
        return keys;
    };
    const auto p = index(Loop::Velocity, Field::P);
    const auto i = index(Loop::Velocity, Field::I);
    const auto d = index(Loop::Velocity, Field::D);
    const auto divisor = index(Loop::Velocity, Field::Divisor);
    EXPECT_EQ(order({{i, 1}, {p, 1}, {d, 1}, {divisor, 9}}), "divisor d p i ") << "nothing is known: divisor first";
    for (const ParameterIndex one : {p, i, d})
        known.setWritten(one, 1000);
    known.setWritten(divisor, 1'000'000);
    EXPECT_EQ(order({{p, 2000}, {d, -5}, {divisor, 1000}}), "d p divisor ") << "a smaller divisor makes all stronger";
    EXPECT_EQ(order({{divisor, 2'000'000}, {d, 0}, {p, 500}}), "divisor p d ") << "damping goes after P has gone";
    EXPECT_EQ(order({{divisor, 1000}, {i, 5000}, {d, 0}, {p, 500}}), "p d i divisor ")
        << "the integral after both, and before what makes it stronger";
    EXPECT_EQ(order({{i, 5000}, {d, 2000}, {p, 2000}, {divisor, 2'000'000}}), "divisor d p i ");
}

TEST(AbstractDcParameters, AreWrittenLoopByLoop)
{
    ParameterStore known(parameterTable());
    std::vector<ParameterChange> changes;
    for (const Loop loop : {Loop::Position, Loop::Velocity, Loop::Current}) {
        for (const Field field : {Field::Averaging, Field::I, Field::Divisor, Field::P, Field::D}) {
            if (const auto at = parameterOf(loop, field))
                changes.push_back({*at, 1});
        }
    }
    arrange(known, changes);
    std::string keys;
    for (const ParameterChange &change : changes)
        keys += std::string(parameterTable()[change.index.value].key) + ' ';
    EXPECT_EQ(keys,
        "velocity.divisor velocity.d velocity.p velocity.i "
        "current.divisor current.d current.p current.i current.averaging "
        "position.divisor position.d position.p position.i ");
}

} // namespace
} // namespace mb::abstractdc
