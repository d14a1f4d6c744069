// SPDX-License-Identifier: GPL-3.0-or-later
// What waits for a CAN interface that takes nothing: in which order it goes, what takes whose place, and what is given up.
#include "async/virtualclock.h"
#include "transport/canqueue.h"

#include <gtest/gtest.h>

namespace mb {
namespace {

using namespace std::chrono_literals;

class CanQueues : public testing::Test {
protected:
    void send(std::uint32_t id, std::uint8_t content, Priority priority = Priority::Normal)
    {
        CanFrame frame = extendedFrame(id, {content});
        frame.time = clock.now();
        ASSERT_TRUE(queue.admit(frame, priority, "can0"));
        queue.push(frame, priority);
    }
    [[nodiscard]] std::string all()
    {
        std::string text;
        while (!queue.isEmpty()) {
            const CanQueue::Next next = queue.take();
            queue.wentOut(next);
            text += toText(next.frame) + ' ';
        }
        return text;
    }
    VirtualClock clock;
    CanQueue queue{clock};
};

TEST_F(CanQueues, UrgentFramesGoFirstAndTakeThePlaceOfWhatWaitsForTheirIdentifier)
{
    send(1, 0x11);
    send(2, 0x22);
    send(1, 0x12);
    EXPECT_FALSE(queue.isNext(Priority::Normal));
    EXPECT_TRUE(queue.isNext(Priority::Urgent));
    send(1, 0x00, Priority::Urgent);
    send(3, 0x00, Priority::Urgent);
    send(1, 0x00, Priority::Urgent);
    EXPECT_EQ(all(), "00000003#00 00000001#00 00000002#22 ");
}

TEST_F(CanQueues, WhatTheInterfaceRefusedIsTheFirstAgainUnlessAStopHasTakenItsPlace)
{
    send(1, 0x11);
    send(2, 0x22);
    const CanQueue::Next first = queue.take();
    EXPECT_TRUE(queue.putBack(first));
    EXPECT_EQ(toText(queue.take().frame), "00000001#11");
    send(1, 0x00, Priority::Urgent);
    EXPECT_FALSE(queue.putBack(first)) << "it would follow the stop";
    EXPECT_EQ(all(), "00000001#00 00000002#22 ");
}

TEST_F(CanQueues, AnOrderThatNobodyTakesForHalfASecondIsGivenUpAndAStopIsNot)
{
    send(1, 0x00, Priority::Urgent);
    send(2, 0x22);
    send(1, 0x00); // the same stop behind a set-point that the interface may hold
    clock.advance(499ms);
    send(3, 0x33);
    for (int tries = 0; tries < 3; ++tries)
        EXPECT_TRUE(queue.putBack(queue.take()));
    EXPECT_EQ(queue.dropStale(), 0U);
    clock.advance(1ms);
    EXPECT_EQ(queue.dropStale(), 1U) << "trying does not make it younger";
    EXPECT_EQ(all(), "00000001#00 00000001#00 00000003#33 ");
}

TEST_F(CanQueues, WhileFramesGoOutNoneIsGivenUp)
{
    send(1, 0x11);
    send(2, 0x22);
    clock.advance(400ms);
    queue.wentOut(queue.take());
    clock.advance(400ms);
    EXPECT_EQ(queue.dropStale(), 0U);
    clock.advance(100ms);
    EXPECT_EQ(queue.dropStale(), 1U);
}

TEST_F(CanQueues, TooManyOfOnePriorityAreRefusedAndTheOtherHasItsRoom)
{
    for (std::uint32_t i = 0; i < CanQueue::mostWaiting; ++i)
        send(i, 0x11);
    const auto refused = queue.admit(extendedFrame(1, {0}), Priority::Normal, "can0");
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().fault, Fault::LinkLost);
    EXPECT_NE(refused.error().text().find("can0 takes no frames"), std::string::npos);
    EXPECT_TRUE(queue.admit(extendedFrame(1, {0}), Priority::Urgent, "can0"));
}

} // namespace
} // namespace mb
