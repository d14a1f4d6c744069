// SPDX-License-Identifier: GPL-3.0-or-later
// The frequency response of a motor on every family that takes a duty, in virtual time: what it says, what ends it, what it leaves.
#include "simulation/motormodel.h"
#include "tests/tuning/knownunit.h"
#include "tests/tuning/matrix/groundtruth.h"
#include "tuning/frequencyresponse.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <cstdio>
#include <numbers>
#include <string>

namespace mb::test {
namespace {

using namespace std::chrono_literals;
using tuning::FrequencyPoint;
using tuning::FrequencyResponse;
using tuning::SweepPlan;

/// What the motor itself answers, by its speed, without drive, link and encoder. counts/s per duty.
double trueMagnitude(const SweepPlan &plan, double hertz, const Cell &cell)
{
    MotorModel shaft(*motorByName(cell.motor), usualLoad(cell.motor));
    const double omega = 2.0 * std::numbers::pi * hertz;
    std::complex<double> sum;
    constexpr double fine = 0.0005;
    constexpr double underWay = 2.0;
    const double skipped = underWay + 2.0 / hertz;
    const auto count = static_cast<int>(4.0 / hertz / fine);
    const auto push = [&](double t) { shaft.step(plan.bias + plan.swing * std::cos(omega * t), Bridge::Drive, fine); };
    shaft.step(plan.bias, Bridge::Drive, underWay);
    for (double t = underWay; t < skipped; t += fine)
        push(t);
    for (int i = 0; i < count; ++i) {
        const double t = skipped + i * fine;
        push(t);
        sum += shaft.speed() * std::polar(1.0, -omega * t) * (2.0 / count);
    }
    return std::abs(sum) / plan.swing * countsOf(cell) / (2.0 * std::numbers::pi);
}

struct Swept {
    explicit Swept(const std::string &family)
        : cell(cellOfLoop(family, Mode::Velocity))
        , unit(cell)
        , plant(groundTruth(cell, 2000.0))
    {
        Envelope room;
        room.duty = 1.0;
        room.speed = 2.0 * plant.gain;
        room.travel = 200.0 * plant.gain;
        const double beat = std::chrono::duration<double>(unit.device().family().capabilities.commandPeriod).count();
        const auto planned = tuning::planSweep(plant, room, beat);
        EXPECT_TRUE(planned) << planned.error().text();
        plan = planned.value_or(SweepPlan());
        plan.limits = room;
    }
    [[nodiscard]] Task<FrequencyResponse> task()
    {
        auto around = unit.surroundings();
        around.note = [this, note = around.note](const Message &text) {
            note(text);
            const bool isSine = text.english().starts_with("sine ");
            sines += isSine ? 1 : 0;
            EXPECT_FALSE(isSine && unit.simulator().isOutputOn()) << "it is said before it moves";
            EXPECT_TRUE(!isSine || text.english().find(announcementOf(plan).english()) != std::string::npos) << text;
        };
        return tuning::measureFrequencyResponse(unit.device(), unit.stream(), plan, plant, std::move(around));
    }
    [[nodiscard]] FrequencyResponse measure()
    {
        const auto response = test::run(unit.clock(), task(), 10min);
        EXPECT_TRUE(response) << response.error().text();
        return response.value_or(FrequencyResponse());
    }

