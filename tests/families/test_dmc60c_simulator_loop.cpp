// SPDX-License-Identifier: GPL-3.0-or-later
// The arithmetic of the simulated DMC60C's 500 µs loop.
#include "families/dmc60c/simulatorloop.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mb::test {
namespace {

using namespace dmc60c;

TEST(Dmc60cPid, IntegerArithmeticFollowsTheGainsPerLoop)
{
    using namespace simulation;
    const auto fixed = [](double value) { return static_cast<std::int32_t>(std::lround(value * 65536.0)); };
    const Gains gains{fixed(2.0), fixed(0.5), fixed(10.0), 0, fixed(0.25)};
    Pid pid;
    EXPECT_EQ(pid.step(gains, 100, 0, 0, 0), 200 + 50 + 0 + 25); // no derivative on the first pass
    EXPECT_EQ(pid.step(gains, 100, 40, 0, 0), 120 + 80 - 400 + 25);
    Gains bounded = gains;
    bounded.iZone = 150;
    pid.reset();
    for (int i = 0; i < 10; ++i)
        (void)pid.step(bounded, 100, 0, 0, 0);
    EXPECT_EQ(pid.step(bounded, 100, 0, 0, 0), 200 + 75 + 25);
    EXPECT_EQ(pid.step(bounded, 100, 95, 10, 0), 25); // within the allowable error: only the feed-forward is left
    EXPECT_EQ(pid.step(bounded, 100, 0, 10, 0), 200 + 50 + 950 + 25);
    const Gains amperes{fixed(100.0), 0, 0, 0, 0x03332CCC};
    pid.reset();
    EXPECT_EQ(pid.step(amperes, 20 << 16, 20 << 16, 0, 16), 16383); // 0.5·32767, the datasheet's example
    const Gains wild{2147483647, 2147483647, 2147483647, 0, 2147483647};
    pid.reset();
    for (int i = 0; i < 5; ++i)
        EXPECT_GT(pid.step(wild, 8388607, -2147483647, 0, 0), 32767);
}

TEST(Dmc60cPid, SlotShapesItsOutput)
{
    using namespace simulation;
    Slot slot;
    slot.forwardNominal = 1000;
    slot.reverseNominal = -800;
    slot.forwardMax = 20000;
    slot.reverseMax = -10000;
    EXPECT_EQ(shaped(slot, 5, 0, true), 1000);
    EXPECT_EQ(shaped(slot, 5, 0, false), 5);
    EXPECT_EQ(shaped(slot, -5, 0, true), -800);
    EXPECT_EQ(shaped(slot, 0, 0, true), 0);
    EXPECT_EQ(shaped(slot, 99999, 0, true), 20000);
    EXPECT_EQ(shaped(slot, -99999, 0, true), -10000);
    slot.ramp = 16;
    EXPECT_EQ(shaped(slot, 20000, 100, true), 116);
    EXPECT_EQ(shaped(slot, -20000, 100, true), 84);
}

} // namespace
} // namespace mb::test
