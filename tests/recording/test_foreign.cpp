// SPDX-License-Identifier: GPL-3.0-or-later
// Recordings that other programs made: MCAP with chunks and messages in JSON, as the libraries of mcap.dev write them by default, and
// tables of Python and spreadsheets.
#include "recording/loadrecording.h"
#include "recording/mcapformat.h"
#include "telemetry/samplechunk.h"
#include "tests/recording/recordingfolder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <lz4frame.h>
#include <zstd.h>

namespace mb::foreign {
namespace {

using mcap::Content;
using mcap::Kind;

constexpr std::uint64_t start = 1'700'000'000'000'000'000;

std::string record(Kind kind, const Content &content)
{
    Content whole;
    whole.put(static_cast<std::uint8_t>(kind)).put(static_cast<std::uint64_t>(content.bytes().size()));
    return whole.bytes() + content.bytes();
}

std::string message(std::uint16_t channel, std::uint64_t time, const std::string &body)
{
    Content content;
    content.put(channel).put(std::uint32_t{0}).put(time).put(time);
    Content whole;
    whole.put(static_cast<std::uint8_t>(Kind::Message))
        .put(static_cast<std::uint64_t>(content.bytes().size() + body.size()));
    return whole.bytes() + content.bytes() + body;
}

/// A schema, a channel and a hundred messages of a robot's arm.
std::string records(const std::string &encoding = "json")
{
    std::string all = record(Kind::Schema, Content().put(std::uint16_t{1}).text("arm").text("jsonschema").text("{}"));
    Content channel;
    channel.put(std::uint16_t{7}).put(std::uint16_t{1}).text("/arm").text(encoding).map({});
    all += record(Kind::Channel, channel);
    for (int i = 0; i < 100; ++i)
        all += message(7, start + static_cast<std::uint64_t>(i) * 10'000'000,
            R"({"joint":{"position":)" + std::to_string(i * 2) + R"(,"name":"elbow"},"amperes":[0.5,)"
                + std::to_string(i) + R"(],"on":true,"fault":null})");
    return all;
}

using Pack = std::function<std::string(const std::string &)>;

std::string fileOf(const std::string &how, const Pack &pack, const std::string &inside)
{
    const std::string packed = pack(inside);
    Content chunk;
    chunk.put(start).put(start + 1'000'000'000).put(static_cast<std::uint64_t>(inside.size())).put(std::uint32_t{0});
    chunk.text(how).put(static_cast<std::uint64_t>(packed.size()));
    Content head;
    head.put(static_cast<std::uint8_t>(Kind::Chunk))
        .put(static_cast<std::uint64_t>(chunk.bytes().size() + packed.size()));
    const std::string magic(mcap::magic.begin(), mcap::magic.end());
    return magic + record(Kind::Header, Content().text("").text("another program")) + head.bytes() + chunk.bytes()
        + packed + record(Kind::DataEnd, Content().put(std::uint32_t{0})) + magic;
}

std::string plain(const std::string &bytes)
{
    return bytes;
}

std::string zstd(const std::string &bytes)
{
    std::string out(ZSTD_compressBound(bytes.size()), '\0');
    out.resize(ZSTD_compress(out.data(), out.size(), bytes.data(), bytes.size(), 3));
    return out;
}

std::string lz4(const std::string &bytes)
{
    std::string out(LZ4F_compressFrameBound(bytes.size(), nullptr), '\0');
    out.resize(LZ4F_compressFrame(out.data(), out.size(), bytes.data(), bytes.size(), nullptr));
    return out;
}

std::string write(const test::Folder &folder, const std::string &name, const std::string &bytes)
{
    const std::string path = folder.file(name.c_str());
    std::ofstream(path, std::ios::binary) << bytes;
    return path;
}

ChannelIndex channelOf(const LoadedRecording &recording, std::string_view name)
{
    for (std::uint16_t i = 0; i < recording.table.size(); ++i) {
        if (recording.table[i].key == name)
            return {i};
    }
    ADD_FAILURE() << name << " is missing";
    return {};
}

TEST(ForeignMcap, EveryNumberOfAMessageInJsonIsASignal)
{
    const test::Folder folder;
    for (const auto &[how, pack] : {std::pair<std::string, Pack>("", plain), {"zstd", zstd}, {"lz4", lz4}}) {
        const auto read = loadRecording(write(folder, "arm.mcap", fileOf(how, pack, records())));
        ASSERT_TRUE(read) << how << ": " << read.error().text();
        const LoadedRecording &arm = **read;
        EXPECT_TRUE(arm.complete);
        ASSERT_EQ(arm.table.size(), 4U) << how;
        const ChannelIndex position = channelOf(arm, "/arm/joint/position");
        EXPECT_EQ(arm.telemetry->size(position), 100U);
        EXPECT_DOUBLE_EQ(arm.telemetry->last(position)->value, 198.0);
        EXPECT_DOUBLE_EQ(arm.telemetry->last(channelOf(arm, "/arm/amperes/1"))->value, 99.0);
        EXPECT_DOUBLE_EQ(arm.telemetry->last(channelOf(arm, "/arm/on"))->value, 1.0);
        EXPECT_NEAR(totalsOf(arm).seconds, 0.99, 1e-6);
    }
}

TEST(ForeignMcap, WhatCannotBeReadIsRefusedInWords)
{
    const test::Folder folder;
    const auto causeOf = [&folder](const std::string &bytes) {
        const auto read = loadRecording(write(folder, "bad.mcap", bytes));
        return read ? std::string("read") : read.error().text();
    };
    EXPECT_NE(causeOf(fileOf("brotli", plain, records())).find("brotli"), std::string::npos);
    EXPECT_NE(causeOf(fileOf("zstd", plain, records())).find("damaged"), std::string::npos);
    EXPECT_NE(causeOf(fileOf("lz4", plain, records())).find("damaged"), std::string::npos);
    EXPECT_NE(causeOf(fileOf("", plain, records("cdr"))).find("JSON"), std::string::npos);
    const std::string whole = fileOf("zstd", zstd, records());
    for (std::size_t end = 9; end < whole.size(); end += 7)
        (void)causeOf(whole.substr(0, end)); // whatever it says, it ends
}

TEST(ForeignTable, OfPythonAndOfASpreadsheetAreRead)
{
    const test::Folder folder;
    const auto read = loadRecording(write(
        folder, "pandas.csv", "time_s,speed (rpm),\"current, A\"\n0.0,0,0.1\n0.1,10.5,0.2\n0.2,,0.3\n0.3,30,nan\n"));
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ((*read)->table.size(), 2U);
    EXPECT_DOUBLE_EQ((*read)->telemetry->last(channelOf(**read, "speed"))->value, 30.0);
}

TEST(ForeignTable, AMarkOfUtf8BeforeOurOwnLinesIsNoPartOfThem)
{
    const test::Folder folder;
    for (const std::string_view text :
        {"t,channel,value,unit\r\n0.1,speed,5,rpm\r\n", "time_s,speed (rpm)\r\n0.1,5\r\n"}) {
        const auto read = loadRecording(write(folder, "marked.csv", "\xEF\xBB\xBF" + std::string(text)));
        ASSERT_TRUE(read) << read.error().text();
        EXPECT_DOUBLE_EQ((*read)->telemetry->last(channelOf(**read, "speed"))->value, 5.0);
    }
}

TEST(ForeignTable, ANoteWhoseTimeCannotBeReadShiftsNothing)
{
    const test::Folder folder;
    const auto read = loadRecording(
        write(folder, "noted.csv", "# time_s 0 is noon (Unix twelve)\ntime_s,speed (rpm)\n0.0,1\n0.5,2\n"));
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_FALSE((*read)->hasClock);
    EXPECT_EQ((*read)->telemetry->last({0})->time, Instant(std::chrono::milliseconds(500)));
}

TEST(ForeignTable, SemicolonsWithDecimalCommasAndMillisecondsAreRead)
{
    const test::Folder folder;
    const auto read = loadRecording(
        write(folder, "excel.csv", "Zeit (ms);Drehzahl (1/min);Strom (A)\r\n0;0;0,5\r\n2,5;1200,25;1,5\r\n"));
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_DOUBLE_EQ((*read)->telemetry->last(channelOf(**read, "Drehzahl"))->value, 1200.25);
    EXPECT_DOUBLE_EQ((*read)->telemetry->last(channelOf(**read, "Strom"))->value, 1.5);
    EXPECT_NEAR(totalsOf(**read).seconds, 0.0025, 1e-9);
    const auto tabs = loadRecording(write(folder, "tabs.csv", "t\ta\n0\t1\n1\t2\n"));
    ASSERT_TRUE(tabs) << tabs.error().text();
    EXPECT_EQ((*tabs)->telemetry->size({0}), 2U);
}

TEST(ForeignTable, TimesAreInTheUnitThatTheirHeadTells)
{
    const test::Folder folder;
    for (const auto &[head, unit] : {std::pair("time_us", 1e-6), {"t (µs)", 1e-6}, {"t [μs]", 1e-6}, {"t_ns", 1e-9},
             {"Time [ms]", 1e-3}, {"ms", 1e-3}, {"time_s", 1.0}, {"rpms", 1.0}}) {
        const auto read = loadRecording(write(folder, "units.csv", head + std::string(",a\n0,1\n5000000,2\n")));
        ASSERT_TRUE(read) << read.error().text();
        EXPECT_NEAR(totalsOf(**read).seconds, 5e6 * unit, 1e-9) << head;
    }
}

TEST(ForeignTable, OfTimesThatAreFarApartNoMoreIsReadThanTheMemoryMayHave)
{
    const test::Folder folder;
    constexpr std::size_t most = 20U << 20U;
    for (const auto &[head, columns] : {std::pair("time_s,a", ",1\n"), {"t,channel,value,unit", ",a,1,V\n"}}) {
        std::string table = head + std::string("\n");
        for (int i = 0; i < 20'000; ++i)
            table += std::to_string(i * 5000) + columns;
        const auto read = loadRecording(write(folder, "apart.csv", table), mostLoadedSamples, most);
        ASSERT_TRUE(read) << read.error().text();
        EXPECT_TRUE((*read)->shortened) << head;
        EXPECT_LT((*read)->telemetry->memoryUse(), most + 2 * 4096 * sizeof(SampleChunk)) << "and what came meanwhile";
        EXPECT_FALSE((*loadRecording(write(folder, "near.csv", head + std::string("\n1") + columns)))->shortened);
    }
}

} // namespace
} // namespace mb::foreign
