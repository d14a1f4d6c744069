// SPDX-License-Identifier: GPL-3.0-or-later
// What the motion data of a QuadQuad2Drv become: whole positions of short counters, counts of lost samples, faults of each axis.
#include "families/quadquad2drv/axissense.h"
#include "families/quadquad2drv/channels.h"
#include "families/quadquad2drv/states.h"

#include <gtest/gtest.h>

namespace mb::quadquad2drv {
namespace {

using namespace std::chrono_literals;

class QuadQuad2DrvSense : public testing::Test {
protected:
    void take(const Motion &motion, std::uint8_t mask = datamask::everything)
    {
        sense.take(motion, {mask, mask, mask, mask}, Instant{time += 1ms}, states);
        telemetry->commit();
    }
    /// Axis 2 tells its position.
    std::int64_t positionAfter(std::int32_t told, std::uint8_t mask)
    {
        Motion motion;
        motion.channels[1].position = told;
        take(motion, mask);
        return sense.position(1).value_or(-1);
    }
    void status(std::size_t axis, std::uint8_t bits)
    {
        Motion motion;
        motion.channels[axis].status = bits;
        take(motion);
    }

    std::shared_ptr<Telemetry> telemetry = std::make_shared<Telemetry>(channelTable());
    AxisSense sense{telemetry};
    LiveStates states;
    Duration time{1s};
};

TEST_F(QuadQuad2DrvSense, ACounterOfEightOrSixteenBitsGoesOnWhereItWraps)
{
    for (const int bits : {8, 16}) {
        sense.forget();
        const std::uint8_t mask = bits == 8 ? 1 : 2;
        const std::int32_t half = 1 << (bits - 1);
        EXPECT_EQ(positionAfter(half - 1, mask), half - 1);
        EXPECT_EQ(positionAfter(-half, mask), half) << "one more";
        EXPECT_EQ(positionAfter(-half + 10, mask), half + 10);
        EXPECT_EQ(positionAfter(half - 1, mask), half - 1) << "and back";
        EXPECT_EQ(positionAfter(0, mask), 0);
        EXPECT_EQ(positionAfter(half - 1, mask), half - 1) << "the furthest forwards";
        EXPECT_EQ(positionAfter(-1, mask), -1) << "half a round is backwards";
        EXPECT_EQ(positionAfter(0, mask), 0);
        EXPECT_EQ(positionAfter(-half, mask), -half) << "the furthest backwards";
        EXPECT_EQ(positionAfter(0, mask), -2 * half) << "half a round";
        EXPECT_EQ(positionAfter(1, mask), -2 * half + 1);
    }
}

TEST_F(QuadQuad2DrvSense, ACounterOfThirtyTwoBitsIsWhatItSays)
{
    EXPECT_EQ(positionAfter(2147483647, 3), 2147483647);
    EXPECT_EQ(positionAfter(-2147483647 - 1, 3), -2147483648LL);
    EXPECT_EQ(positionAfter(5, 3), 5);
}

TEST_F(QuadQuad2DrvSense, RelativePositionsAddUpInWhateverWidth)
{
    EXPECT_EQ(positionAfter(-5, datamask::relative | 1), -5);
    EXPECT_EQ(positionAfter(127, datamask::relative | 1), 122);
    EXPECT_EQ(positionAfter(30000, datamask::relative | 2), 30122);
    EXPECT_EQ(positionAfter(30000, datamask::relative | 3), 60122);
}

TEST_F(QuadQuad2DrvSense, APlaceForATargetIsKnownOnlyWhileTheWholeCounterIsTold)
{
    for (const std::uint8_t less : std::initializer_list<std::uint8_t>{1, 2, 4 | 1, 4 | 2, 4 | 3}) {
        positionAfter(100, less);
        EXPECT_FALSE(sense.place(1)) << int{less};
        positionAfter(-20'000, 3);
        EXPECT_EQ(sense.place(1), -20'000);
        positionAfter(100, less);
        EXPECT_FALSE(sense.place(1)) << "another program made it tell less";
    }
    positionAfter(7, 3);
    EXPECT_FALSE(sense.place(0)) << "another axis";
    sense.forget();
    EXPECT_FALSE(sense.place(1));
}

TEST_F(QuadQuad2DrvSense, EachAxisAndEachChannelGetsItsOwnValue)
{
    Motion motion;
    for (std::size_t axis = 0; axis < axes; ++axis)
        motion.channels[axis] = {static_cast<std::int32_t>(100 + axis), static_cast<std::int32_t>(200 + axis),
            static_cast<std::uint8_t>(axis)};
    take(motion);
    for (int axis = 0; axis < axes; ++axis) {
        const auto latest = [&](AxisChannel which) { return telemetry->latest(channelOf(axis, which)); };
        EXPECT_EQ(latest(AxisChannel::Position)->value, 100 + axis);
        EXPECT_EQ(latest(AxisChannel::Velocity)->value, 200 + axis);
        EXPECT_EQ(latest(AxisChannel::Status)->value, axis);
        EXPECT_FALSE(latest(AxisChannel::SetPoint)) << "that is ours";
        EXPECT_EQ(sense.position(axis), 100 + axis);
    }
    sense.forget();
    EXPECT_FALSE(sense.position(0));
    take({});
    EXPECT_FALSE(sense.position(0)) << "nothing was told";
}

TEST_F(QuadQuad2DrvSense, PacketsThatTheBoardCouldNotSendAreLostSamplesOfAllThatItMeasures)
{
    Motion motion;
    take(motion);
    motion.elapsed = 0;
    take(motion);
    motion.elapsed = 3;
    take(motion);
    motion.elapsed = 1;
    take(motion);
    for (int axis = 0; axis < axes; ++axis) {
        for (const AxisChannel which : {AxisChannel::Position, AxisChannel::Velocity, AxisChannel::Status})
            EXPECT_EQ(telemetry->lost(channelOf(axis, which)), 4U) << axis;
        EXPECT_EQ(telemetry->lost(channelOf(axis, AxisChannel::SetPoint)), 0U);
    }
}

TEST_F(QuadQuad2DrvSense, AnAxisTurnsFasterThanTwiceTheResolutionOfItsVelocity)
{
    EXPECT_FALSE(sense.isTurning(2)) << "nothing was told";
    for (const auto &[speed, turning] :
        {std::pair{8, false}, std::pair{9, true}, std::pair{-8, false}, std::pair{-9, true}, std::pair{0, false}}) {
        Motion motion;
        motion.channels[2].velocity = speed;
        take(motion);
        EXPECT_EQ(sense.isTurning(2), turning) << speed;
        EXPECT_FALSE(sense.isTurning(1));
    }
}

TEST_F(QuadQuad2DrvSense, FaultsAreThoseOfTheAxisThatToldThem)
{
    using Keys = std::vector<std::string>;
    status(0, status::overspeed);
    EXPECT_EQ(sense.faults(), Keys{"ch1.overspeed"});
    status(0, 0);
    EXPECT_EQ(sense.faults(), Keys{});
    status(1, status::glitch);
    EXPECT_EQ(sense.faults(), Keys{"ch2.glitch"});
    status(3, status::overspeed | status::glitch);
    EXPECT_EQ(sense.faults(), (Keys{"ch2.glitch", "ch4.glitch", "ch4.overspeed"}));
    status(1, status::positiveEdge | status::negativeEdge | status::inputWasActive | status::inputActive);
    EXPECT_EQ(sense.faults(), (Keys{"ch4.glitch", "ch4.overspeed"}));
    const auto records = sense.records();
    ASSERT_EQ(records.size(), 8U);
    for (const FaultRecord &record : records) {
        EXPECT_EQ(record.active, record.key.starts_with("ch4.")) << record.key;
        EXPECT_FALSE(record.sticky);
        EXPECT_FALSE(record.count);
    }
}

TEST_F(QuadQuad2DrvSense, AnInputIsOnWhileItIsActiveOrWasSinceTheLastLook)
{
    for (const auto &[bits, on] : {std::pair{status::inputActive, true}, std::pair{status::inputWasActive, true},
             std::pair{static_cast<std::uint8_t>(status::positiveEdge | status::negativeEdge), false},
             std::pair{static_cast<std::uint8_t>(status::overspeed | status::glitch), false}}) {
        states = {};
        status(2, bits);
        EXPECT_EQ(states[StateIndex{2}], on) << static_cast<int>(bits);
        EXPECT_FALSE(states[StateIndex{1}]) << "nothing was told of it";
    }
}

} // namespace
} // namespace mb::quadquad2drv
