// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/dmc60ccontrollerfixture.h"
#include "model/parametertransfer.h"

namespace mb::dmc60c {
namespace {

TEST_F(Dmc60cController, ReadsAParameter)
{
    unit.answer("02061805#34123D", {{"02061845#3D0000280000"}}); // P2
    EXPECT_EQ(*run(device->read(index("current_limit.continuous"))), 40 * 65536);
    EXPECT_EQ(unit.heard().size(), 1U);
}

TEST_F(Dmc60cController, TakesOnlyTheAnswerOfItsDeviceAndParameter)
{
    unit.answer("02061805#34123D",
        {{"02061846#3D0000010000", "02061845#3E0000020000", "02061845#3D00002800", "02061845#3D0000280000"}});
    EXPECT_EQ(*run(device->read(index("current_limit.continuous"))), 40 * 65536);
}

TEST_F(Dmc60cController, AsksEightTimesAndThenSaysTimeout)
{
    const auto result = run(device->read(index("slot0.p")));
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().fault, Fault::Timeout);
    EXPECT_NE(result.error().text().find("slot0.p"), std::string::npos);
    EXPECT_EQ(unit.count("02061805#34120A"), 8);
    EXPECT_EQ(device->parameters().entry(index("slot0.p")).state, ParameterState::Failed);
}

TEST_F(Dmc60cController, WaitsByTheMeasuredRoundTripOnceItKnowsIt)
{
    unit.answer("02061805#34123D", {{"02061845#3D0000280000"}});
    (void)run(device->read(index("current_limit.continuous")));
    unit.answer("02061805#34120A", {{}, {}, {"02061845#0A0000000000"}});
    const Instant begun = clock.now();
    EXPECT_TRUE(run(device->read(index("slot0.p"))));
    EXPECT_LT(clock.now() - begun, 20ms) << "5 ms, 10 ms, and the answer";
    EXPECT_EQ(unit.count("02061805#34120A"), 3);
}

TEST_F(Dmc60cController, ReportsWhatTheDeviceObjectsTo)
{
    unit.answer("02061805#34125D", {{"02061845#5D0000000001"}});
    const auto unknown = run(device->read(index("status.general.period")));
    ASSERT_FALSE(unknown);
    EXPECT_EQ(unknown.error().fault, Fault::Refused);
    unit.answer("02061885#34125D32000000", {{"02061845#5D0000000002"}}); // P14
    const auto refused = run(device->write(index("status.general.period"), 50));
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().fault, Fault::Refused);
}

TEST_F(Dmc60cController, ThePositionIsWrittenOnlyToAShaftThatStandsWithItsOutputOff)
{
    const ParameterIndex position = *findParameter(device->parameters().table(), "encoder.position");
    const auto asked = [this, position] {
        const std::size_t before = unit.heard().size();
        const auto written = run(device->write(position, 5));
        EXPECT_FALSE(written) << "nobody answers";
        return std::pair(written.error().fault, unit.heard().size() > before);
    };
    unit.every(10ms, resting);
    clock.advance(50ms);
    EXPECT_EQ(asked(), std::pair(Fault::Timeout, true));
    unit.endPeriodic();
    unit.every(10ms, drivingHalf);
    clock.advance(50ms);
    EXPECT_EQ(asked(), std::pair(Fault::Unsafe, false));
    unit.endPeriodic();
    clock.advance(1s); // it is not heard any more; nobody knows that its output went off
    EXPECT_EQ(asked().first, Fault::Unsafe);
    unit.every(10ms, resting);
    unit.every(10ms, "02061485#01E240FED4000014"); // S8: it turns all the same
    clock.advance(50ms);
    EXPECT_EQ(asked(), std::pair(Fault::Unsafe, false));
}

TEST_F(Dmc60cController, ReadsSignedValues)
{
    unit.answer("02061805#341214", {{"02061845#14FFFFFFFF00"}}); // P23
    EXPECT_EQ(*run(device->read(index("slot0.nominal_reverse"))), -1);
}

