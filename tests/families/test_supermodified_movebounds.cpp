// SPDX-License-Identifier: GPL-3.0-or-later
// What a node with these gains may be told, row by row.
#include "families/supermodified/movebounds.h"
#include "families/supermodifiedbench.h"

#include <cmath>
#include <optional>

namespace mb::supermodified {
namespace {

using test::ramp;
using test::setPoint;

struct SupermodifiedJudgement : testing::Test {
    [[nodiscard]] std::optional<Fault> profile(Dialect dialect, const SetPoint &order)
    {
        node.dialect = dialect;
        const auto judged = MoveBounds(node, known).checkProfile(order);
        return judged ? std::nullopt : std::optional(judged.error().fault);
    }
    [[nodiscard]] std::optional<Fault> reach(
        Dialect dialect, Mode mode, double target, std::optional<std::int64_t> position, bool relative = false)
    {
        node.dialect = dialect;
        SetPoint order = setPoint(mode, target);
        order.relative = relative;
        MotionCount count;
        count.started();
        if (position)
            count.told(*position);
        const auto judged
            = MoveBounds(node, known).checkReach(order, position ? count.stepOf(order, true) : std::nullopt);
        return judged ? std::nullopt : std::optional(judged.error().fault);
    }
    [[nodiscard]] std::optional<double> overrun(Dialect dialect, const SetPoint &order, double distance)
    {
        node.dialect = dialect;
        return MoveBounds(node, known).overrun(order, distance);
    }
    Node node;
    Roster::Entry known;
};

TEST_F(SupermodifiedJudgement, AProfileIsAsFastAndAsSteepAsTheWidthOfTheDialect)
{
    const auto bad = std::optional(Fault::OutOfRange);
    const std::optional<Fault> good;
    EXPECT_EQ(profile(Dialect::D1, ramp(1.0, 46340.0, 65535.0)), good);
    EXPECT_EQ(profile(Dialect::D1, ramp(1.0, 46341.0, 65535.0)), bad);
    EXPECT_EQ(profile(Dialect::D1, ramp(1.0, 46340.0, 65536.0)), bad);
    EXPECT_EQ(profile(Dialect::D2, ramp(1.0, 46340.0, 4294967295.0)), good);
    EXPECT_EQ(profile(Dialect::D2, ramp(1.0, 46341.0, 1.0)), bad);
    EXPECT_EQ(profile(Dialect::D2, ramp(1.0, 1.0, 4294967296.0)), bad);
    EXPECT_EQ(profile(Dialect::D3, ramp(1.0, 4294967295.0, 4294967295.0)), good);
    EXPECT_EQ(profile(Dialect::D3, ramp(1.0, 4294967296.0, 1.0)), bad);
    EXPECT_EQ(profile(Dialect::D3, ramp(1.0, -1.0, 1.0)), bad);
    EXPECT_EQ(profile(Dialect::D3, ramp(1.0, 1.0, -1.0)), bad);
    EXPECT_EQ(profile(Dialect::D3, ramp(1.0, NAN, 1.0)), bad);
    for (const double refused : {0.3, 0.49, 0.99}) { // the device takes 1 or more
        EXPECT_EQ(profile(Dialect::D3, ramp(1.0, refused, 1.0)), bad) << refused;
        EXPECT_EQ(profile(Dialect::D3, ramp(1.0, 1.0, refused)), bad) << refused;
    }
    EXPECT_EQ(profile(Dialect::D3, ramp(1.0, 0.0, 0.0)), good) << "it goes on with what it has";
}

TEST_F(SupermodifiedJudgement, AMoveThatMayPassItsTargetNeedsAProfileThatIsKnown)
{
    const auto unsafe = std::optional(Fault::Unsafe);
    for (const Dialect dialect : {Dialect::D1, Dialect::D2}) {
        known = {};
        EXPECT_EQ(profile(dialect, ramp(1.0, 0.0, 0.0)), unsafe);
        EXPECT_EQ(profile(dialect, ramp(1.0, 800.0, 0.0)), unsafe);
        EXPECT_EQ(profile(dialect, ramp(1.0, 0.0, 800.0)), unsafe);
        EXPECT_EQ(profile(dialect, setPoint(Mode::RampVelocity, 1.0)), std::nullopt) << "it has no target";
        known.profileVelocity = 46340;
        EXPECT_EQ(profile(dialect, ramp(1.0, 0.0, 0.0)), unsafe);
        EXPECT_EQ(profile(dialect, ramp(1.0, 0.0, 800.0)), std::nullopt);
        known.profileAcceleration = 800;
        EXPECT_EQ(profile(dialect, ramp(1.0, 0.0, 0.0)), std::nullopt);
        known.profileVelocity = 46341;
        const auto square = MoveBounds(node, known).checkProfile(ramp(1.0, 0.0, 0.0));
        EXPECT_EQ(square ? "" : square.error().remedy.english(), "give --velocity, or write a lower profile.velocity");
    }
    EXPECT_EQ(profile(Dialect::D3, ramp(1.0, 0.0, 0.0)), std::nullopt);
}

TEST_F(SupermodifiedJudgement, AStepStaysBelowWhatOverflowsTheLoop)
{
    const auto bad = std::optional(Fault::OutOfRange);
    const auto unsafe = std::optional(Fault::Unsafe);
    const std::optional<Fault> good;
    EXPECT_EQ(reach(Dialect::D1, Mode::Position, 1.0, 0), unsafe) << "its P is not known";
    known.gainP = 2000; // 2^31 / 2000 = 1 073 741.8
    for (const Dialect dialect : {Dialect::D1, Dialect::D2}) {
        EXPECT_EQ(reach(dialect, Mode::Position, 1073740.0, 0), good);
        EXPECT_EQ(reach(dialect, Mode::Position, 1073741.0, 0), bad);
        EXPECT_EQ(reach(dialect, Mode::Position, -1073740.0, 0), good);
        EXPECT_EQ(reach(dialect, Mode::Position, -1073741.0, 0), bad);
        EXPECT_EQ(reach(dialect, Mode::Position, 0.0, 1073740), good);
        EXPECT_EQ(reach(dialect, Mode::Position, 0.0, 1073741), bad);
        EXPECT_EQ(reach(dialect, Mode::Position, 1573740.0, 500000), good) << "from where it is";
        EXPECT_EQ(reach(dialect, Mode::Position, 1573741.0, 500000), bad);
        EXPECT_EQ(reach(dialect, Mode::Position, -600000.0, 473740), good);
        EXPECT_EQ(reach(dialect, Mode::Position, -600000.0, 473741), bad);
        EXPECT_EQ(reach(dialect, Mode::Position, 5.0, std::nullopt), unsafe) << "from where";
        EXPECT_EQ(reach(dialect, Mode::Position, 5.0, std::nullopt, true), unsafe);
        EXPECT_EQ(reach(dialect, Mode::Position, 0.0, std::nullopt, true), good) << "it is a halt";
        EXPECT_EQ(reach(dialect, Mode::Position, 1073740.0, 0, true), good);
        EXPECT_EQ(reach(dialect, Mode::Position, 1073741.0, 0, true), bad);
        EXPECT_EQ(reach(dialect, Mode::Position, 1073741.0, 1073741, true), good) << "it counts from the set-point";
        EXPECT_EQ(reach(dialect, Mode::Position, 5.0, -1073740, true), bad);
        EXPECT_EQ(reach(dialect, Mode::RampPosition, 1073741.0, 0), good) << "a profile has no step";
    }
    EXPECT_EQ(reach(Dialect::D3, Mode::Position, 1e12, 0), good);
    EXPECT_EQ(reach(Dialect::D3, Mode::Velocity, 1e12, 0), good);
    known.gainP = 0;
    EXPECT_EQ(reach(Dialect::D1, Mode::Position, 2e9, 0), good) << "nothing times nothing";
    known.gainP = 1;
    EXPECT_EQ(reach(Dialect::D1, Mode::Position, 2147483647.0, 0), good);
    EXPECT_EQ(reach(Dialect::D1, Mode::Position, 2147483648.0, 0), bad);
}

TEST_F(SupermodifiedJudgement, TwoSecondsOfASpeedStayBelowWhatOverflowsTheLoop)
{
    const auto bad = std::optional(Fault::OutOfRange);
    const std::optional<Fault> good;
    for (const Dialect dialect : {Dialect::D1, Dialect::D2}) {
        for (const Mode mode : {Mode::Velocity, Mode::RampVelocity}) {
            known = {};
            EXPECT_EQ(reach(dialect, mode, 1.0, 0), std::optional(Fault::Unsafe)) << "its P is not known";
            known.gainP = 2000;
            EXPECT_EQ(reach(dialect, mode, 536870.0, std::nullopt), good);
            EXPECT_EQ(reach(dialect, mode, 536871.0, std::nullopt), bad);
            EXPECT_EQ(reach(dialect, mode, -536870.0, 1000), good);
            EXPECT_EQ(reach(dialect, mode, -536871.0, 1000), bad);
        }
        known.gainP = 65535; // 2^31 / 65535 = 32768.5
        EXPECT_EQ(reach(dialect, Mode::RampPosition, 5.0, 0), bad) << "with the fastest profile that there is";
        known.profileVelocity = 16383;
        EXPECT_EQ(reach(dialect, Mode::RampPosition, 1e6, 0), good);
        known.profileVelocity = 16384;
        EXPECT_EQ(reach(dialect, Mode::RampPosition, 5.0, 0), bad);
        EXPECT_EQ(reach(dialect, Mode::RampPosition, 0.0, 0, true), good) << "it is a halt";
    }
}

TEST_F(SupermodifiedJudgement, AProfiledMoveHasGoneWrongBeyondItsStoppingDistance)
{
    EXPECT_EQ(overrun(Dialect::D1, ramp(1e5, 6000.0, 40000.0), 1e5), 450.0);
    EXPECT_EQ(overrun(Dialect::D2, ramp(1e5, 6000.0, 40000.0), -1e5), 450.0);
    EXPECT_EQ(overrun(Dialect::D1, ramp(1e5, 6000.0, 40000.0), 600.0), 300.0) << "it never gets that fast";
    EXPECT_EQ(overrun(Dialect::D1, ramp(1e5, 6000.0, 40000.0), 10.0), 100.0) << "a loop swings";
    EXPECT_EQ(overrun(Dialect::D1, ramp(1e5, 100.0, 0.0), 1e9), std::nullopt) << "its slope is not known";
    EXPECT_EQ(overrun(Dialect::D1, ramp(1e5, 0.0, 100.0), 1e9), std::nullopt) << "its speed is not known";
    known.profileAcceleration = 40000;
    known.profileVelocity = 6000;
    EXPECT_EQ(overrun(Dialect::D1, ramp(1e5, 0.0, 0.0), 1e5), 450.0);
    EXPECT_EQ(overrun(Dialect::D3, ramp(1e5, 0.0, 0.0), 1e5), std::nullopt);
    EXPECT_EQ(overrun(Dialect::D1, setPoint(Mode::RampVelocity, 1.0), 1e5), std::nullopt);
}

TEST(SupermodifiedGain, IsNotWrittenWhereTheErrorThatStandsOverflowsTheLoop)
{
    const auto isTaken = [](Dialect dialect, std::int64_t p, std::optional<MotionCount::Step> error,
                             const SetPoint &applied = setPoint(Mode::Position, 0.0)) {
        Node node;
        node.dialect = dialect;
        return MoveBounds(node, {}).checkGain(p, applied, error).has_value();
    };
    std::optional<MotionCount::Step> nothing = MotionCount::Step{0, 1073741};
    nothing.reset();
    for (const Dialect dialect : {Dialect::D1, Dialect::D2}) {
        EXPECT_TRUE(isTaken(dialect, 2000, MotionCount::Step{0, 1073740}));
        EXPECT_FALSE(isTaken(dialect, 2000, MotionCount::Step{0, 1073741}));
        EXPECT_FALSE(isTaken(dialect, 2000, MotionCount::Step{-1073741, 5})) << "the farther end";
        EXPECT_TRUE(isTaken(dialect, 0, MotionCount::Step{0, 1073741})) << "nothing times nothing";
        EXPECT_TRUE(isTaken(dialect, 2000, nothing)) << "somebody else may have moved it, and nobody knows where to";
        EXPECT_TRUE(isTaken(dialect, 2000, nothing, setPoint(Mode::Velocity, -536870.0)));
        EXPECT_FALSE(isTaken(dialect, 2000, nothing, setPoint(Mode::Velocity, -536871.0)));
    }
    EXPECT_TRUE(isTaken(Dialect::D3, 2000, MotionCount::Step{0, 1073741}));
}

} // namespace
} // namespace mb::supermodified
