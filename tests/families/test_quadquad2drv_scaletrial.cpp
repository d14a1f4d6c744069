// SPDX-License-Identifier: GPL-3.0-or-later
// What ends the search for the gain scales before its time, in each of its phases (docs/safety.md#what-ends-an-experiment).
#include "quadquad2drvboard.h"

#include "families/quadquad2drv/codec.h"
#include "families/quadquad2drv/parameters.h"
#include "model/parametertransfer.h"
#include "wire/bytes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string_view>

namespace mb::quadquad2drv {
namespace {

/// A search that has begun, under somebody who watches.
struct Search {
    Search()
        : bench("quadquad2drv:0")
        , operation(bench.clock, say("scales"))
    {
    }
    void begin()
    {
        bench.renew();
        operation.run<ExperimentReport>(findGainScales(*bench.device, bench.stream(), withPower(0.25), operation),
            [this](const Result<ExperimentReport> &result) { end = result ? Error{} : result.error(); });
    }
    [[nodiscard]] bool isAt(std::string_view phase)
    {
        return bench.clock.runUntil([&] { return end || operation.status().step.english() == phase; }, 20min) && !end;
    }
    [[nodiscard]] bool endsWithin(Duration limit)
    {
        return bench.clock.runUntil([this] { return end.has_value(); }, limit);
    }
    void disturb(std::string_view what, double value) { EXPECT_TRUE(bench.board().disturb(what, value)) << what; }
    void expectStopped(std::string_view why)
    {
        ASSERT_TRUE(end);
        EXPECT_EQ(end->fault, Fault::Unsafe);
        EXPECT_NE(end->detail.english().find(why), std::string::npos) << end->detail;
        bench.clock.advance(100ms);
        EXPECT_FALSE(bench.board().isOutputOn());
    }

    Board bench;
    Operation operation;
    std::optional<Error> end;
};

TEST(QuadQuad2DrvScaleTrial, StopsWhenNobodyRenewsTheLeaseInAnyPhase)
{
    for (const char *phase : {"turning the motor with several powers", "looking for velocity P",
             "looking for velocity I", "looking for position P", "looking for position I", "looking for position D"}) {
        SCOPED_TRACE(phase);
        Search search;
        search.begin();
        ASSERT_TRUE(search.isAt(phase));
        search.bench.renewal.stop();
        EXPECT_TRUE(search.endsWithin(1050ms));
        search.expectStopped("nobody renewed");
    }
}

TEST(QuadQuad2DrvScaleTrial, AMotorThatRunsFasterThanItsPowerAllowsIsStopped)
{
    Search search;
    search.begin();
    ASSERT_TRUE(search.isAt("looking for velocity P"));
    search.disturb("load-torque", 1.2);
    EXPECT_TRUE(search.endsWithin(300ms));
    search.expectStopped("faster than the power limit allows");
}

/// Somebody pushes it more and more, the way it turns.
TEST(QuadQuad2DrvScaleTrial, AMotorIsStoppedAtSixteenTenthsOfTheSpeedThatItsPowerGivesAndNotBefore)
{
    Search search;
    const auto speed = [&search] { return std::abs(search.bench.board().speed()); };
    double fastest = 0.0;
    search.begin();
    ASSERT_TRUE(search.bench.clock.runUntil(
        [&] {
            fastest = std::max(fastest, speed());
            return search.operation.status().step.english() == "looking for velocity P";
        },
        1min));
    Instant since = search.bench.clock.now();
    const auto lasts = [&] { // longer than those that look for the first gain
        if (search.bench.board().speed() > -0.2 * fastest)
            since = search.bench.clock.now();
        return search.bench.clock.now() - since > 800ms;
    };
    ASSERT_TRUE(search.bench.clock.runUntil(lasts, 1min));
    double torque = 0.5;
    Timer pushing(search.bench.clock);
    std::function<void()> push = [&] {
        search.disturb("load-torque", torque += 0.035);
        pushing.startIn(20ms, push);
    };
    push();
    ASSERT_TRUE(search.endsWithin(5s));
    EXPECT_GT(speed(), 1.6 * fastest);
    EXPECT_LT(speed(), 1.68 * fastest) << "its speed is that of the last 60 ms";
    search.expectStopped("faster than the power limit allows");
}

TEST(QuadQuad2DrvScaleTrial, AnEncoderThatIsTurnedRoundMidwayIsNoticed)
{
    Search search;
    search.begin();
    ASSERT_TRUE(search.isAt("looking for position P"));
    search.disturb("encoder-reversed", 1.0);
    const auto turns = [&search] { return search.end || std::abs(search.bench.board().speed()) > 500.0; };
    ASSERT_TRUE(search.bench.clock.runUntil(turns, 1min));
    EXPECT_TRUE(search.endsWithin(300ms));
    search.expectStopped("the wrong way");
}

TEST(QuadQuad2DrvScaleTrial, SettingsAreNotGivenBackToAMotorThatIsNotSeenToStand)
{
    Search search;
    search.begin();
    ASSERT_TRUE(search.isAt("looking for position D"));
    const auto stops = search.bench.stream().changed().add([&search] {
        if (!search.bench.stream().isRunning())
            search.bench.board().setPowered(false);
    });
    search.bench.sent.clear();
    EXPECT_TRUE(search.endsWithin(2min));
    search.expectStopped("are not seen to stand");
}

TEST(QuadQuad2DrvScaleTrial, APowerLimitBelowTheAskedPowerIsKept)
{
    Search search;
    NoProgress progress;
    ASSERT_TRUE(run(search.bench.clock,
        writeParameters(*search.bench.device, {{indexOf(0, AxisParameter::LimitPower), 820}}, progress)));
    search.bench.sent.clear();
    search.begin();
    EXPECT_TRUE(search.endsWithin(20min));
    int limits = 0;
    for (const Bytes &packet : search.bench.sent) {
        if (packet[2] == static_cast<std::uint8_t>(PacketId::SetPower) && packet.size() == 7) {
            EXPECT_LE(std::abs(static_cast<std::int16_t>(readU16le(packet, 4))), 820);
        }
        if (packet[2] == static_cast<std::uint8_t>(PacketId::SetPowerLimit)) {
            ++limits;
            EXPECT_LE(readU16le(packet, 4), 820);
        }
    }
    EXPECT_GT(limits, 0);
    const auto &log = search.operation.status().log;
    EXPECT_TRUE(std::any_of(log.begin(), log.end(), [](const LogLine &line) {
        return line.text.english() == "the axis has a power limit of 10 %, which is kept";
    }));
}

} // namespace
} // namespace mb::quadquad2drv