TEST_F(Dmc60cController, WritesAParameterAfterNotingTheFlashNumber)
{
    unit.answer("02061805#34123D", {{"02061845#3D0000140000"}}); // 20 A so far
    unit.answer(getSequence, {sequence(1)});
    unit.answer("02061885#34123D00002800", {{"02061845#3D0000280000"}}); // P3
    EXPECT_EQ(*run(device->write(index("current_limit.continuous"), 40 * 65536)), 40 * 65536);
    EXPECT_EQ(device->parameters().entry(index("current_limit.continuous")).state, ParameterState::Ram);
    EXPECT_EQ(unit.heard(), (FakeUnit::Frames{"02061805#34123D", getSequence, "02061885#34123D00002800"}));
}

TEST_F(Dmc60cController, DoesNotWriteWhatIsAlreadyInForce)
{
    unit.answer("02061805#34123D", {{"02061845#3D0000280000"}});
    EXPECT_EQ(*run(device->write(index("current_limit.continuous"), 40 * 65536)), 40 * 65536);
    EXPECT_EQ(unit.heard().size(), 1U);
}

TEST_F(Dmc60cController, YieldsTheCountFromBeforeAClear)
{
    unit.answer("02061805#341234", {{"02061845#340500000000"}});
    unit.answer("02061885#34123401000000", {{"02061845#340500000000"}}); // P17, P18
    EXPECT_EQ(*run(device->write(index("faults.sticky"), 1)), 5);
    EXPECT_EQ(unit.count("02061885#34123401000000"), 1);
}

TEST_F(Dmc60cController, DoesNotLoseTheCountWhenTheAnswerToAClearIsLost)
{
    unit.answer("02061805#341235", {{"02061845#350700000000"}, {"02061845#350000000000"}});
    EXPECT_EQ(*run(device->write(index("faults.over_current.count"), 1)), 7);
    EXPECT_EQ(unit.count("02061885#34123501000000"), 1) << "a second clear would answer 0";
}

TEST_F(Dmc60cController, RepeatsAClearOnlyWhenAReadingShowsThatItDidNotArrive)
{
    unit.answer("02061805#341235", {{"02061845#350700000000"}, {"02061845#350700000000"}, {"02061845#350000000000"}});
    unit.answer("02061885#34123501000000", {{}, {"02061845#350700000000"}});
    EXPECT_EQ(*run(device->write(index("faults.over_current.count"), 1)), 7);
    EXPECT_EQ(unit.count("02061885#34123501000000"), 2);
}

TEST_F(Dmc60cController, AnAnswerToAnotherQuestionDoesNotPassForThatToAClear)
{
    unit.answer("02061805#341235", {{"02061845#350700000000"}, {"02061845#350700000000"}, {"02061845#350000000000"}});
    auto clearing = device->write(index("faults.over_current.count"), 1);
    clearing.start();
    ASSERT_TRUE(clock.runUntil([&] { return unit.count("02061885#34123501000000") == 1; }, 1s));
    unit.send("02061845#350700000000"); // to whoever looks at the faults; the clear is lost
    ASSERT_TRUE(clock.runUntil([&] { return clearing.isFinished(); }, 10s));
    ASSERT_TRUE(clearing.result()) << clearing.result().error().text();
    EXPECT_EQ(*clearing.result(), 7);
    EXPECT_EQ(unit.count("02061885#34123501000000"), 2);
}

TEST_F(Dmc60cController, SaysTimeoutWhenAClearCannotBeConfirmed)
{
    unit.answer("02061805#341235", {{"02061845#350700000000"}});
    const auto result = run(device->write(index("faults.over_current.count"), 1));
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().fault, Fault::Timeout);
    EXPECT_NE(result.error().text().find('7'), std::string::npos) << "the count is not lost";
}

TEST_F(Dmc60cController, ReadsCountersThroughAWriteOfZeroWhereTheyCannotBeRequested)
{
    unit.answer("02061805#341235", {{"02061845#350000000001"}});
    unit.answer("02061885#34123500000000", {{"02061845#350300000000"}});
    EXPECT_EQ(*run(device->read(index("faults.over_current.count"))), 3);
}

