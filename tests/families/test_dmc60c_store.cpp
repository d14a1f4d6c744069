// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/dmc60ccontrollerfixture.h"

namespace mb::dmc60c {
namespace {

class Dmc60cFlash : public Dmc60cController {
protected:
    void change(std::string_view key, const std::string &id, int raw)
    {
        const std::string value = std::string("0") + static_cast<char>('0' + raw) + "000000";
        unit.answer("02061805#3412" + id, {{"02061845#" + id + "0000000000"}});
        unit.answer("02061885#3412" + id + value, {{"02061845#" + id + value + "00"}});
        EXPECT_TRUE(run(device->write(index(key), raw)));
    }
    Result<bool> store() { return run(device->store(progress)); }
    NoProgress progress;
};

TEST_F(Dmc60cFlash, HasNothingToProveWhenNothingWasWrittenForFifteenSeconds)
{
    clock.advance(17s);
    const auto asked = unit.heard().size();
    EXPECT_EQ(store(), Result<bool>(true));
    EXPECT_EQ(unit.heard().size(), asked);
}

TEST_F(Dmc60cFlash, WaitsForWhatAnotherProgramMayHaveWrittenJustBeforeItWasOpened)
{
    unit.answer(getSequence, {sequence(1)});
    const Instant begun = clock.now();
    EXPECT_EQ(store(), Result<bool>(true));
    EXPECT_GE(clock.now() - begun, 15s) << "whatever waited is written by then";
    EXPECT_LE(clock.now() - begun, 17s);
    const Instant again = clock.now();
    EXPECT_EQ(store(), Result<bool>(true));
    EXPECT_EQ(clock.now(), again) << "once";
}

TEST_F(Dmc60cFlash, IsProvedByTheFlashWriteOfAnotherProgramsChange)
{
    unit.answer(getSequence, {sequence(1)});
    clock.arm(clock.now() + 9s, [this] { unit.answer(getSequence, {sequence(2)}); });
    const Instant begun = clock.now();
    EXPECT_EQ(store(), Result<bool>(true));
    EXPECT_LE(clock.now() - begun, 10s);
}

TEST_F(Dmc60cFlash, FailsWhenTheDeviceRestartsWhileAnotherProgramsChangeMayWait)
{
    unit.answer(getSequence, {sequence(1)});
    clock.arm(clock.now() + 3s, [this] { unit.send("0206FCC5#07000000"); }); // V19
    const auto result = store();
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().fault, Fault::BadCheck);
}

TEST_F(Dmc60cFlash, ASilentDeviceIsNotTakenForOneThatHasRested)
{
    EXPECT_FALSE(store());
}

TEST_F(Dmc60cFlash, IsProvedByTheNumberAfterASingleChange)
{
    unit.answer(getSequence, {sequence(1), sequence(1), sequence(2)});
    change("slot0.p", "0A", 3);
    const Instant begun = clock.now();
    EXPECT_EQ(store(), Result<bool>(true));
    EXPECT_LT(clock.now() - begun, 1s);
    EXPECT_EQ(device->parameters().entry(index("slot0.p")).state, ParameterState::Stored);
}

TEST_F(Dmc60cFlash, IsNotProvedByTheFirstOfTwoFlashWrites)
{
    unit.answer(getSequence, {sequence(1), sequence(2)}); // the first change was written at once
    change("slot0.p", "0A", 3);
    change("slot0.i", "0B", 4);
    clock.arm(clock.now() + 15s, [this] { unit.answer(getSequence, {sequence(3)}); });
    const Instant begun = clock.now();
    EXPECT_EQ(store(), Result<bool>(true));
    EXPECT_GE(clock.now() - begun, 15s);
    EXPECT_LT(clock.now() - begun, 16s);
}

TEST_F(Dmc60cFlash, IsProvedByOneFlashWriteThatComesAfterTheRest)
{
    unit.answer(getSequence, {sequence(1)}); // somebody else had changed something: nothing is written at once
    change("slot0.p", "0A", 3);
    change("slot0.i", "0B", 4);
    clock.arm(clock.now() + 15s, [this] { unit.answer(getSequence, {sequence(2)}); });
    EXPECT_EQ(store(), Result<bool>(true));
}

TEST_F(Dmc60cFlash, FailsAfterTwentySecondsWithoutAFlashWrite)
{
    unit.answer(getSequence, {sequence(1)});
    change("slot0.p", "0A", 3);
    const Instant begun = clock.now();
    const auto result = store();
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().fault, Fault::BadCheck);
    EXPECT_GE(clock.now() - begun, 19s);
    EXPECT_LE(clock.now() - begun, 21s);
    EXPECT_EQ(device->parameters().entry(index("slot0.p")).state, ParameterState::Ram);
    const auto again = store();
    ASSERT_FALSE(again) << "asking once more proves nothing";
    EXPECT_EQ(again.error().text(), result.error().text());
    EXPECT_EQ(device->parameters().entry(index("slot0.p")).state, ParameterState::Ram);
    unit.answer(getSequence, {sequence(2)});
    EXPECT_EQ(store(), Result<bool>(true)) << "it was late";
}

