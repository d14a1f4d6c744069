// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/trafficlog.h"

#include <gtest/gtest.h>

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

TEST(TrafficLog, IsEmptyAtFirst)
{
    const TrafficLog log;
    std::vector<TrafficRecord> out;
    EXPECT_EQ(log.fetch(0, 10, out), 0U);
    EXPECT_TRUE(out.empty());
}

} // namespace
} // namespace mb
