// SPDX-License-Identifier: GPL-3.0-or-later
// What is concluded from the counters of a DMC60C: hidden faults, and whether its flash holds what was written.
#include "families/dmc60c/faultwatch.h"
#include "families/dmc60c/flashproof.h"
#include "families/dmc60c/statussense.h"
#include "model/family.h"

#include <gtest/gtest.h>

namespace mb::dmc60c {
extern const Family family;

namespace {

using namespace std::chrono_literals;

constexpr Instant watchBegin{100s};

// Its shaft

TEST(Dmc60cStatusSense, ACountOfFlickerIsNoMotion)
{
    StatusSense sense(std::make_shared<Telemetry>(family.channels));
    auto turns = [&sense, now = watchBegin](std::int32_t velocity) mutable {
        StatusEncoder status;
        status.velocity = velocity;
        sense.take(status, now += 100ms, true);
        return sense.isTurning(now);
    };
    for (const std::int32_t still : {0, 1, 0, -1, 1})
        EXPECT_FALSE(turns(still)) << still;
    EXPECT_TRUE(turns(2));
    EXPECT_FALSE(turns(1));
    EXPECT_TRUE(turns(-2));
}

// dmc60c/README.md#hidden-faults

class Dmc60cFaultWatch : public testing::Test {
protected:
    void tell(
        std::uint8_t parameter, std::uint32_t value, Duration at, ParameterStatus status = ParameterStatus::NoError)
    {
        watch.take({5, parameter, value, status}, watchBegin + at);
    }
    [[nodiscard]] std::uint32_t present(Duration at) const { return watch.present(watchBegin + at); }
    FaultWatch watch;
};

TEST_F(Dmc60cFaultWatch, IsDueAtOnceAndThenEverySecond)
{
    EXPECT_TRUE(watch.isDue(watchBegin));
    EXPECT_FALSE(watch.isDue(watchBegin));
    EXPECT_FALSE(watch.isDue(watchBegin + 1s - 1ns));
    EXPECT_TRUE(watch.isDue(watchBegin + 1s));
    EXPECT_FALSE(watch.isDue(watchBegin + 1s + 999ms));
    watch.forget();
    EXPECT_TRUE(watch.isDue(watchBegin + 1500ms)) << "of a device that was silent nothing is known";
}

TEST_F(Dmc60cFaultWatch, WhatIsPresentIsToldAsLongAsTheDeviceSaysSo)
{
    tell(param::activeFaults, faultbit::overCurrent | faultbit::overTemperature | faultbit::communication, 0s);
    EXPECT_EQ(present(1h), faultbit::overCurrent | faultbit::communication) << "the others are in the status frames";
    tell(param::activeFaults, faultbit::communication, 1h);
    EXPECT_EQ(present(1h), faultbit::communication);
    tell(param::activeFaults, 0, 1h);
    EXPECT_EQ(present(1h), 0U);
}

TEST_F(Dmc60cFaultWatch, ACounterThatRoseIsAFaultForThreeSecondsAndOneThatStaysOrFallsIsNone)
{
    struct Row {
        std::uint8_t counter;
        std::uint32_t bit;
    };
    for (const Row &row : {Row{param::overCurrentCount, faultbit::overCurrent},
             Row{param::communicationCount, faultbit::communication}}) {
        watch.forget();
        tell(row.counter, 7, 0s);
        EXPECT_EQ(present(0s), 0U) << "from before anybody looked";
        tell(row.counter, 7, 1s);
        EXPECT_EQ(present(1s), 0U);
        tell(row.counter, 8, 2s);
        EXPECT_EQ(present(2s), row.bit);
        EXPECT_EQ(present(5s - 1ns), row.bit);
        EXPECT_EQ(present(5s), 0U);
        tell(row.counter, 0, 6s);
        EXPECT_EQ(present(6s), 0U) << "cleared";
        tell(row.counter, 1, 7s);
        EXPECT_EQ(present(7s), row.bit);
    }
}

TEST_F(Dmc60cFaultWatch, AnAnswerThatIsNoneAndAnotherParameterChangeNothing)
{
    tell(param::overCurrentCount, 1, 0s);
    tell(param::overCurrentCount, 9, 1s, static_cast<ParameterStatus>(1));
    tell(param::activeFaults, 0xFF, 1s, static_cast<ParameterStatus>(1));
    tell(param::stickyFaults, 0xFF, 1s);
    tell(param::encoderPosition, 0xFF, 1s);
    EXPECT_EQ(present(1s), 0U);
}

// The flash write behind a change: 15 s after the last one, or at once after a rest

class Dmc60cFlashWrites : public testing::Test {
protected:
    void change(Duration at) { proof.changed(watchBegin + at); }
    bool isProved(std::uint32_t sequence, Duration at) { return proof.isProvedBy(sequence, watchBegin + at); }
    FlashProof proof{Instant{}};
};

TEST_F(Dmc60cFlashWrites, OneChangeAfterARestIsProvedByOneFlashWrite)
{
    EXPECT_FALSE(proof.isPending());
    EXPECT_TRUE(proof.wantsBaseline());
    proof.setBaseline(10);
    change(0s);
    EXPECT_TRUE(proof.isPending());
    EXPECT_FALSE(proof.wantsBaseline());
    EXPECT_EQ(proof.deadline(), watchBegin + 20s);
    EXPECT_FALSE(isProved(10, 100ms));
    EXPECT_FALSE(proof.hasAdvanced(10));
    EXPECT_TRUE(isProved(11, 200ms));
    EXPECT_TRUE(proof.hasAdvanced(11));
    proof.settle();
    EXPECT_FALSE(proof.isPending());
    EXPECT_FALSE(proof.hasAdvanced(11));
}

TEST_F(Dmc60cFlashWrites, ChangesInARowAreProvedByTheWriteAtOnceAndTheOneAfterTheRest)
{
    proof.setBaseline(10);
    for (const auto at : {0s, 1s, 2s, 3s})
        change(at);
    EXPECT_FALSE(isProved(11, 3500ms)) << "the first change alone";
    EXPECT_TRUE(isProved(12, 18s));
    EXPECT_EQ(proof.deadline(), watchBegin + 23s);
}

TEST_F(Dmc60cFlashWrites, FourteenSecondsAreNoRestForSure)
{
    proof.setBaseline(10);
    for (const Duration at : {Duration(0s), Duration(14s), Duration(15s)})
        change(at);
    EXPECT_TRUE(isProved(12, 15500ms)) << "the third belongs to the write that is put off";
    proof.settle();
    proof.restarted();
    proof.setBaseline(10);
    for (const Duration at : {1000s + 0ns, 1014s + 1ns, 1015s + 0ns})
        change(at);
    EXPECT_FALSE(isProved(12, 1015500ms)) << "two writes at once, and one is put off";
    EXPECT_TRUE(isProved(13, 1015500ms));
}

TEST_F(Dmc60cFlashWrites, WithoutABaselineANumberBetweenOneAndFourteenSecondsServes)
{
    struct Row {
        Duration age;
        bool serves;
    };
    for (const Row &row :
        {Row{1s - 1ns, false}, Row{1s, true}, Row{14s, true}, Row{14s + 1ns, false}, Row{20s, false}}) {
        proof.restarted();
        proof.setBaseline(std::nullopt);
        change(0s);
        EXPECT_FALSE(isProved(5, row.age)) << row.age.count();
        EXPECT_FALSE(isProved(5, 21s)) << "the same";
        EXPECT_EQ(isProved(6, 21s), row.serves) << row.age.count();
        EXPECT_FALSE(proof.hasAdvanced(6)) << "nobody knows from what";
    }
}

TEST_F(Dmc60cFlashWrites, AChangeTakesBackWhatWasReadBeforeIt)
{
    proof.setBaseline(std::nullopt);
    change(0s);
    EXPECT_FALSE(isProved(5, 2s));
    change(3s);
    EXPECT_FALSE(isProved(6, 3500ms)) << "that may be of the first change";
}

TEST_F(Dmc60cFlashWrites, AfterARestartTheNextChangeIsWrittenAtOnceAndOtherwisePutOff)
{
    proof.setBaseline(10);
    change(0s);
    proof.settle();
    proof.setBaseline(11);
    change(1s);
    change(2s);
    EXPECT_TRUE(isProved(12, 17s)) << "both are put off";
    proof.restarted();
    EXPECT_FALSE(proof.isPending());
    proof.setBaseline(20);
    change(3s);
    change(4s);
    EXPECT_FALSE(isProved(21, 5s));
    EXPECT_TRUE(isProved(22, 19s));
}

} // namespace
} // namespace mb::dmc60c
