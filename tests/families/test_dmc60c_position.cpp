// SPDX-License-Identifier: GPL-3.0-or-later
// The live position is written only while the output is off: a loop that is closed would leap.
#include "families/dmc60ccontrollerfixture.h"

namespace mb::dmc60c {
namespace {

const std::string setPosition = "02061885#34122900000000";

class Dmc60cPosition : public Dmc60cController {
protected:
    Dmc60cPosition() { unit.answer(setPosition, {{"02061845#290000000000"}}); }
    Result<std::int64_t> write() { return run(device->write(index("encoder.position"), 0)); }
};

TEST_F(Dmc60cPosition, IsNotWrittenWhileALoopHoldsItWithoutOutput)
{
    unit.every(10ms, "02061405#0000001000000000"); // position mode, duty 0
    clock.advance(50ms);
    const auto refused = write();
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().fault, Fault::Unsafe);
    EXPECT_EQ(unit.count(setPosition), 0) << "the loop would leap";
    unit.endPeriodic();
    unit.every(10ms, resting);
    clock.advance(50ms);
    EXPECT_TRUE(write());
}

TEST_F(Dmc60cPosition, IsNotWrittenRightBehindASetPoint)
{
    unit.every(10ms, resting);
    clock.advance(50ms);
    ASSERT_TRUE(command(Mode::Duty, 0.1));
    EXPECT_EQ(write().error().fault, Fault::Unsafe) << "no frame has told of it yet";
    EXPECT_EQ(unit.count(setPosition), 0);
    clock.advance(200ms);
    EXPECT_TRUE(write()) << "it is halted again";
}

TEST_F(Dmc60cPosition, CountsFromAnotherPlaceOnceItIsWritten)
{
    unit.every(10ms, resting);
    clock.advance(50ms);
    const auto origin = device->gate().origin();
    ASSERT_TRUE(command(Mode::Duty, 0.1));
    ASSERT_FALSE(write());
    EXPECT_EQ(device->gate().origin(), origin);
    clock.advance(200ms);
    ASSERT_TRUE(write());
    EXPECT_NE(device->gate().origin(), origin);
}

TEST_F(Dmc60cPosition, IsWrittenRightBehindAStop)
{
    unit.every(10ms, resting);
    clock.advance(50ms);
    ASSERT_TRUE(command(Mode::Duty, 0.1));
    device->stop();
    clock.advance(30ms);
    EXPECT_TRUE(write());
}

} // namespace
} // namespace mb::dmc60c
