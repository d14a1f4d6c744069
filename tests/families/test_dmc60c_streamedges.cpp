// SPDX-License-Identifier: GPL-3.0-or-later
// Where the accounting of lost status frames changes its mind, each edge from both sides.
#include "dmc60cstreamfixture.h"

namespace mb::dmc60c {
namespace {

TEST_F(Dmc60cStream, OneAndAHalfPeriodsAreOneMissingFrameAndAnythingLessIsJitter)
{
    for (const auto gap : {10ms, 10ms})
        after(gap);
    after(15ms - 1ns);
    after(10ms);
    EXPECT_EQ(lost(), 0U);
    stream.interrupt();
    for (const auto gap : {10ms, 10ms, 15ms, 10ms})
        after(gap);
    EXPECT_EQ(lost(), 1U);
}

TEST_F(Dmc60cStream, AnEarlyFrameMovesTheRhythmByAQuarterOfItsEarliness)
{
    for (const auto gap : {10ms, 10ms, 6ms}) // 3 ms of it are still expected
        after(gap);
    after(18ms - 1ns);
    after(10ms);
    EXPECT_EQ(lost(), 0U);
    stream.interrupt();
    for (const auto gap : {10ms, 10ms, 6ms, 18ms, 10ms})
        after(gap);
    EXPECT_EQ(lost(), 1U);
}

TEST_F(Dmc60cStream, AFrameThatComesLateIsNotCountedAsLostWhereverItFallsInThePeriod)
{
    for (const auto gap : {10ms, 10ms, 19ms, 5ms, 10ms}) // half a period after one that was early
        after(gap);
    EXPECT_EQ(lost(), 0U);
    stream.interrupt();
    for (const auto gap : {10ms, 10ms, 21ms})
        after(gap);
    after(4900us); // shortly before that, after one that was late
    after(10ms);
    EXPECT_EQ(lost(), 0U);
    EXPECT_EQ(recorded(), sent);
}

TEST_F(Dmc60cStream, AFrameIsHeldBackBehindMoreThanAPeriodAndAQuarter)
{
    for (const auto gap : {10ms, 10ms})
        after(gap);
    after(12500us);
    EXPECT_FALSE(stream.isHolding());
    stream.interrupt();
    for (const auto gap : {10ms, 10ms})
        after(gap);
    after(12500us + 1ns);
    EXPECT_TRUE(stream.isHolding());
    after(10ms);
    EXPECT_FALSE(stream.isHolding());
    EXPECT_EQ(lost(), 0U);
    EXPECT_EQ(recorded(), sent);
}

TEST_F(Dmc60cStream, APeriodThatWasToldAgainMayBeginAnewUntilShortlyBeforeTwoOfThem)
{
    constexpr Duration edge = 2 * Duration(10ms) - Duration(10ms) / 32;
    for (const auto gap : {10ms, 10ms})
        after(gap);
    stream.setPeriod(10ms);
    after(edge - 1ns);
    EXPECT_FALSE(stream.isHolding());
    after(10ms);
    EXPECT_EQ(lost(), 0U);
    stream.setPeriod(10ms);
    after(edge);
    EXPECT_TRUE(stream.isHolding());
    after(10ms);
    EXPECT_EQ(lost(), 1U);
}

TEST_F(Dmc60cStream, APeriodThatIsToldWhileFramesAreHeldBackBeginsNothingAnew)
{
    for (const auto gap : {10ms, 10ms, 30ms})
        after(gap);
    stream.setPeriod(10ms);
    after(17ms);
    after(10ms);
    EXPECT_EQ(lost(), 2U + 1U);
    EXPECT_EQ(recorded(), sent);
}

TEST_F(Dmc60cStream, OnlyTheGapBehindTheToldPeriodMayBeAnewBeginning)
{
    after(10ms);
    stream.setPeriod(10ms);
    after(10ms);
    after(19ms);
    after(11ms);
    EXPECT_EQ(lost(), 1U) << "the period was told a frame earlier";
}

TEST_F(Dmc60cStream, AFrameBehindAGapIsALateOneOnlyWithinHalfAPeriod)
{
    for (const auto gap : {10ms, 10ms, 20ms})
        after(gap);
    after(5ms - 1ns);
    EXPECT_FALSE(stream.isHolding());
    EXPECT_EQ(lost(), 0U) << "it was on its way";
    stream.interrupt();
    for (const auto gap : {10ms, 10ms, 20ms, 5ms})
        after(gap);
    EXPECT_EQ(lost(), 1U);
    EXPECT_EQ(recorded(), sent);
}

TEST_F(Dmc60cStream, ThreeQuartersOfAPeriodAreNoShorterOne)
{
    for (int i = 0; i < 30; ++i)
        after(7500us);
    EXPECT_EQ(stream.period(), 10ms);
    for (int i = 0; i < 4; ++i)
        after(7500us - 1ns);
    EXPECT_EQ(stream.period(), 7500us - 1ns);
    EXPECT_EQ(lost(), 0U);
}

TEST_F(Dmc60cStream, NothingShorterThanHalfAMillisecondIsAPeriod)
{
    after(10ms);
    for (int i = 0; i < 30; ++i)
        after(500us - 1ns);
    EXPECT_EQ(stream.period(), 10ms);
    for (int i = 0; i < 4; ++i)
        after(500us);
    EXPECT_EQ(stream.period(), 500us);
}

TEST_F(Dmc60cStream, AShorterPeriodIsTheMeanOfFourGapsInARow)
{
    for (const auto gap : {10ms, 10ms, 3ms, 4ms, 10ms, 3ms, 4ms, 3ms})
        after(gap);
    EXPECT_EQ(stream.period(), 10ms) << "not in a row";
    after(4ms);
    EXPECT_EQ(stream.period(), 3500us);
}

TEST_F(Dmc60cStream, EightHeldGapsAreAPeriodWhenTheyDifferByLessThanAThirdOfTheOldOne)
{
    struct Row {
        Duration more;
        bool alike;
    };
    for (const Row &row : {Row{3333332ns, true}, Row{3333333ns, false}}) {
        const std::uint64_t before = lost();
        stream.restart();
        after(10ms);
        after(70ms); // a mixture
        for (int i = 0; i < 7; ++i)
            after(i % 2 == 0 ? Duration(30ms) : 30ms + row.more);
        EXPECT_EQ(stream.period() == 10ms, !row.alike);
        EXPECT_EQ(stream.isHolding(), !row.alike);
        EXPECT_EQ(lost() - before, row.alike ? 0U : 6U + 6U * 2U) << "those of the last gap may still come";
        if (row.alike) {
            EXPECT_EQ(stream.period(), (7 * 30ms + 3 * row.more) / 7);
        }
    }
}

TEST_F(Dmc60cStream, TheRhythmOfALongerPeriodBeginsWithTheFrameThatTaughtIt)
{
    for (const Duration early : {0ns, 1ns}) {
        const std::uint64_t before = lost();
        stream.restart();
        for (int i = 0; i < 9; ++i)
            after(i == 0 ? 10ms : 39ms);
        ASSERT_EQ(stream.period(), 39ms);
        after(58500us - early); // one and a half
        after(39ms);
        EXPECT_EQ(lost() - before, early == 0ns ? 1U : 0U);
    }
}

TEST_F(Dmc60cStream, TheFirstOfEightGapsMayBeAnythingAndTheSecondNot)
{
    after(10ms);
    for (const auto gap : {30ms, 50ms, 30ms, 30ms, 30ms, 30ms, 30ms, 30ms})
        after(gap);
    EXPECT_EQ(stream.period(), 10ms);
    EXPECT_EQ(lost(), 2U + 4U + 5U * 2U);
}

TEST_F(Dmc60cStream, ATenthMoreOrLessIsTheSamePeriodMadeExact)
{
    struct Row {
        Duration told;
        bool known;
    };
    for (const Row &row :
        {Row{11111111ns, true}, Row{11111112ns, false}, Row{9000001ns, true}, Row{9000000ns, false}, Row{10ms, true}}) {
        const std::uint64_t before = lost();
        stream.restart();
        for (const auto gap : {10ms, 10ms, 10ms})
            after(gap);
        stream.setPeriod(row.told);
        EXPECT_EQ(stream.period(), row.told);
        after(2 * row.told);
        after(row.told);
        after(row.told);
        EXPECT_EQ(lost() - before, row.known ? 1U : 0U) << row.told.count();
    }
}

TEST_F(Dmc60cStream, ExactlyATenthIsAnotherPeriodInBothDirections)
{
    for (const auto &[before, told] : {std::pair{9ms, 10ms}, {10ms, 9ms}}) {
        const std::uint64_t lostBefore = lost();
        stream.restart();
        stream.setPeriod(before);
        for (int i = 0; i < 3; ++i)
            after(before);
        stream.setPeriod(told);
        after(2 * told);
        after(told);
        EXPECT_EQ(lost() - lostBefore, 0U) << told.count();
    }
}

TEST_F(Dmc60cStream, SilenceCountsTheGapsBeforeItAndARestartForgetsThem)
{
    stream.interrupt();
    EXPECT_TRUE(telemetry->gaps(a, Instant{}, time).empty()) << "nothing was heard yet";
    for (const auto gap : {10ms, 10ms, 30ms})
        after(gap);
    stream.interrupt();
    EXPECT_EQ(lost(), 2U);
    EXPECT_FALSE(stream.isHolding());
    for (const auto gap : {10ms, 10ms, 30ms})
        after(gap);
    stream.restart();
    EXPECT_EQ(lost(), 2U);
    EXPECT_FALSE(stream.isHolding());
    EXPECT_EQ(recorded(), sent);
}

TEST_F(Dmc60cStream, OfSeveralThatComeLateEachTakesOneFromTheNewestGap)
{
    for (const auto gap : {10ms, 10ms, 30ms, 30ms}) // 2 and 2 are missing
        after(gap);
    for (int i = 0; i < 3; ++i)
        after(100us);
    EXPECT_TRUE(stream.isHolding()) << "one is still missing";
    after(10ms);
    EXPECT_EQ(lost(), 1U);
    EXPECT_EQ(recorded(), sent);
}

} // namespace
} // namespace mb::dmc60c
