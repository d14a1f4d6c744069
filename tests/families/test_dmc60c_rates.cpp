// SPDX-License-Identifier: GPL-3.0-or-later
// Rates that were raised for a while: whatever is lost meanwhile, they are put back in their unit, and in no other.
#include "families/dmc60ccontrollerfixture.h"

namespace mb::dmc60c {
namespace {

const std::string faster = "02061885#34125C0A000000"; // the encoder's period: 10 ms
const std::string slower = "02061885#34125C64000000"; // 100 ms
const std::string restarted = "0206FCC5#07000000";

class Dmc60cRates : public Dmc60cController {
protected:
    Dmc60cRates()
    {
        unit.answer("02061805#34125C", {{"02061845#5C6400000000"}});
        unit.answer(faster, {{"02061845#5C0A00000000"}});
        unit.answer(slower, {{"02061845#5C6400000000"}});
        EXPECT_TRUE(run(device->setRate(channel("velocity"), 100.0)));
    }
    /// The bus carries nothing while it is put back.
    void lowerInVain()
    {
        bus.setLoss(1.0);
        EXPECT_FALSE(run(device->setRate(channel("velocity"), 0.0)));
        clock.advance(1s);
        bus.setLoss(0.0);
        EXPECT_EQ(unit.count(slower), 0);
    }
    void hear()
    {
        unit.send(resting);
        clock.advance(5ms);
    }
};

TEST_F(Dmc60cRates, ThatCouldNotBePutBackArePutBackWhenTheUnitIsHeardAgain)
{
    lowerInVain();
    hear();
    EXPECT_EQ(unit.count(slower), 1);
    for (int i = 0; i < 3; ++i) {
        clock.advance(1s);
        hear();
    }
    EXPECT_EQ(unit.count(slower), 1) << "it has answered";
    EXPECT_EQ(unit.count(faster), 1);
}

TEST_F(Dmc60cRates, ArePutBackOverALinkThatWasLost)
{
    host.close();
    EXPECT_FALSE(run(device->setRate(channel("velocity"), 0.0)));
    ASSERT_TRUE(host.open());
    hear();
    EXPECT_EQ(unit.count(slower), 1);
}

TEST_F(Dmc60cRates, ArePutBackUntilThatIsAnsweredOnceASecond)
{
    unit.answer(slower, {{}, {}, {"02061845#5C6400000000"}});
    lowerInVain();
    for (int i = 0; i < 50; ++i) {
        clock.advance(95ms);
        hear();
    }
    EXPECT_EQ(unit.count(slower), 3);
}

TEST_F(Dmc60cRates, ThatNobodyWishesAnyMoreAreNotWrittenIntoAUnitThatStartsAnew)
{
    lowerInVain();
    unit.send(restarted);
    hear();
    hear();
    EXPECT_EQ(unit.count(faster), 1);
    EXPECT_EQ(unit.count(slower), 0) << "it has its own";
}

TEST_F(Dmc60cRates, ThatAreWishedAreAskedForUntilAUnitThatStartedAnewAnswers)
{
    unit.answer(faster, {{}, {"02061845#5C0A00000000"}});
    unit.send(restarted);
    for (int i = 0; i < 30; ++i) {
        clock.advance(95ms);
        hear();
    }
    EXPECT_EQ(unit.count(faster), 3) << "once when they were raised";
}

TEST_F(Dmc60cRates, ThatWereRefusedAreNotWrittenIntoAUnitThatStartsAnew)
{
    const std::string refused = "02061885#34125C14000000"; // 20 ms
    unit.answer(refused, {{"02061845#5C0A00000002"}});
    EXPECT_FALSE(run(device->setRate(channel("velocity"), 50.0)));
    unit.send(restarted);
    hear();
    hear();
    EXPECT_EQ(unit.count(refused), 1);
}

TEST_F(Dmc60cRates, GoBackToWhatSomebodyHasWrittenMeanwhile)
{
    unit.answer("02061885#34125C32000000", {{"02061845#5C3200000000"}}); // 50 ms
    ASSERT_TRUE(run(device->write(index("status.encoder.period"), 50)));
    ASSERT_TRUE(run(device->setRate(channel("velocity"), 0.0)));
    EXPECT_EQ(unit.count("02061885#34125C32000000"), 2);
    EXPECT_EQ(unit.count(slower), 0);
}

TEST_F(Dmc60cRates, StayWhatTheyWereRaisedToWhereSomebodyHasWrittenThatMeanwhile)
{
    unit.answer("02061805#34125C", {{"02061845#5C0A00000000"}});
    ASSERT_TRUE(run(device->write(index("status.encoder.period"), 10)));
    ASSERT_TRUE(run(device->setRate(channel("velocity"), 0.0)));
    EXPECT_EQ(unit.count(slower), 0);
}

TEST_F(Dmc60cRates, GoBackToWhatAnotherProgramHasWrittenMeanwhile)
{
    unit.answer("02061885#34125C32000000", {{"02061845#5C3200000000"}});
    unit.send("02061845#5C3200000000"); // its answer
    clock.advance(5ms);
    ASSERT_TRUE(run(device->setRate(channel("velocity"), 0.0)));
    EXPECT_EQ(unit.count("02061885#34125C32000000"), 1);
}

TEST_F(Dmc60cRates, AnAnswerFromBeforeANewWishIsNobodysChoice)
{
    unit.answer("02061885#34125C05000000", {{"02061845#5C0A00000000", "02061845#5C0500000000"}});
    ASSERT_TRUE(run(device->setRate(channel("velocity"), 200.0)));
    clock.advance(5ms);
    ASSERT_TRUE(run(device->setRate(channel("velocity"), 0.0)));
    EXPECT_EQ(unit.count(slower), 1);
}

TEST_F(Dmc60cRates, AUnitThatTookTheNumberGetsItsOwnBackNotThatOfTheOneBefore)
{
    unit.answer("02061805#34125B", {{"02061845#5B2800000000"}}); // somebody had set 40 ms
    unit.answer("02061885#34125B0A000000", {{"02061845#5B0A00000000"}});
    unit.answer("02061885#34125B64000000", {{"02061845#5B6400000000"}});
    ASSERT_TRUE(run(device->setRate(channel("current"), 100.0)));
    unit.send(restarted);
    hear();
    ASSERT_TRUE(run(device->setRate(channel("current"), 0.0)));
    EXPECT_EQ(unit.count("02061885#34125B28000000"), 0);
    EXPECT_EQ(unit.count("02061885#34125B64000000"), 1);
}

} // namespace
} // namespace mb::dmc60c
