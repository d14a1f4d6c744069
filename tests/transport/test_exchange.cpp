// SPDX-License-Identifier: GPL-3.0-or-later
#include "async/scope.h"
#include "async/sleep.h"
#include "async/virtualclock.h"
#include "transport/backends/virtualcan.h"
#include "transport/exchange.h"

#include <gtest/gtest.h>

#include <memory>
#include <optional>

using namespace mb;
using namespace std::chrono_literals;

namespace {

constexpr std::uint32_t requestId = 0x100;
constexpr std::uint32_t replyId = 0x101;

struct Exchange : public ::testing::Test {
    Exchange()
    {
        EXPECT_TRUE(host.open());
        EXPECT_TRUE(device.open());
        requests = device.received().add([this](const CanFrame &frame) {
            if (frame.id != requestId)
                return;
            asked.push_back(clock.now());
            if (static_cast<int>(asked.size()) > deafFor) {
                EXPECT_TRUE(device.send(standardFrame(replyId, frame.bytes())));
            }
        });
    }
    [[nodiscard]] Task<CanFrame> ask(Attempts attempts = {})
    {
        CanInbox::Match match = [](const CanFrame &frame) { return frame.id == replyId; };
        return exchange(
            host, clock, standardFrame(requestId, std::vector<std::uint8_t>{7}), std::move(match), attempts);
    }
    void start(Task<CanFrame> task)
    {
        scope.spawn<CanFrame>(std::move(task), [this](Result<CanFrame> got) {
            result = std::move(got);
            endedAt = clock.now();
        });
    }
    [[nodiscard]] bool leftNothing()
    {
        return host.received().size() == 0 && host.stateChanged().size() == ownListeners && clock.armed() == 0;
    }

    VirtualClock clock;
    VirtualCanBus bus{clock, 1'000'000, 1};
    VirtualCanLink host{LinkAddress{"sim", "can", {}}, bus};
    VirtualCanLink device{LinkAddress{"sim", "can", {}}, bus};
    std::size_t ownListeners = host.stateChanged().size(); ///< of the link itself
    Subscription requests;
    std::vector<Instant> asked;
    int deafFor = 0;
    std::optional<Result<CanFrame>> result;
    Instant endedAt{};
    Scope scope{clock};
};

} // namespace

TEST_F(Exchange, YieldsTheAnswer)
{
    start(ask());
    clock.advance(1s);
    ASSERT_TRUE(result);
    ASSERT_TRUE(*result);
    EXPECT_EQ(toText(**result), "101#07");
    EXPECT_EQ(asked.size(), 1U);
    EXPECT_LT(endedAt.time_since_epoch(), 1ms);
    EXPECT_TRUE(leftNothing());
}

TEST_F(Exchange, AsksAgainAfterATimeout)
{
    deafFor = 2;
    start(ask({3, 20ms}));
    clock.advance(1s);
    ASSERT_TRUE(result && *result);
    ASSERT_EQ(asked.size(), 3U);
    EXPECT_EQ(asked[1] - asked[0], 20ms);
    EXPECT_EQ(asked[2] - asked[1], 20ms);
    EXPECT_TRUE(leftNothing());
}

TEST_F(Exchange, TimesOutAfterTheLastTry)
{
    deafFor = 100;
    start(ask({3, 20ms}));
    clock.advance(1s);
    ASSERT_TRUE(result);
    ASSERT_FALSE(*result);
    EXPECT_EQ(result->error().fault, Fault::Timeout);
    EXPECT_EQ(asked.size(), 3U);
    EXPECT_EQ(endedAt, Instant(60ms));
    EXPECT_TRUE(leftNothing());
}

TEST_F(Exchange, IgnoresFramesThatDoNotMatch)
{
    deafFor = 100;
    start(ask({1, 20ms}));
    clock.advance(1ms);
    ASSERT_TRUE(device.send(standardFrame(0x102, {})));
    clock.advance(1ms);
    EXPECT_FALSE(result);
    ASSERT_TRUE(device.send(standardFrame(replyId, {})));
    clock.advance(1ms);
    ASSERT_TRUE(result);
    EXPECT_TRUE(*result);
}

TEST_F(Exchange, ALostLinkEndsItAtOnceWithTheCause)
{
    deafFor = 100;
    start(ask({3, 250ms}));
    clock.advance(10ms);
    bus.forceBusOff(host);
    clock.advance(0ms);
    ASSERT_TRUE(result);
    ASSERT_FALSE(*result);
    EXPECT_EQ(result->error(), host.loss());
    EXPECT_EQ(endedAt, Instant(10ms));
    EXPECT_TRUE(leftNothing());
}

TEST_F(Exchange, AClosedLinkEndsItAtOnce)
{
    deafFor = 100;
    start(ask());
    clock.advance(10ms);
    host.close();
    clock.advance(0ms);
    ASSERT_TRUE(result && !*result);
    EXPECT_EQ(result->error(), (Error{Fault::LinkLost, say("sim:can is not open")}));
    EXPECT_TRUE(leftNothing());
}

TEST_F(Exchange, OnAClosedLinkFailsWithoutSending)
{
    host.close();
    start(ask());
    clock.advance(0ms);
    ASSERT_TRUE(result && !*result);
    EXPECT_EQ(result->error().fault, Fault::LinkLost);
    EXPECT_TRUE(asked.empty());
    EXPECT_TRUE(leftNothing());
}

TEST_F(Exchange, CancelledAtAnyMomentLeavesNoTimerAndNoListener)
{
    deafFor = 1;
    for (const auto after : {0us, 30us, 100us, 20'000us, 20'030us}) {
        asked.clear();
        auto task = ask({3, 20ms});
        task.start();
        clock.advance(after);
        EXPECT_FALSE(task.isFinished());
        task.cancel();
        EXPECT_EQ(host.received().size(), 0U) << after.count();
        EXPECT_EQ(host.stateChanged().size(), ownListeners) << after.count();
        clock.advance(1ms); // what is on the wire passes
        EXPECT_EQ(clock.armed(), 0U) << after.count();
    }
}

namespace {

Task<int> collects(CanLink &link, Clock &clock, int &got)
{
    CanInbox::Match all = [](const CanFrame &) { return true; };
    CanInbox inbox(link, clock, std::move(all));
    co_await Sleep(clock, 10ms);
    for (;;) {
        const Result<CanFrame> frame = co_await inbox.next(5ms);
        if (!frame)
            co_return fail(frame.error());
        ++got;
    }
}

} // namespace

TEST_F(Exchange, AnInboxKeepsWhatComesWhileNobodyWaits)
{
    int got = 0;
    std::optional<Fault> fault;
    scope.spawn<int>(collects(host, clock, got), [&fault](Result<int> ended) { fault = ended.error().fault; });
    for (std::uint32_t i = 0; i < 5; ++i)
        ASSERT_TRUE(device.send(standardFrame(0x200 + i, {})));
    clock.advance(14ms);
    EXPECT_EQ(got, 5);
    EXPECT_FALSE(fault);
    clock.advance(2ms);
    EXPECT_EQ(fault, Fault::Timeout);
    EXPECT_TRUE(leftNothing());
}