    Cell cell;
    KnownUnit unit;
    tuning::PlantModel plant;
    SweepPlan plan;
    int sines = 0;
};

class FrequencyResponseOf : public testing::TestWithParam<const char *> { };

TEST_P(FrequencyResponseOf, ItsMotorIsThatOfTheMotorAndStaysWithinWhatWasSaid)
{
    Swept swept(GetParam());
    const Instant begin = swept.unit.clock().now();
    const FrequencyResponse measured = swept.measure();
    const double seconds = std::chrono::duration<double>(swept.unit.clock().now() - begin).count();
    EXPECT_EQ(measured.stopReason, EndReason::None) << measured.evidence;
    EXPECT_TRUE(measured.stopped);
    EXPECT_EQ(swept.sines, static_cast<int>(swept.plan.hertz.size()));
    ASSERT_EQ(measured.points.size(), swept.plan.hertz.size()) << measured.evidence;
    for (const FrequencyPoint &point : measured.points) {
        const double expected = trueMagnitude(swept.plan, point.hertz, swept.cell);
        const double off = point.magnitude / expected - 1.0;
        std::printf("  %s %.2f Hz: %.0f counts/s per duty (%+.1f %%), %.0f°, coherence %.3f\n", GetParam(), point.hertz,
            point.magnitude, 100.0 * off, point.phase, point.coherence);
        EXPECT_GE(point.coherence, 0.9);
        EXPECT_LE(std::abs(off), point.hertz < 1.0 ? 0.05 : 0.16) << point.hertz;
    }
    EXPECT_NEAR(measured.trustedUpTo(), swept.plan.hertz.back(), 1e-3);
    double farthest = 0.0;
    for (const tuning::Trial &trial : swept.unit.journal().completed) {
        const tuning::Trace &position = trial.signal("position")->trace;
        for (const double place : position.y)
            farthest = std::max(farthest, std::abs(place - position.y.front()));
    }
    std::printf("  announced %.0f s and %.0f counts, done %.0f s and %.0f counts\n", swept.plan.seconds,
        swept.plan.travel, seconds, farthest);
    EXPECT_LE(seconds, swept.plan.seconds);
    EXPECT_LE(farthest, swept.plan.travel);
    swept.unit.expectStandsAsBefore();
}

TEST_P(FrequencyResponseOf, AMotorThatTroubleStrikesIsNoneAndItStandsWithItsGains)
{
    struct Trouble {
        const char *what;
        const char *reason;
    };
    for (const Trouble &trouble : {Trouble{"stall", "no motion"}, Trouble{"encoder-dead", "no motion"},
             Trouble{"user", "interrupted"}, Trouble{"room", "travel"}}) {
        Swept swept(GetParam());
        const std::string_view what = trouble.what;
        if (what == "room")
            swept.plan.limits.travel = 0.3 * swept.plan.travel;
        auto task = swept.task();
        task.start();
        ASSERT_TRUE(swept.unit.clock().runUntil(
            [&] { return task.isFinished() || std::abs(swept.unit.simulator().speed()) > 0.1 * swept.plant.gain; },
            60s));
        ASSERT_FALSE(task.isFinished()) << what;
        if (what == "user") {
            swept.unit.interruption().interrupt();
        } else if (what != "room") {
            EXPECT_TRUE(swept.unit.simulator().disturb(what, 1.0));
        }
        ASSERT_TRUE(swept.unit.clock().runUntil([&] { return task.isFinished(); }, 2min));
        ASSERT_TRUE(task.result()) << what;
        EXPECT_EQ(toString(task.result()->stopReason), trouble.reason) << what << ": " << task.result()->evidence;
        EXPECT_TRUE(task.result()->stopped) << what;
        EXPECT_FALSE(task.result()->evidence.empty());
        swept.unit.expectStandsAsBefore();
    }
}

INSTANTIATE_TEST_SUITE_P(EveryFamily, FrequencyResponseOf, testing::Values("dmc60c", "abstractdc", "quadquad2drv"),
    [](const auto &row) { return std::string(row.param); });

TEST(FrequencyResponse, OfASupermodifiedIsRefusedBecauseNothingOrdersItsDuty)
{
    KnownUnit unit(cellOfLoop("supermodified", Mode::Position));
    SweepPlan plan;
    plan.bias = 0.2;
    plan.swing = 0.05;
    plan.hertz = {1.0};
    const auto refused = test::run(unit.clock(),
        tuning::measureFrequencyResponse(unit.device(), unit.stream(), plan,
            groundTruth(cellOfLoop("supermodified", Mode::Position), 2000.0), unit.surroundings()));
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().text().find("duty"), std::string::npos) << refused.error().text();
    EXPECT_TRUE(unit.journal().completed.empty());
    EXPECT_FALSE(unit.simulator().isOutputOn());
    EXPECT_EQ(unit.gainsInUnit(), unit.before);
}

} // namespace
} // namespace mb::test
