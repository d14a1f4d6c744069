// SPDX-License-Identifier: GPL-3.0-or-later
// What a drive is asked, how often, and what its answer proves.
#include "abstractdccontrollerbench.h"

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

} // namespace
} // namespace mb::abstractdc
