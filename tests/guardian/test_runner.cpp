// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/guardian/port.h"
#include "fakeport.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <map>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

namespace mb::guardian {
namespace {

using namespace std::chrono_literals;
using test::bytes;

Step plain(const std::string &text, std::chrono::milliseconds wait, int attempts)
{
    return {bytes(text), {}, {}, wait, attempts};
}

Step asking(const std::string &text, const std::string &reply, std::chrono::milliseconds wait, int attempts)
{
    return {bytes(text), bytes(reply), Bytes(reply.size(), 0xFF), wait, attempts};
}

class Running : public testing::Test {
protected:
    /// Runs what is due, in steps of a tenth of a millisecond, at most so long.
    void run(Time time)
    {
        for (const Time end = port.now + time; port.now < end && !runner.isIdle(); port.now += 100us)
            proceed();
    }
    void proceed()
    {
        for (const auto &outcome : runner.proceed(port.now))
            outcomes.push_back({outcome.id, outcome.confirmed});
    }

    test::FakePort port;
    Runner runner{port};
    std::vector<std::pair<std::uint32_t, bool>> outcomes;
};

TEST_F(Running, AMessageWithoutAnswerIsSentSoOften)
{
    runner.add(1, {plain("a", 5ms, 2), plain("b", 5ms, 1)}, port.now);
    proceed();
    EXPECT_EQ(port.texts(), "a") << "the first at once";
    run(1s);
    EXPECT_EQ(port.texts(), "aab");
    EXPECT_EQ(port.sent[1].at, Time(5ms));
    EXPECT_EQ(port.sent[2].at, Time(10ms));
    EXPECT_EQ(outcomes, (std::vector<std::pair<std::uint32_t, bool>>{{1, true}}));
    EXPECT_TRUE(runner.isIdle());
    EXPECT_FALSE(runner.due());
}

TEST_F(Running, OnlyAnAnswerProvesAStop)
{
    port.answer = [](const std::string &) { return "OK"; };
    runner.add(1, {plain("a", 5ms, 2)}, port.now);
    runner.add(2, {plain("a", 5ms, 2), asking("s", "OK", 20ms, 10)}, port.now);
    std::map<std::uint32_t, bool> proved;
    for (; !runner.isIdle(); port.now += 100us) {
        for (const auto &outcome : runner.proceed(port.now)) {
            EXPECT_TRUE(outcome.confirmed && outcome.sent);
            proved[outcome.id] = outcome.proved;
        }
    }
    EXPECT_EQ(proved, (std::map<std::uint32_t, bool>{{1, false}, {2, true}}));
}

TEST(RunningOnFrames, AnAnswerIsAWholeMessage)
{
    struct FramePort final : Port {
        Sent send(std::span<const std::uint8_t>) override { return Sent::All; }
        Bytes read() override { return std::exchange(incoming, {}); }
        std::size_t messageSize() const override { return 4; }
        Bytes incoming;
    };
    FramePort port;
    Runner runner(port);
    runner.add(1, {asking("s", "abcd", 20ms, 1)}, 0ms);
    EXPECT_TRUE(runner.proceed(0ms).empty());
    port.incoming = bytes("xxabcdxx");
    EXPECT_TRUE(runner.proceed(1ms).empty()) << "parts of two others";
    port.incoming = bytes("abcd");
    const auto ended = runner.proceed(2ms);
    ASSERT_EQ(ended.size(), 1U);
    EXPECT_TRUE(ended[0].proved);
}

TEST_F(Running, ItRepeatsUntilTheAnswerComes)
{
    int heard = 0;
    port.answer = [&heard](const std::string &) { return ++heard < 4 ? "!" : "noise OK"; };
    runner.add(1, {asking("s", "OK", 20ms, 10)}, port.now);
    run(1s);
    EXPECT_EQ(port.texts(), "ssss");
    EXPECT_EQ(port.sent[3].at, Time(60ms));
    EXPECT_EQ(outcomes.back(), std::pair(1U, true));
}

TEST_F(Running, AnAnswerInPiecesCounts)
{
    runner.add(1, {asking("s", "OK", 20ms, 1)}, port.now);
    proceed();
    port.incoming = "O";
    proceed();
    EXPECT_TRUE(outcomes.empty());
    port.incoming = "K";
    proceed();
    EXPECT_EQ(outcomes.back(), std::pair(1U, true));
}

TEST_F(Running, WhatCameBeforeTheQuestionIsNoAnswer)
{
    port.incoming = "OK";
    runner.add(1, {asking("s", "OK", 20ms, 2)}, port.now);
    run(1s);
    EXPECT_EQ(port.texts(), "ss");
    EXPECT_EQ(outcomes.back(), std::pair(1U, false));
}

TEST_F(Running, OnlyTheBitsOfTheMaskCount)
{
    Step step = asking("s", "OK", 20ms, 1);
    step.mask[1] = 0xF0;
    port.answer = [](const std::string &) { return "OA"; };
    runner.add(1, {step}, port.now);
    run(1s);
    EXPECT_EQ(outcomes.back(), std::pair(1U, true));
}

TEST_F(Running, ADeviceThatIsSilentIsGivenUpAndTheScriptGoesOn)
{
    runner.add(1, {asking("s", "OK", 20ms, 3), plain("b", 1ms, 1)}, port.now);
    run(1s);
    EXPECT_EQ(port.texts(), "sssb");
    EXPECT_EQ(outcomes.back(), std::pair(1U, false));
}

TEST_F(Running, DevicesOfOneLineTakeTurns)
{
    port.answer = [](const std::string &text) { return text == "s" ? "" : "OK"; };
    runner.add(1, {asking("s", "OK", 50ms, 4)}, port.now);
    runner.add(2, {asking("t", "OK", 50ms, 4)}, port.now);
    runner.add(3, {asking("u", "OK", 50ms, 4)}, port.now);
    run(1s);
    EXPECT_EQ(port.texts(), "stusss") << "the silent one holds up nobody";
    EXPECT_LE(port.sent[2].at, Time(51ms));
    EXPECT_EQ(outcomes, (std::vector<std::pair<std::uint32_t, bool>>{{2, true}, {3, true}, {1, false}}));
}

TEST_F(Running, NobodyTalksWhileAnAnswerIsAwaited)
{
    runner.add(1, {asking("s", "OK", 50ms, 1)}, port.now);
    runner.add(2, {plain("x", 1ms, 1)}, port.now);
    proceed();
    port.now += 49ms;
    proceed();
    EXPECT_EQ(port.texts(), "s");
    port.now += 1ms;
    proceed();
    EXPECT_EQ(port.texts(), "sx");
}

TEST_F(Running, PausesOfOneAreTurnsOfAnother)
{
    runner.add(1, {plain("a", 100ms, 2)}, port.now);
    runner.add(2, {plain("b", 100ms, 2)}, port.now);
    run(1s);
    EXPECT_EQ(port.texts(), "abab");
    EXPECT_EQ(port.sent[1].at, Time(0));
    EXPECT_EQ(port.sent[3].at, Time(100ms));
}

TEST_F(Running, WhatSeveralHaveToSayAtOnceIsSaidOnce)
{
    port.answer = [](const std::string &text) { return text == "s" || text == "t" ? "OK" : ""; };
    for (const std::string own : {"s", "t"})
        runner.add(1, {plain("a", 5ms, 2), plain("b", 5ms, 1), asking(own, "OK", 50ms, 4)}, port.now);
    run(1s);
    EXPECT_EQ(port.texts(), "aabst");
    EXPECT_EQ(outcomes, (std::vector<std::pair<std::uint32_t, bool>>{{1, true}, {1, true}}));
}

TEST_F(Running, AFullLineIsTriedAgainAndCostsNoAttempt)
{
    port.state = Port::Sent::Later;
    runner.add(1, {plain("a", 5ms, 2)}, port.now);
    run(300ms);
    EXPECT_TRUE(port.sent.empty());
    EXPECT_LE(*runner.due(), port.now + 1ms);
    port.state = Port::Sent::All;
    run(1s);
    EXPECT_EQ(port.texts(), "aa");
    EXPECT_EQ(outcomes.back(), std::pair(1U, true));
}

TEST_F(Running, ALineThatStaysFullIsGivenUp)
{
    port.state = Port::Sent::Later;
    runner.add(1, {plain("a", 5ms, 2)}, port.now);
    run(11s);
    EXPECT_TRUE(runner.isIdle());
    EXPECT_EQ(outcomes.back(), std::pair(1U, false));
}

TEST_F(Running, ADeadLineIsGivenUpAtOnce)
{
    port.state = Port::Sent::Lost;
    runner.add(1, {plain("a", 5ms, 2)}, port.now);
    runner.add(2, {plain("b", 5ms, 2)}, port.now);
    proceed();
    EXPECT_TRUE(runner.isIdle());
    EXPECT_EQ(outcomes, (std::vector<std::pair<std::uint32_t, bool>>{{1, false}, {2, false}}));
}

TEST(RunnerOnAPipe, AMessageThatWasGivenUpHalfWrittenTakesNothingFromTheNext)
{
    std::array<int, 2> ends{};
    ASSERT_EQ(::pipe2(ends.data(), O_NONBLOCK | O_CLOEXEC), 0);
    ASSERT_EQ(::fcntl(ends[1], F_SETPIPE_SZ, 4096), 4096);
    const auto port = makePort(PortForm::Stream, ends[1]);
    Runner runner(*port);
    runner.add(1, {plain(std::string(5000, 'x'), 5ms, 1)}, Time{}, Time{});
    ASSERT_EQ(runner.proceed(Time{}).size(), 1U) << "not given up";
    std::array<char, 8192> part{};
    ASSERT_EQ(::read(ends[0], part.data(), part.size()), 4096);
    runner.add(2, {plain("stop", 5ms, 1)}, Time{1s}, Time{});
    (void)runner.proceed(Time{1s});
    const ssize_t got = ::read(ends[0], part.data(), part.size());
    EXPECT_EQ(std::string(part.data(), static_cast<std::size_t>(std::max<ssize_t>(got, 0))), "stop");
    ::close(ends[0]);
    ::close(ends[1]);
}

TEST(PortVerdict, AnSpiDeviceThatWasUnpluggedIsLost)
{
    EXPECT_EQ(verdictOn(ESHUTDOWN), Port::Sent::Lost);
    EXPECT_EQ(verdictOn(ENOBUFS), Port::Sent::Later);
}

} // namespace
} // namespace mb::guardian
