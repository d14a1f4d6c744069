// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiment/guards.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mb::tuning {
namespace {

using namespace std::chrono_literals;

constexpr Instant start{1s};

GuardPlan plan()
{
    GuardPlan plan;
    plan.envelope = {.travel = 1000.0, .speed = 5000.0, .current = 10.0, .duty = 0.5};
    plan.origin = 200.0;
    plan.swing = 500.0;
    plan.breakaway = 0.05;
    plan.lag = 0.1;
    plan.telemetry = 10ms;
    plan.command = 20ms;
    plan.longest = 4s;
    return plan;
}

/// Samples every 10 ms from the start on; the first trip of `feed(guards, time, number)`.
template <class Feed> std::optional<Trip> run(const GuardPlan &plan, int samples, Feed feed)
{
    Guards guards(plan, start);
    for (int i = 0; i < samples; ++i) {
        if (auto trip = feed(guards, start + i * 10ms, i))
            return trip;
    }
    return std::nullopt;
}

void expectTrip(const std::optional<Trip> &trip, EndReason guard, Instant at, std::string_view number)
{
    ASSERT_TRUE(trip) << toString(guard);
    EXPECT_EQ(trip->guard, guard) << toString(trip->guard);
    EXPECT_EQ(trip->at, at) << trip->detail;
    EXPECT_NE(trip->detail.english().find(number), std::string::npos) << trip->detail;
}

TEST(Guards, TravelTripsBeforeTheMotorCanOnlyStopBeyondIt)
{
    // 2000 counts/s, stopped within 155 ms: 310 counts of way
    const auto trip = run(plan(), 100, [](Guards &g, Instant t, int i) { return g.position(t, 200.0 + 20.0 * i); });
    expectTrip(trip, EndReason::Travel, start + 350ms, "1000 are allowed");
    EXPECT_FALSE(run(plan(), 200, [](Guards &g, Instant t, int) { return g.position(t, 1200.0); }));
    EXPECT_TRUE(run(plan(), 1, [](Guards &g, Instant t, int) { return g.position(t, -801.0); }));
}

TEST(Guards, SamplesThatComeAtOnceTellNoSpeed)
{
    Guards guards(plan(), start);
    double counts = 200.0;
    for (int i = 0; i < 40; ++i) { // 1000 counts/s, ten samples together
        for (int k = 0; k < 10; ++k) {
            const auto trip = guards.position(start + i * 10ms + k * 1us, counts += 1.0);
            ASSERT_FALSE(trip) << trip->detail;
        }
    }
    counts += 900.0; // and a real one
    EXPECT_TRUE(guards.position(start + 410ms, counts));
}

TEST(Guards, SpeedTripsAboveOneFifthMoreThanPlanned)
{
    const auto at = [](double speed) { return [speed](Guards &g, Instant t, int) { return g.velocity(t, speed); }; };
    EXPECT_FALSE(run(plan(), 10, at(-6000.0)));
    expectTrip(run(plan(), 10, at(-6001.0)), EndReason::Speed, start, "6001");
}

TEST(Guards, CurrentTripsAfterAHundredMillisecondsAboveOrAtOnceFarAbove)
{
    expectTrip(run(plan(), 100, [](Guards &g, Instant t, int i) { return g.current(t, i < 20 ? 9.0 : -11.0); }),
        EndReason::Current, start + 300ms, "100 ms");
    expectTrip(run(plan(), 100, [](Guards &g, Instant t, int i) { return g.current(t, i < 20 ? 9.0 : 15.1); }),
        EndReason::Current, start + 200ms, "15.1");
    EXPECT_FALSE(run(plan(), 900, [](Guards &g, Instant t, int i) { return g.current(t, i % 10 == 0 ? 2.0 : 10.4); }));
}

TEST(Guards, AMotorThatRestsIsHeardAndHasNoCurrent)
{
    Guards guards(plan(), start);
    EXPECT_FALSE(guards.current(start, 11.0));
    guards.rested(start + 90ms);
    EXPECT_FALSE(guards.look(start + 185ms, 10, 0));
    EXPECT_FALSE(guards.current(start + 190ms, 11.0)) << "it did not flow all the time";
}

TEST(Guards, EnergyTripsAfterTheHeatOfTenSecondsAtTheLimit)
{
    expectTrip(run(plan(), 2000, [](Guards &g, Instant t, int) { return g.current(t, 9.9); }), EndReason::Energy,
        start + 10210ms, "10 s are allowed");
    EXPECT_FALSE(run(plan(), 2000, [](Guards &g, Instant t, int) { return g.current(t, 7.0); }));
}

TEST(Guards, DutyTemperatureAndSupplyTripAtTheirLimits)
{
    GuardPlan limits = plan();
    limits.lowestBus = 6.0;
    limits.highestBus = 14.0;
    EXPECT_FALSE(run(limits, 5, [](Guards &g, Instant t, int) { return g.duty(t, -0.51); }));
    expectTrip(
        run(limits, 5, [](Guards &g, Instant t, int) { return g.duty(t, -0.53); }), EndReason::Duty, start, "53 %");
    EXPECT_FALSE(run(limits, 5, [](Guards &g, Instant t, int) { return g.temperature(t, 75.0); }));
    expectTrip(run(limits, 5, [](Guards &g, Instant t, int) { return g.temperature(t, 75.5); }), EndReason::Temperature,
        start, "75.5");
    EXPECT_FALSE(run(limits, 5, [](Guards &g, Instant t, int) { return g.busVoltage(t, 14.0); }));
    expectTrip(run(limits, 5, [](Guards &g, Instant t, int) { return g.busVoltage(t, 14.1); }), EndReason::BusVoltage,
        start, "14.1");
    EXPECT_FALSE(run(limits, 5, [](Guards &g, Instant t, int) { return g.busVoltage(t, 6.0); }));
    EXPECT_TRUE(run(limits, 5, [](Guards &g, Instant t, int) { return g.busVoltage(t, 5.9); }));
    limits.envelope.duty.reset();
    EXPECT_FALSE(run(limits, 5, [](Guards &g, Instant t, int) { return g.duty(t, 1.0); }));
    EXPECT_TRUE(run(limits, 5, [](Guards &g, Instant t, int) { return g.duty(t, 1.03); })) << "all there is";
}

TEST(Guards, WrongDirectionTripsAfterFiveSamplesBeyondTenCounts)
{
    const auto pushed = [](double duty, double step) {
        return [duty, step](Guards &g, Instant t, int i) {
            if (auto trip = g.duty(t, duty))
                return trip;
            return g.position(t, 200.0 + step * i);
        };
    };
    expectTrip(run(plan(), 100, pushed(0.3, -4.0)), EndReason::WrongDirection, start + 70ms, "counts down at 30 %");
    EXPECT_TRUE(run(plan(), 100, pushed(-0.3, 4.0)));
    EXPECT_FALSE(run(plan(), 100, pushed(-0.3, -4.0)));
    // a motor that is braked goes on for a while, but not faster
    EXPECT_FALSE(run(plan(), 30, [](Guards &g, Instant t, int i) {
        const double slower = i < 10 ? 0.0 : 0.25 * (i - 10) * (i - 10);
        if (auto trip = g.duty(t, i < 10 ? 0.3 : -0.3))
            return trip;
        return g.position(t, 200.0 + 10.0 * i - slower);
    }));
}

TEST(Guards, NoMotionTripsAfterHalfASecondOfPushing)
{
    const auto still = [](double duty) {
        return [duty](Guards &g, Instant t, int i) {
            if (auto trip = g.duty(t, duty))
                return trip;
            return g.position(t, 200.0 + (i % 2));
        };
    };
    expectTrip(run(plan(), 100, still(0.16)), EndReason::NoMotion, start + 500ms, "16 % duty");
    EXPECT_FALSE(run(plan(), 300, still(0.14))) << "three times the friction is not reached";
}

TEST(Guards, WithoutADutyToLookAtALargeErrorStandsForIt)
{
    GuardPlan blind = plan();
    blind.dutyKnown = false;
    const auto away = [](double error, double step) {
        return [error, step](Guards &g, Instant t, int i) {
            if (auto trip = g.error(t, error))
                return trip;
            return g.position(t, 200.0 + step * i);
        };
    };
    expectTrip(run(blind, 100, away(300.0, 0.0)), EndReason::NoMotion, start + 500ms, "half a step");
    expectTrip(run(blind, 100, away(300.0, -4.0)), EndReason::WrongDirection, start + 70ms, "down");
    EXPECT_FALSE(run(blind, 100, away(250.0, 0.0))) << "half a step is not more than half a step";
    EXPECT_TRUE(run(blind, 100, away(250.1, 0.0)));
    EXPECT_FALSE(run(plan(), 100, away(300.0, 0.0))) << "its duty is known, and is none";
    blind.isVelocity = true;
    EXPECT_FALSE(run(blind, 100, away(300.0, 0.0))) << "the target of a speed stands for it";
}

TEST(Guards, AnIntegralThatIsKnownToBeSlowHasThatMuchLongerToMoveItsMotor)
{
    GuardPlan blind = plan();
    blind.dutyKnown = false;
    blind.isVelocity = true;
    blind.late = 700ms;
    const auto stands = [](Guards &g, Instant t, int i) {
        if (i == 0)
            g.target(1000.0);
        return g.position(t, 200.0);
    };
    expectTrip(run(blind, 200, stands), EndReason::NoMotion, start + 1200ms, "half a step");
}

TEST(Guards, OscillationTripsWhenALoopSwingsItselfUpOrHitsBothEnds)
{
    const auto swing = [](double growth) {
        return [growth](Guards &g, Instant t, int i) {
            return g.error(t, 60.0 * std::pow(growth, i / 10) * (i / 10 % 2 == 0 ? 1.0 : -1.0));
        };
    };
    const auto grown = run(plan(), 200, swing(1.2));
    expectTrip(grown, EndReason::Oscillation, start + 600ms, "6 swings");
    EXPECT_FALSE(run(plan(), 200, swing(0.9)));
    EXPECT_FALSE(run(plan(), 200, swing(1.0)));
    GuardPlan noisy = plan();
    noisy.noise = 40.0; // swings of 60 and more: six of them may be noise as long as they are less than 200
    EXPECT_FALSE(run(noisy, 70, swing(1.2)));
    expectTrip(run(noisy, 200, swing(1.2)), EndReason::Oscillation, start + 1300ms, "6 swings");
    GuardPlan wide = plan();
    const auto flipping = run(wide, 200, [](Guards &g, Instant t, int i) { return g.duty(t, i % 4 < 2 ? 0.4 : -0.4); });
    expectTrip(flipping, EndReason::Oscillation, start + 420ms, "21 times");
    EXPECT_FALSE(run(wide, 200, [](Guards &g, Instant t, int i) { return g.duty(t, i % 4 < 2 ? 0.2 : -0.2); }));
}

TEST(Guards, APositionWithoutADutyThatDoesNotComeToRestTripsOscillation)
{
    GuardPlan blind = plan();
    blind.dutyKnown = false;
    blind.swing = 60.0;
    const auto swinging = [](double size, double share) {
        return [size, share](Guards &g, Instant t, int i) { // beside its target
            return g.error(t, 15.0 + size * std::pow(share, i) * (i % 2 == 0 ? 1.0 : -1.0));
        };
    };
    const auto lasting = run(blind, 100, swinging(8.0, 1.0));
    expectTrip(lasting, EndReason::Oscillation, start + 240ms, "25 swings");
    const auto broad = run(blind, 100, swinging(9.1, 1.0));
    expectTrip(broad, EndReason::Oscillation, start + 120ms, "13 swings");
    EXPECT_FALSE(run(blind, 100, swinging(14.0, 0.9))) << "it comes to rest";
    EXPECT_FALSE(run(blind, 100, swinging(1.0, 1.0))) << "of a count or two";
    GuardPlan seen = blind;
    seen.dutyKnown = true;
    EXPECT_FALSE(run(seen, 100, swinging(10.0, 1.0))) << "its duty shows how hard it works";
    GuardPlan turning = blind;
    turning.isVelocity = true;
    EXPECT_FALSE(run(turning, 100, swinging(10.0, 1.0))) << "a speed swings about its target";
}

TEST(Guards, LinkTripsAfterSilenceAndAfterLoss)
{
    Guards silent(plan(), start);
    EXPECT_FALSE(silent.position(start + 50ms, 1.0));
    EXPECT_FALSE(silent.look(start + 150ms, 10, 0));
    expectTrip(silent.look(start + 155ms, 10, 0), EndReason::Link, start + 150ms, "105 ms");
    EXPECT_FALSE(silent.look(start + 300ms, 10, 0)) << "one trip is all";

    GuardPlan slow = plan();
    slow.telemetry = 40ms;
    Guards patient(slow, start);
    EXPECT_FALSE(patient.look(start + 200ms, 0, 0));
    EXPECT_TRUE(patient.look(start + 201ms, 0, 0));

    GuardPlan unmeasured = plan();
    unmeasured.silence = 250ms;
    unmeasured.mostLost = 1.0;
    Guards heard(unmeasured, start);
    EXPECT_FALSE(heard.look(start + 250ms, 100, 99));
    EXPECT_TRUE(heard.look(start + 251ms, 100, 99));

    const auto lossy = [](std::uint64_t each) {
        return [each](Guards &g, Instant t, int i) {
            (void)g.position(t, 200.0);
            const auto n = static_cast<std::uint64_t>(i);
            return g.look(t, 1000 + n * (100 - each), n * each);
        };
    };
    const auto trip = run(plan(), 100, lossy(6));
    ASSERT_TRUE(trip);
    EXPECT_EQ(trip->guard, EndReason::Link);
    EXPECT_FALSE(run(plan(), 100, lossy(4)));
}

TEST(Guards, ASampleOfAnyKindIsHeard)
{
    using Feed = std::optional<Trip> (Guards::*)(Instant, double);
    for (const Feed feed : {&Guards::position, &Guards::velocity, &Guards::current, &Guards::duty, &Guards::temperature,
             &Guards::busVoltage}) {
        GuardPlan wide = plan();
        wide.lowestBus = 0.0;
        Guards guards(wide, start);
        EXPECT_FALSE((guards.*feed)(start + 90ms, 0.25));
        EXPECT_FALSE(guards.look(start + 100ms, 10, 0));
        const bool isPosition = feed == &Guards::position;
        EXPECT_EQ(guards.look(start + 101ms, 10, 0).has_value(), !isPosition) << "its position is missed all the same";
        EXPECT_EQ(guards.look(start + 191ms, 10, 0).has_value(), isPosition);
    }
}

TEST(Guards, APositionThatIsSilentAloneIsALostLink)
{
    Guards guards(plan(), start);
    for (int i = 0; i <= 15; ++i) {
        EXPECT_FALSE(guards.current(start + i * 10ms, 1.0));
        if (i <= 5) {
            EXPECT_FALSE(guards.position(start + i * 10ms, 200.0));
        }
        EXPECT_FALSE(guards.look(start + i * 10ms, 10, 0));
    }
    expectTrip(guards.look(start + 155ms, 10, 0), EndReason::Link, start + 150ms, "no position for 105 ms");
}

TEST(Guards, TimeTripsAtHalfAsLongAgainAsPlanned)
{
    Guards guards(plan(), start);
    for (int i = 0; i <= 600; ++i) {
        EXPECT_FALSE(guards.position(start + i * 10ms, 200.0));
        EXPECT_FALSE(guards.look(start + i * 10ms, static_cast<std::uint64_t>(i), 0));
    }
    expectTrip(guards.look(start + 6005ms, 600, 0), EndReason::Time, start + 6s, "1.5 × 4 s");
}

} // namespace
} // namespace mb::tuning
