// SPDX-License-Identifier: GPL-3.0-or-later
// Recordings in which somebody else asks an Abstract DC Drive: its losses and its silence are those of that run.
#include "async/virtualclock.h"
#include "families/abstractdc/codec.h"
#include "families/abstractdc/scan.h"
#include "model/family.h"
#include "support/temporaryfile.h"
#include "transport/backends/replay.h"
#include "wire/bytes.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace mb::abstractdc {
extern const Family family;

namespace {

using namespace std::chrono_literals;

/// The drive with offset 3, asked for its position by another master.
class AbstractDcRecording : public testing::Test {
protected:
    void pass(const CanFrame &frame, Duration after)
    {
        now += after;
        const auto micros = std::chrono::duration_cast<std::chrono::microseconds>(now).count();
        const std::string part = std::to_string(micros % 1'000'000);
        text += '(' + std::to_string(micros / 1'000'000) + '.' + std::string(6 - part.size(), '0') + part + ") can0 "
            + toText(frame) + '\n';
    }
    void question(Duration after) { pass(encodeLogRequest(dialectF, 3, Log::Position), after); }
    void answer(Duration after = 1ms)
    {
        CanFrame frame;
        frame.id = replyId(dialectF, 3, Log::Position);
        frame.size = 4;
        writeU32le(frame.data, 0, 1000);
        pass(frame, after);
    }
    /// Questions 50 ms apart: the next one comes before the one before has had its time.
    void answered(int count)
    {
        for (int i = 0; i < count; ++i) {
            question(49ms);
            answer();
        }
    }
    void unanswered(int count)
    {
        for (int i = 0; i < count; ++i)
            question(50ms);
    }
    /// Something that passes later, so that the recording goes on.
    void somethingElse(Duration after) { pass(*canFrameFromText("123#01"), after); }

    void play(const Dialect *dialect = &dialectF)
    {
        auto made = ReplayLink::create(*LinkAddress::parse("replay:" + folder.write("run.log", text)), clock);
        ASSERT_TRUE(made);
        link = std::move(*made);
        ASSERT_TRUE(link->open());
        device = family.open(*link, link->timeLine(), identityOf(3, dialect));
        bool ended = false;
        const Subscription end = link->ended().add([&ended] { ended = true; });
        link->play();
        ASSERT_TRUE(clock.runUntil([&ended] { return ended; }));
        device->telemetry()->commit();
    }
    [[nodiscard]] std::size_t positions() const
    {
        return device->telemetry()->size(*findChannel(family.channels, "position"));
    }
    [[nodiscard]] std::uint64_t lost() const
    {
        return device->telemetry()->lost(*findChannel(family.channels, "position"));
    }

    test::TemporaryFolder folder;
    VirtualClock clock;
    Duration now = 1'500'000'000s;
    std::string text;
    std::unique_ptr<ReplayLink> link;
    std::unique_ptr<Device> device;
};

TEST_F(AbstractDcRecording, QuestionsOfAnotherMasterWithoutAnAnswerAreItsLosses)
{
    answered(10);
    unanswered(2);
    answered(5);
    unanswered(1);
    somethingElse(1s);
    play();
    EXPECT_TRUE(device->liveness().heard);
    EXPECT_EQ(lost(), 3U);
}

TEST_F(AbstractDcRecording, NothingIsLostWhereEveryQuestionHasItsAnswer)
{
    answered(20);
    somethingElse(1s);
    play();
    EXPECT_EQ(positions(), 20U);
    EXPECT_EQ(lost(), 0U);
}

TEST_F(AbstractDcRecording, WhereNoBitRateIsKnownAnAnswerMayComeLateBecauseAProgramGivesIt)
{
    for (int i = 0; i < 10; ++i) {
        question(200ms);
        answer(60ms);
    }
    play();
    EXPECT_EQ(positions(), 10U);
    EXPECT_EQ(lost(), 0U);
}

TEST_F(AbstractDcRecording, OnlyWhatAsksThisDriveIsItsQuestion)
{
    answered(5);
    for (int i = 0; i < 5; ++i) {
        pass(encodeLogRequest(dialectF, 4, Log::Position), 200ms); // another drive
        pass(*canFrameFromText("00000387#01"), 200ms);             // a long identifier
        CanFrame longer = encodeLogRequest(dialectF, 3, Log::Position);
        longer.size = 2;
        pass(longer, 200ms);
    }
    play();
    EXPECT_TRUE(device->liveness().heard);
    EXPECT_EQ(lost(), 0U);
}

TEST_F(AbstractDcRecording, FiveQuestionsWithoutAnAnswerAreASilence)
{
    answered(5);
    unanswered(5);
    somethingElse(1s);
    play();
    EXPECT_FALSE(device->liveness().heard);
}

TEST_F(AbstractDcRecording, FourMayBeLostAndItIsHeardStill)
{
    answered(5);
    unanswered(4);
    somethingElse(1s);
    play();
    EXPECT_TRUE(device->liveness().heard);
}

TEST_F(AbstractDcRecording, ASilenceEndsWithTheNextAnswer)
{
    answered(5);
    unanswered(5);
    somethingElse(1s);
    answered(1);
    play();
    EXPECT_TRUE(device->liveness().heard);
}

TEST_F(AbstractDcRecording, ADriveOfAnUnknownDialectHasNoLosses)
{
    answered(5);
    unanswered(3);
    somethingElse(1s);
    play(nullptr);
    EXPECT_EQ(lost(), 0U);
}

} // namespace
} // namespace mb::abstractdc
