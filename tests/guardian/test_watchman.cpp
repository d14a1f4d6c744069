// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/guardian/watchman.h"
#include "fakeport.h"

#include <gtest/gtest.h>

namespace mb::guardian {
namespace {

using namespace std::chrono_literals;
using Kind = Order::Kind;

class Watching : public testing::Test {
protected:
    void hear(Kind kind, std::uint32_t id, const std::string &stopBytes = "a")
    {
        Order order{kind, id, {}, {}};
        if (kind == Kind::Watch) {
            order.name = "motor " + std::to_string(id);
            order.script = {{test::bytes(stopBytes), {}, {}, 5ms, 2}};
        }
        watchman.hear(encode(order), port.now);
    }
    void run(Time time)
    {
        for (const Time end = port.now + time; port.now < end; port.now += 1ms)
            watchman.proceed(port.now);
    }
    std::vector<Report> takeReports() { return std::exchange(reports, {}); }

    test::FakePort port;
    std::vector<Report> reports;
    std::vector<std::string> lines;
    std::map<std::string, bool> debts; ///< device: owed now
    Watchman watchman{port,
        {[this](const Report &report) { reports.push_back(report); },
            [this](const std::string &line) { lines.push_back(line); },
            [this](const Watchman::Owed &owed, bool isOwed) { debts[owed.name] = isOwed; }}};
};

TEST_F(Watching, ConfirmsAWatchAndEveryRenewal)
{
    hear(Kind::Watch, 4);
    hear(Kind::Renew, 4);
    EXPECT_EQ(
        takeReports(), (std::vector<Report>{{Report::Kind::Standing, 4, false}, {Report::Kind::Standing, 4, false}}));
    hear(Kind::Renew, 5);
    EXPECT_TRUE(takeReports().empty()) << "nobody asked it to watch over 5";
}

TEST_F(Watching, SendsNothingAsLongAsTheProgramLives)
{
    hear(Kind::Watch, 4);
    for (int i = 0; i < 100; ++i) {
        run(499ms);
        hear(Kind::Renew, 4);
    }
    EXPECT_TRUE(port.sent.empty());
    EXPECT_FALSE(watchman.isListening()) << "what can be read is the program's";
}

TEST_F(Watching, StopsAfterHalfASecondOfSilenceAndSaysSo)
{
    port.now = 3s;
    hear(Kind::Watch, 4);
    takeReports();
    EXPECT_EQ(*watchman.due(), Time(3500ms));
    run(500ms);
    EXPECT_TRUE(port.sent.empty());
    run(100ms);
    EXPECT_EQ(port.texts(), "aa");
    EXPECT_EQ(port.sent[0].at, Time(3500ms));
    EXPECT_EQ(takeReports(), (std::vector<Report>{{Report::Kind::Acted, 4, true}}));
    EXPECT_EQ(lines,
        std::vector<std::string>{
            "sent the stop, NOT CONFIRMED, look whether it stands: motor 4 (the program that drove it fell silent)"});
    EXPECT_FALSE(watchman.isDone()) << "the program may come back and is told";
    EXPECT_FALSE(watchman.due());
}

TEST_F(Watching, StopsAtOnceWhenTheProgramEnds)
{
    hear(Kind::Watch, 4, "a");
    hear(Kind::Watch, 5, "b");
    run(10ms);
    watchman.hangUp(port.now);
    EXPECT_FALSE(watchman.isDone());
    const Time begin = port.now;
    run(100ms);
    EXPECT_EQ(port.texts(), "abab");
    EXPECT_EQ(port.sent[1].at, begin);
    EXPECT_EQ(lines.size(), 2U);
    EXPECT_TRUE(watchman.isDone());
}

TEST_F(Watching, AProgramThatEndsInOrderLeavesNothingToDo)
{
    hear(Kind::Watch, 4);
    hear(Kind::Forget, 4);
    run(2s);
    watchman.hangUp(port.now);
    EXPECT_TRUE(watchman.isDone());
    EXPECT_TRUE(port.sent.empty());
    EXPECT_TRUE(lines.empty());
}

TEST_F(Watching, StopsOneWhenToldAndWatchesTheOther)
{
    hear(Kind::Watch, 4, "a");
    hear(Kind::Watch, 5, "b");
    hear(Kind::Stop, 4);
    run(100ms);
    EXPECT_EQ(port.texts(), "aa");
    hear(Kind::Stop, 4);
    run(100ms);
    EXPECT_EQ(port.texts(), "aa") << "once is enough";
    run(1s);
    EXPECT_EQ(port.texts(), "aabb");
}

TEST_F(Watching, AProgramThatComesBackIsNotWatchedUntilItAsks)
{
    hear(Kind::Watch, 4);
    run(600ms);
    takeReports();
    hear(Kind::Renew, 4);
    EXPECT_TRUE(takeReports().empty());
    run(2s);
    EXPECT_EQ(port.texts(), "aa") << "what was stopped is not stopped for ever";
    hear(Kind::Watch, 6);
    EXPECT_EQ(takeReports(), (std::vector<Report>{{Report::Kind::Standing, 6, false}}));
    run(600ms);
    EXPECT_EQ(port.texts(), "aaaa");
}

TEST_F(Watching, AProgramThatFellSilentPaysNothingUntilItIsHeardAgainOrEnds)
{
    hear(Kind::Watch, 4);
    run(490ms);
    EXPECT_FALSE(watchman.hasFallenSilent());
    run(20ms);
    EXPECT_TRUE(watchman.hasFallenSilent());
    hear(Kind::Forget, 4);
    EXPECT_FALSE(watchman.hasFallenSilent()) << "it has thawed";
    run(2s);
    EXPECT_FALSE(watchman.hasFallenSilent()) << "one that drives nothing has nothing to say";
    hear(Kind::Watch, 5);
    run(600ms);
    EXPECT_TRUE(watchman.hasFallenSilent());
    watchman.hangUp(port.now);
    EXPECT_FALSE(watchman.hasFallenSilent()) << "whoever has its line now is another one";
}

TEST_F(Watching, ItsOwnDelayIsNoSilenceOfTheProgram)
{
    hear(Kind::Watch, 4);
    port.now += 2s; // this process had no turn; what came meanwhile is heard first
    hear(Kind::Renew, 4);
    run(400ms);
    EXPECT_TRUE(port.sent.empty());
}

TEST_F(Watching, TellsWhenTheStopWasNotConfirmed)
{
    hear(Kind::Watch, 4);
    port.state = Port::Sent::Lost;
    watchman.hangUp(port.now);
    run(10ms);
    EXPECT_EQ(takeReports().back(), (Report{Report::Kind::Acted, 4, false}));
    EXPECT_EQ(lines,
        std::vector<std::string>{"TRIED IN VAIN to stop, cut its power: motor 4 (the program that drove it ended)"});
}

TEST_F(Watching, AStopThatFailedStaysOwedAndGoesOutWhenTheLineIsBack)
{
    hear(Kind::Watch, 4);
    port.state = Port::Sent::Lost;
    watchman.hangUp(port.now);
    run(10ms);
    EXPECT_TRUE(watchman.isOwing());
    EXPECT_TRUE(watchman.isCut());
    EXPECT_FALSE(watchman.isDone()) << "it waits for the line";
    EXPECT_TRUE(debts.at("motor 4"));
    watchman.pay(port.now);
    run(10ms);
    EXPECT_TRUE(watchman.isOwing()) << "still cut";
    port.state = Port::Sent::All;
    watchman.pay(port.now);
    run(100ms);
    EXPECT_EQ(port.texts(), "aa");
    EXPECT_FALSE(debts.at("motor 4"));
    EXPECT_TRUE(watchman.isDone());
    EXPECT_EQ(lines.back(), "stopped at last motor 4 (the program that drove it ended)");
    EXPECT_EQ(reports.size(), 2U) << "Standing and Acted, once each";
}

TEST_F(Watching, AStopIsOwedForTenMinutes)
{
    hear(Kind::Watch, 4);
    port.state = Port::Sent::Lost;
    watchman.hangUp(port.now);
    run(10ms);
    port.now += 9min;
    watchman.proceed(port.now);
    EXPECT_TRUE(watchman.isOwing());
    port.now += 61s;
    watchman.proceed(port.now);
    EXPECT_TRUE(watchman.isDone());
    EXPECT_TRUE(debts.at("motor 4")) << "nobody has seen it stand";
    EXPECT_EQ(lines.back(), "GAVE UP after ten minutes, cut its power: motor 4 (the program that drove it ended)");
}

TEST_F(Watching, EachStopIsOwedForTenMinutesOfItsOwn)
{
    hear(Kind::Watch, 4);
    port.state = Port::Sent::Lost;
    run(500ms + 10ms);
    port.now += 9min;
    hear(Kind::Watch, 5);
    watchman.hangUp(port.now);
    run(10ms);
    port.now += 61s;
    watchman.proceed(port.now);
    EXPECT_EQ(
        lines.back(), "GAVE UP after ten minutes, cut its power: motor 4 (the program that drove it fell silent)");
    EXPECT_TRUE(watchman.isOwing()) << "5 for nine more";
    watchman.pay(port.now);
    port.state = Port::Sent::All;
    run(100ms);
    EXPECT_EQ(lines.back(), "stopped at last motor 5 (the program that drove it ended)");
    EXPECT_TRUE(watchman.isDone());
}

TEST_F(Watching, AStopThatAnotherProcessHasSettledIsNotItsBusinessAnyMore)
{
    hear(Kind::Watch, 4, "a");
    hear(Kind::Watch, 5, "b");
    port.state = Port::Sent::Lost;
    watchman.hangUp(port.now);
    run(10ms);
    watchman.settle([](const Watchman::Owed &owed) { return owed.name == "motor 4"; });
    port.state = Port::Sent::All;
    watchman.pay(port.now);
    run(100ms);
    EXPECT_EQ(port.texts(), "bb") << "whoever drives 4 by now goes on";
    EXPECT_TRUE(watchman.isDone());
    EXPECT_EQ(lines.size(), 3U);
    EXPECT_EQ(lines.back(), "stopped at last motor 5 (the program that drove it ended)");
}

TEST_F(Watching, RefusesWhatMakesNoSense)
{
    const Bytes nonsense{9, 9, 9};
    watchman.hear(nonsense, port.now);
    EXPECT_EQ(takeReports(), (std::vector<Report>{{Report::Kind::Refused, 0, false}}));
}

} // namespace
} // namespace mb::guardian
