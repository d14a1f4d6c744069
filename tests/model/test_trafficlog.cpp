// SPDX-License-Identifier: GPL-3.0-or-later
#include "traffic/trafficlog.h"

#include <gtest/gtest.h>

#include <thread>

namespace mb {
namespace {

CanFrame frame(std::uint32_t id)
{
    return extendedFrame(id, {});
}

TEST(TrafficLog, NumbersFramesFromOneInTheirOrder)
{
    TrafficLog log(8);
    log.append(Direction::Received, frame(10));
    log.append(Direction::Sent, frame(11));
    std::vector<TrafficRecord> out;
    EXPECT_EQ(log.fetch(0, 100, out), 2U);
    ASSERT_EQ(out.size(), 2U);
    EXPECT_EQ(out[0].number, 1U);
    EXPECT_EQ(out[0].frame.id, 10U);
    EXPECT_EQ(out[1].direction, Direction::Sent);
    EXPECT_EQ(log.fetch(2, 100, out), 2U);
    EXPECT_EQ(out.size(), 2U) << "nothing new";
}

TEST(TrafficLog, LosesTheOldestAndTheNumbersTellHowMany)
{
    TrafficLog log(4);
    for (std::uint32_t i = 1; i <= 10; ++i)
        log.append(Direction::Received, frame(i));
    std::vector<TrafficRecord> out;
    EXPECT_EQ(log.fetch(2, 100, out), 10U);
    ASSERT_EQ(out.size(), 4U);
    EXPECT_EQ(out.front().number, 7U);
    for (const TrafficRecord &record : out)
        EXPECT_EQ(record.frame.id, record.number);
}

TEST(TrafficLog, GivesTheNewestWithinTheLimit)
{
    TrafficLog log(100);
    for (std::uint32_t i = 1; i <= 50; ++i)
        log.append(Direction::Received, frame(i));
    std::vector<TrafficRecord> out;
    EXPECT_EQ(log.fetch(0, 5, out), 50U);
    ASSERT_EQ(out.size(), 5U);
    EXPECT_EQ(out.front().number, 46U);
    EXPECT_EQ(out.back().number, 50U);
    EXPECT_EQ(log.newest(), 50U);
}

TEST(TrafficLog, CountsEveryFrameByIdentifierThoughTheRingOverran)
{
    TrafficLog log(4);
    for (std::uint32_t i = 0; i < 1000; ++i)
        log.append(Direction::Received, frame(i % 10));
    std::vector<TrafficRow> rows;
    EXPECT_EQ(log.statistics(Instant{}, rows), 0U);
    ASSERT_EQ(rows.size(), 10U);
    for (const TrafficRow &row : rows)
        EXPECT_EQ(row.count, 100U);
}

TEST(TrafficLog, KeepsBytesBesideFramesAndSaysWhenTheyAreGone)
{
    TrafficLog log;
    const std::vector<std::uint8_t> request{0x55, 0x04, 0x00};
    const std::vector<std::uint8_t> flood(5000, 0xAA);
    const Instant start = Instant{} + std::chrono::seconds(7);
    log.append(Direction::Sent, start, request);
    log.append(Direction::Received, start, {});
    log.append(Direction::Received, start, flood);
    EXPECT_EQ(log.firstTime(), start);
    std::vector<TrafficRecord> out;
    EXPECT_EQ(log.fetch(0, 100, out), 2U) << "no bytes, no record";
    ASSERT_EQ(out.size(), 2U);
    EXPECT_FALSE(out[0].isFrame());
    EXPECT_EQ(out[0].bytes, request);
    EXPECT_EQ(out[1].length, 5000U);
    EXPECT_EQ(out[1].bytes, std::vector<std::uint8_t>(4096, 0xAA)) << "the first of a long piece";
    for (int i = 0; i < 64; ++i)
        log.append(Direction::Received, start, flood);
    out.clear();
    log.fetch(0, 100, out);
    ASSERT_EQ(out.size(), 66U);
    EXPECT_TRUE(out[0].bytes.empty()) << "overwritten, but still a record";
    EXPECT_EQ(out[0].length, 3U);
    EXPECT_EQ(out[65].bytes.size(), 4096U);
    std::vector<TrafficRow> rows;
    log.statistics(start, rows);
    EXPECT_TRUE(rows.empty()) << "bytes have no identifier";
}

TEST(TrafficLog, KeepsAPieceUntilItsFirstByteIsOverwritten)
{
    TrafficLog log;
    const Instant time{};
    log.append(Direction::Sent, time, std::vector<std::uint8_t>{0x55});
    const std::vector<std::uint8_t> most(4096, 0xAA);
    for (int i = 0; i < 63; ++i)
        log.append(Direction::Received, time, most);
    log.append(Direction::Received, time, std::vector<std::uint8_t>(4095, 0xAB)); // 262144 bytes in all
    const auto oldest = [&log] {
        std::vector<TrafficRecord> out;
        log.fetch(0, 100, out);
        return out.at(0).bytes;
    };
    EXPECT_EQ(oldest(), std::vector<std::uint8_t>{0x55});
    log.append(Direction::Received, time, std::vector<std::uint8_t>{0x66});
    EXPECT_TRUE(oldest().empty());
}

TEST(TrafficLog, TellsTheTrailOfOneIdentifier)
{
    TrafficLog log(2);
    for (int i = 0; i < 4; ++i) {
        CanFrame timed = frame(i % 2 == 0 ? 10 : 11);
        timed.time = Instant{} + std::chrono::seconds(7) + i * std::chrono::milliseconds(100);
        log.append(Direction::Received, timed);
    }
    std::vector<TrafficRow> rows;
    log.statistics(Instant{} + std::chrono::seconds(8), rows);
    ASSERT_EQ(rows.size(), 2U);
    std::vector<CanFrame> trail;
    log.trail(rows[1].key, Instant{}, trail);
    ASSERT_EQ(trail.size(), 2U);
    EXPECT_EQ(trail[0].id, 11U);
    EXPECT_EQ(trail[1].time, Instant{} + std::chrono::milliseconds(7300));
}

TEST(TrafficLog, ItsFirstTimeIsThatOfTheFirstRecordThoughTheRingOverran)
{
    TrafficLog log(2);
    for (int i = 7; i < 12; ++i) {
        CanFrame timed = frame(10);
        timed.time = Instant{} + std::chrono::seconds(i);
        log.append(Direction::Received, timed);
    }
    EXPECT_EQ(log.firstTime(), Instant{} + std::chrono::seconds(7));
}

TEST(TrafficLog, IsReadWhileItIsWritten)
{
    TrafficLog log(256);
    std::thread writer([&log] {
        for (std::uint32_t i = 0; i < 20000; ++i)
            log.append(Direction::Received, frame(i % 7));
    });
    std::uint64_t seen = 0;
    std::uint64_t missed = 0;
    while (seen < 20000) {
        std::vector<TrafficRecord> out;
        const std::uint64_t newest = log.fetch(seen, 100, out);
        if (!out.empty())
            missed += out.front().number - seen - 1;
        for (std::size_t i = 1; i < out.size(); ++i)
            ASSERT_EQ(out[i].number, out[i - 1].number + 1);
        seen = newest;
        std::vector<TrafficRow> rows;
        log.statistics(Instant{}, rows);
        std::uint64_t counted = 0;
        for (const TrafficRow &row : rows)
            counted += row.count;
        ASSERT_GE(counted, newest);
    }
    writer.join();
    EXPECT_LT(missed, 20000U);
}

TEST(TrafficLog, IsEmptyAtFirst)
{
    const TrafficLog log;
    std::vector<TrafficRecord> out;
    EXPECT_EQ(log.fetch(0, 10, out), 0U);
    EXPECT_TRUE(out.empty());
}

} // namespace
} // namespace mb
