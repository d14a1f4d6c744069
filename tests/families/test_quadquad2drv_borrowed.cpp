// SPDX-License-Identifier: GPL-3.0-or-later
// What an experiment changes for a while is in doubt until the board has it back, and a reset meanwhile ends that.
#include "quadquad2drvboard.h"

#include "families/quadquad2drv/parameters.h"
#include "model/parametertransfer.h"

namespace mb::quadquad2drv {
namespace {

constexpr std::array<std::pair<AxisParameter, std::int64_t>, 4> borrowedSettings{
    {{AxisParameter::LimitPower, 8191}, {AxisParameter::VelocityP, 50}, {AxisParameter::LimitVelocity, 500 * limitOne},
        {AxisParameter::InputMode, static_cast<int>(InputMode::Index)}}};

struct QuadQuad2DrvBorrowed : testing::Test {
    void SetUp() override
    {
        for (const auto &[which, raw] : borrowedSettings)
            ASSERT_TRUE(run(bench.clock, bench.device->write(indexOf(0, which), raw)));
        ASSERT_TRUE(run(bench.clock, bench.device->write(indexOf(BoardParameter::HistoryLength), 20)));
        ASSERT_TRUE(run(bench.clock, bench.device->write(indexOf(1, AxisParameter::VelocityP), 60)));
    }
    [[nodiscard]] std::size_t lost() const { return bench.device->knowledge().profile().lost.size(); }
    [[nodiscard]] auto raw(AxisParameter which, int axis = 0) const
    {
        return bench.device->parameters().entry(indexOf(axis, which)).raw;
    }
    /// 20 s after now.
    void later(const std::function<void()> &what) { m_later.startIn(20s, what); }
    void expectAllBack() const
    {
        EXPECT_EQ(lost(), 0U);
        for (const auto &[which, value] : borrowedSettings)
            EXPECT_EQ(raw(which), value) << static_cast<int>(which);
    }
    Board bench{"quadquad2drv:0"};
    Operation operation{bench.clock, say("scales")};

private:
    Timer m_later{bench.clock};
};

TEST_F(QuadQuad2DrvBorrowed, WhatTheSearchChangesIsInDoubtWhileItRunsAndKnownAgainAfterwards)
{
    std::size_t meanwhile = 0;
    later([&] {
        meanwhile = lost();
        EXPECT_FALSE(raw(AxisParameter::LimitVelocity)) << "it has none at present";
        EXPECT_FALSE(raw(AxisParameter::VelocityP));
        EXPECT_EQ(raw(AxisParameter::VelocityP, 1), 60) << "another axis is not touched";
    });
    const auto found = bench.find(withPower(0.25), operation);
    ASSERT_TRUE(found) << found.error().text();
    EXPECT_GE(meanwhile, 4U) << "a program that dies now leaves them lost, to be written again";
    expectAllBack();
    EXPECT_EQ(bench.device->parameters().entry(indexOf(BoardParameter::HistoryLength)).raw, 20);
}

TEST_F(QuadQuad2DrvBorrowed, ASearchThatIsCancelledGivesBackTheSame)
{
    later([this] { operation.cancel(); });
    EXPECT_FALSE(bench.find(withPower(0.25), operation));
    bench.clock.advance(1s);
    expectAllBack();
}

TEST_F(QuadQuad2DrvBorrowed, WhatALinkThatIsGoneCouldNotGiveBackStaysLost)
{
    later([this] { bench.link->close(); });
    EXPECT_FALSE(bench.find(withPower(0.25), operation));
    bench.clock.advance(1s);
    EXPECT_GE(lost(), 4U);
    EXPECT_FALSE(raw(AxisParameter::LimitVelocity));
}

TEST_F(QuadQuad2DrvBorrowed, NothingIsPutBackOnABoardThatWasResetMeanwhile)
{
    later([this] {
        bench.board().setPowered(false);
        bench.board().setPowered(true);
        bench.sent.clear();
    });
    EXPECT_FALSE(bench.find(withPower(0.25), operation));
    bench.clock.advance(1s);
    EXPECT_FALSE(bench.hasSent(setPowerLimit(1, 8191)));
    EXPECT_FALSE(raw(AxisParameter::LimitPower)) << "unknown until written";
    EXPECT_EQ(lost(), 6U);
    ASSERT_TRUE(run(bench.clock, bench.device->refresh()));
    SetPoint setPoint;
    setPoint.mode = Mode::Duty;
    setPoint.target = 1.0;
    ASSERT_TRUE(bench.stream().start(setPoint, 1s));
    bench.clock.advance(500ms);
    EXPECT_TRUE(bench.hasSent(setPowerLimit(1, 2048))) << "the first motion is limited again";
}

TEST_F(QuadQuad2DrvBorrowed, AnInputIsInDoubtWhileBothPolaritiesAreTried)
{
    std::optional<Result<ExperimentReport>> end;
    operation.run<ExperimentReport>(findInputReading(*bench.device, bench.stream(), withPower(0.0), operation),
        [&end](Result<ExperimentReport> result) { end = std::move(result); });
    bench.clock.advance(60ms);
    ASSERT_FALSE(end);
    EXPECT_FALSE(raw(AxisParameter::InputMode));
    EXPECT_EQ(lost(), 1U);
    EXPECT_TRUE(raw(AxisParameter::VelocityP)) << "which it does not touch";
    bench.clock.advance(1s);
    ASSERT_TRUE(end);
    expectAllBack();
}

} // namespace
} // namespace mb::quadquad2drv