TEST_F(Dmc60cFlash, ThatWasNotProvedIsByTheWriteOfTheNextChange)
{
    unit.answer(getSequence, {sequence(1)});
    change("slot0.p", "0A", 3);
    ASSERT_FALSE(store());
    unit.answer(getSequence, {sequence(1), sequence(2)});
    change("slot0.i", "0B", 4);
    EXPECT_EQ(store(), Result<bool>(true));
    EXPECT_EQ(device->parameters().entry(index("slot0.p")).state, ParameterState::Stored);
}

TEST_F(Dmc60cFlash, ThatWasNotProvedIsNotToldAgainAfterThePowerCycleThatItAskedFor)
{
    unit.answer(getSequence, {sequence(1)});
    change("slot0.p", "0A", 3);
    ASSERT_FALSE(store());
    unit.send("0206FCC5#07000000"); // V19
    clock.advance(1s);
    EXPECT_TRUE(store());
}

TEST_F(Dmc60cFlash, ThatWasNotProvedKeepsTheDeviceFromARestart)
{
    unit.answer(getSequence, {sequence(1)});
    change("slot0.p", "0A", 3);
    unit.answer(softReset, {{"0206FCC5#00000000"}});
    const auto restarted = run(device->restart());
    ASSERT_FALSE(restarted);
    EXPECT_EQ(restarted.error().fault, Fault::BadCheck);
    const auto heard = unit.heard();
    EXPECT_EQ(std::count(heard.begin(), heard.end(), softReset), 0);
}

TEST_F(Dmc60cFlash, ThatWasLostBeforeARestartOnOrderIsToldAfterIt)
{
    unit.answer(getSequence, {sequence(1)});
    change("slot0.p", "0A", 3);
    unit.send("0206FCC5#07000000"); // V19
    clock.advance(1s);
    unit.answer(softReset, {{"0206FCC5#07000000"}});
    unit.answer(getVersions, {versionsReply});
    unit.answer(getDescriptors, {mb::dmc60c::descriptors});
    EXPECT_TRUE(run(device->restart()));
    EXPECT_FALSE(store());
    EXPECT_TRUE(store()) << "once";
}

TEST_F(Dmc60cFlash, CannotProveWhereTheNumberIsNotSupported)
{
    unit.answer(getSequence, {{"0206FCC5#01000000"}});
    change("slot0.p", "0A", 3);
    EXPECT_EQ(store(), Result<bool>(false));
    EXPECT_EQ(store(), Result<bool>(false)) << "nor the second time";
}

TEST_F(Dmc60cFlash, FailsWhenTheDeviceRestartsBeforeTheProof)
{
    unit.answer(getSequence, {sequence(1)});
    change("slot0.p", "0A", 3);
    clock.arm(clock.now() + 3s, [this] { unit.send("0206FCC5#07000000"); }); // V19
    const auto result = store();
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().fault, Fault::BadCheck);
}

TEST(Dmc60cFlashProof, AChangeOfBeforeItWasListenedToMayWaitForFifteenSecondsAndASecondOfTolerance)
{
    for (const Duration more : {0ns, 1ns}) {
        FlashProof proof(Instant(0s));
        proof.ask(Instant(16s + more));
        EXPECT_EQ(proof.isPending(), more == 0ns);
    }
}

TEST(Dmc60cFlashProof, ADeviceThatRestartedWritesTheNextChangeAtOnceSoTheNextTwoWantTwoWrites)
{
    FlashProof proof(Instant(0s));
    proof.setBaseline(7);
    proof.changed(Instant(30s));
    proof.restarted();
    EXPECT_FALSE(proof.isPending());
    proof.setBaseline(7);
    proof.changed(Instant(31s));
    proof.changed(Instant(32s));
    EXPECT_FALSE(proof.isProvedBy(8, Instant(32s)));
    EXPECT_TRUE(proof.isProvedBy(9, Instant(48s)));
}

} // namespace
} // namespace mb::dmc60c