TEST_F(Dmc60cController, WritesThePositionOnlyWhileTheOutputIsOff)
{
    unit.answer("02061885#34122900000000", {{"02061845#290000000000"}});
    unit.send(drivingHalf);
    clock.advance(5ms);
    const auto refused = run(device->write(index("encoder.position"), 0));
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().fault, Fault::Unsafe);
    unit.send(resting);
    clock.advance(5ms);
    EXPECT_TRUE(run(device->write(index("encoder.position"), 0)));
}

TEST_F(Dmc60cController, GathersFaultsWithTheirCounts)
{
    unit.answer("02061805#341233", {{"02061845#330400000000"}});
    unit.answer("02061805#341234", {{"02061845#340500000000"}});
    unit.answer("02061805#341235", {{"02061845#350200000000"}});
    for (const auto *const number : {"36", "37", "38", "39"})
        unit.answer(std::string("02061805#3412") + number, {{std::string("02061845#") + number + "0000000000"}});
    const auto faults = run(device->readFaults());
    ASSERT_TRUE(faults) << faults.error().text();
    ASSERT_EQ(faults->size(), 5U);
    EXPECT_EQ(faults->at(0).key, "over_current");
    EXPECT_TRUE(!faults->at(0).active && faults->at(0).sticky);
    EXPECT_EQ(faults->at(0).count, 2);
    EXPECT_EQ(faults->at(2).key, "under_voltage");
    EXPECT_TRUE(faults->at(2).active && faults->at(2).sticky);
    EXPECT_EQ(faults->at(4).key, "communication");
}

TEST_F(Dmc60cController, LeavesNoTimerAndNoListenerWhenATaskIsCancelledAnywhere)
{
    unit.answer(getVersions, {versionsReply});
    unit.answer(getDescriptors, {descriptors});
    unit.answer("02061805#34123D", {{"02061845#3D0000140000"}});
    unit.answer(getSequence, {sequence(1)});
    unit.answer("02061885#34123D00002800", {{"02061845#3D0000280000"}});
    clock.advance(1s);
    const std::size_t armed = clock.armed();
    const std::size_t listening = host.received().size();
    for (int steps = 0; steps < 60; ++steps) {
        {
            auto refresh = device->refresh();
            refresh.start();
            auto write = device->write(index("current_limit.continuous"), 40 * 65536);
            for (int i = 0; i < steps && !refresh.isFinished(); ++i)
                clock.step();
            refresh.cancel();
            write.start();
            for (int i = 0; i < steps && !write.isFinished(); ++i)
                clock.step();
        }
        EXPECT_EQ(host.received().size(), listening) << steps;
        clock.advance(1100ms); // never at an enumeration, every 2 s
        EXPECT_EQ(clock.armed(), armed) << steps;
    }
    device.reset();
    EXPECT_EQ(host.received().size(), 0U);
    clock.advance(1s);
    EXPECT_EQ(clock.armed(), 0U);
}

/// Over a link that is held up now and then, an answer to an earlier question comes while the next one is asked.
TEST_F(Dmc60cController, AValueThatReadsBackOldIsReadAgainBeforeItIsCalledWrong)
{
    const std::string get = "02061805#34120A";
    const std::string written = "02061845#0A0300000000";
    unit.answer(get, {{"02061845#0A0000000000"}});
    unit.answer("02061885#34120A03000000", {{written}});
    NoProgress progress;
    const auto wrong = run(writeParameters(*device, {{index("slot0.p"), 3}}, progress));
    ASSERT_TRUE(wrong);
    EXPECT_EQ(wrong->front().raw.error().fault, Fault::BadCheck);
    clock.arm(clock.now() + 100ms, [&] { unit.answer(get, {{written}}); });
    const auto late = run(writeParameters(*device, {{index("slot0.p"), 3}}, progress));
    ASSERT_TRUE(late);
    EXPECT_EQ(late->front().raw, Result<std::int64_t>(3));
    EXPECT_EQ(late->front().verified, true);
}

} // namespace
TEST_F(Dmc60cController, APositionThatIsWrittenWhenItsDeviceGoesEndsWithNothing)
{
    auto writing = device->write(index("encoder.position"), 5);
    writing.start();
    clock.advance(1ms);
    ASSERT_FALSE(writing.isFinished());
    device.reset();
    writing.cancel();
    EXPECT_FALSE(writing.isValid());
}

} // namespace mb::dmc60c
