// SPDX-License-Identifier: GPL-3.0-or-later
// What a drive is asked, how often, and what its answer proves.
#include "abstractdccontrollerbench.h"

#include "families/abstractdc/logpoller.h"
#include "families/abstractdc/questionbook.h"
#include "families/abstractdc/questionwatch.h"
#include "support/loosemotor.h"

#include <algorithm>

namespace mb::abstractdc {
namespace {

struct AbstractDcAsked : AbstractDcController {
    AbstractDcAsked()
        : AbstractDcController(12'500)
    {
    }
};

/// The poller asks the same of a drive that runs by velocity.
TEST_F(AbstractDcAsked, TheAnswerToAQuestionThatWasAskedBeforeASettingDoesNotProveIt)
{
    Simulator &drive = add("abstractdc:3");
    open(3, &dialectF);
    ASSERT_TRUE(write("velocity.divisor", 1000));
    ASSERT_TRUE(device->command(setPoint(Mode::Velocity, 0.0)));
    clock.advance(1s);
    sent.clear();
    ASSERT_TRUE(clock.runUntil([this] { return !sent.empty() && sent.back() == "387#01"; }, 2s));
    const Subscription dies = host.received().add([&drive](const CanFrame &frame) {
        if (frame.id == 0x403)
            drive.setPowered(false);
    });
    const auto written = write("velocity.p", 5);
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().fault, Fault::Timeout);
}

/// Speeds of this one (dialect F) and of one of dialect L with the offset 27 have one identifier.
TEST_F(AbstractDcController, AQuestionThatNobodyAnswersAloneHoldsASettingUpForAWhileOnly)
{
    add("abstractdc:3");
    open(3, &dialectF);
    VirtualCanLink other(*LinkAddress::parse("sim:can"), bus);
    ASSERT_TRUE(other.open());
    Timer asking(clock);
    std::function<void()> ask = [&] {
        for (const char *question : {"387#01", "39F#01"})
            (void)other.send(*canFrameFromText(question));
        asking.startIn(5ms, ask);
    };
    ask();
    clock.advance(100ms);
    const Instant begin = clock.now();
    (void)write("velocity.p", 5);
    EXPECT_FALSE(sentOf("387#01").empty());
    EXPECT_LT(clock.now() - begin, 1s);
}

TEST_F(AbstractDcController, AWishForTheVelocityRaisesTheRateOfThePositionOnlyWhileItLasts)
{
    add("abstractdc:3");
    open(3, &dialectF);
    const auto questions = [this] {
        sent.clear();
        clock.advance(1s);
        return sentOf("387#00").size();
    };
    const std::size_t usual = questions();
    EXPECT_LT(usual, 30U);
    ASSERT_TRUE(test::run(clock, device->setRate(channel("velocity"), 200.0)));
    EXPECT_NEAR(static_cast<double>(questions()), 200.0, 5.0);
    ASSERT_TRUE(test::run(clock, device->setRate(channel("velocity"), 0.0)));
    EXPECT_NEAR(static_cast<double>(questions()), static_cast<double>(usual), 1.0);
    ASSERT_TRUE(test::run(clock, device->setRate(channel("position"), 100.0)));
    ASSERT_TRUE(test::run(clock, device->setRate(channel("velocity"), 200.0)));
    ASSERT_TRUE(test::run(clock, device->setRate(channel("velocity"), 0.0)));
    EXPECT_NEAR(static_cast<double>(questions()), 100.0, 5.0) << "its own";
}

TEST_F(AbstractDcAsked, WhoeverPollsADriveLeavesRoomForAllOthersWhoPollWhateverItsNumber)
{
    add("abstractdc:3");
    open(3, &dialectF);
    ASSERT_TRUE(test::run(clock, device->setRate(channel("velocity"), 200.0)));
    VirtualCanLink other(*LinkAddress::parse("sim:can"), bus);
    ASSERT_TRUE(other.open());
    const auto questionsBeside = [&](const char *others) {
        Timer asking(clock);
        std::function<void()> ask = [&] {
            (void)other.send(*canFrameFromText(others));
            asking.startIn(200ms, ask);
        };
        if (*others != 0)
            ask();
        clock.advance(5s);
        sent.clear();
        clock.advance(5s);
        return static_cast<double>(sentOf("387#").size());
    };
    const double alone = questionsBeside("");
    const double shared = questionsBeside("385#00");
    EXPECT_LT(shared, 0.8 * alone);
    EXPECT_NEAR(questionsBeside("3E7#00"), shared, 2.0) << "the drive with the highest number";
    EXPECT_GT(questionsBeside("3E8#00"), 0.8 * alone) << "there is none beyond it";
}

TEST(AbstractDcLogPoller, WhatIsSentToOthersHoldsNoQuestionUpWhereNobodyKnowsTheRate)
{
    const auto asked = [](bool isBusy) {
        VirtualClock clock;
        test::LoggedLink link(clock, {});
        EXPECT_TRUE(link.open());
        LogPoller poller(link, clock, {});
        poller.speak(&dialectF, 3);
        poller.wish(Log::Position, 20.0);
        Timer sending(clock);
        std::function<void()> send = [&] {
            (void)link.send(extendedFrame(0x0206FC05, {}));
            sending.startIn(5ms, send);
        };
        if (isBusy)
            send();
        clock.advance(1s);
        return std::ranges::count(link.sent, "387#00");
    };
    EXPECT_GT(asked(false), 4) << "in vain";
    EXPECT_EQ(asked(true), asked(false));
}

TEST(AbstractDcQuestionWatch, OnlyTheLogThatIsPassingNowAnswersAQuestion)
{
    VirtualClock clock;
    VirtualCanBus bus(clock, 1'000'000, 1);
    VirtualCanLink host(*LinkAddress::parse("sim:can"), bus);
    VirtualCanLink other(*LinkAddress::parse("sim:can"), bus);
    ASSERT_TRUE(host.open() && other.open());
    QuestionWatch watch(host, clock);
    const Question question{3, id::logRequest, 1};
    const auto pass = [&](const char *frame) {
        (void)other.send(*canFrameFromText(frame));
        clock.advance(1ms);
        return watch.isAnswerTo(question);
    };
    for (const char *next : {"00000240#", "0206FC05#01020304", "067#0000000000", "387#01", "404#01000000", "387#R4"}) {
        EXPECT_FALSE(pass("387#01"));
        EXPECT_TRUE(pass("403#01000000"));
        EXPECT_TRUE(watch.answersOnly(1));
        EXPECT_FALSE(pass(next)) << next;
        EXPECT_FALSE(watch.answersOnly(1)) << next;
    }
    EXPECT_FALSE(pass("403#01000000")) << "it has been answered";
    EXPECT_FALSE(pass("387#01"));
    EXPECT_FALSE(pass("00000403#01000000")) << "of another protocol, with a long identifier";
    EXPECT_TRUE(pass("403#01000000"));
}

TEST(AbstractDcQuestionBook, TheOldestOf256QuestionsGivesWayToANewerOne)
{
    QuestionBook book;
    const auto question = [](int number) {
        return Question{number % 100, id::logRequest, static_cast<std::uint8_t>(number / 100)};
    };
    for (int i = 0; i < 256; ++i)
        book.ask(question(i), Instant{}, 1s);
    EXPECT_EQ(book.open().size(), 256U);
    EXPECT_EQ(book.open().front().question, question(0));
    book.ask(question(256), Instant{}, 1s);
    EXPECT_EQ(book.open().size(), 256U);
    EXPECT_EQ(book.open().front().question, question(1));
    book.ask(question(1), Instant{}, 1s);
    EXPECT_EQ(book.open().front().question, question(2)) << "asked again it is the newest";
    book.expire(Instant{} + 1s);
    EXPECT_TRUE(book.open().empty());
}

} // namespace
} // namespace mb::abstractdc
