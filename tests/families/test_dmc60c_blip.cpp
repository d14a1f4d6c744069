// SPDX-License-Identifier: GPL-3.0-or-later
// A supply that is gone for so short a time that no status frame seems to be missing.
#include "families/dmc60ccontrollerfixture.h"
#include "model/setpointstream.h"

namespace mb::dmc60c {
namespace {

const FakeUnit::Frames renewed{"0206F005#CDAB03012060", "0206F005#CDAB000017010901"};

TEST_F(Dmc60cController, AUnitThatDoesNotAnswerTheOldSessionAnyMoreIsFoundAlthoughNoFrameIsMissing)
{
    unit.every(10ms, resting);
    unit.answer(enumeration, {renewed}, 5ms);
    clock.advance(1500ms);
    EXPECT_EQ(device->identity().session, 0xABCD);
    EXPECT_TRUE(device->liveness().restarted);
}

TEST_F(Dmc60cController, AnotherSessionEndsTheMotionBeforeItIsJudged)
{
    unit.every(10ms, resting);
    clock.advance(50ms);
    SetPointStream stream(*device, clock);
    ASSERT_TRUE(stream.start(setPoint(Mode::Position, 100000.0), 60s));
    clock.advance(100ms);
    ASSERT_TRUE(stream.isRunning());
    unit.send(renewed.front());
    clock.advance(25ms);
    EXPECT_FALSE(stream.isRunning());
    EXPECT_EQ(device->identity().session, 0x1234) << "not judged yet";
    EXPECT_EQ(command(Mode::Position, 100000.0).error().fault, Fault::Unsafe);
}

TEST_F(Dmc60cController, ASecondUnitThatWasHeardOnceLocksNothingOnceItWasJudged)
{
    unit.every(10ms, resting);
    unit.answer(enumeration, {{"0206F005#341203012060", "0206F005#3412000017010901"}}, 5ms);
    clock.advance(50ms);
    EXPECT_TRUE(command(Mode::Duty, 0.1));
    unit.send("0206F005#341203012060");
    clock.advance(5ms);
    EXPECT_TRUE(command(Mode::Duty, 0.1)) << "its own session";
}

TEST_F(Dmc60cController, ARestartWhoseAnswerIsLostCountsAsOneAndIsTold)
{
    unit.every(10ms, resting);
    unit.answer(getVersions, {versionsReply});
    unit.answer(getDescriptors, {descriptors});
    unit.answer("02061805#34123D", {{"02061845#3D0000280000"}});
    ASSERT_TRUE(run(device->read(index("current_limit.continuous"))));
    const auto ended = run(device->restart());
    ASSERT_FALSE(ended);
    EXPECT_EQ(ended.error().fault, Fault::Timeout);
    EXPECT_NE(ended.error().text().find("may have done so"), std::string::npos) << ended.error().text();
    EXPECT_EQ(device->parameters().entry(index("current_limit.continuous")).state, ParameterState::Unknown);
    EXPECT_FALSE(device->liveness().restarted) << "it was looked at again";
}

TEST_F(Dmc60cController, AUnitThatIsSilentAfterItsRestartDidNotComeBack)
{
    unit.every(10ms, resting);
    clock.advance(50ms);
    const auto ended = run(device->restart());
    ASSERT_FALSE(ended);
    EXPECT_NE(ended.error().text().find("did not come back"), std::string::npos) << ended.error().text();
}

} // namespace
} // namespace mb::dmc60c
