// SPDX-License-Identifier: GPL-3.0-or-later
// Limit cycles that are known exactly.
#include "tuning/relaycycle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace mb::tuning {
namespace {

/// Swings around 70 counts, one after the other; each as long as `spacing` tells of its number, as far as `reach` does.
Trace swings(int count, const std::function<double(int)> &spacing, const std::function<double(int)> &reach)
{
    Trace trace;
    double begun = 0.0;
    for (int i = 0; i < count; ++i) {
        const int samples = 100;
        for (int k = 0; k < samples; ++k)
            trace.add(begun + spacing(i) * k / samples,
                70.0 + reach(i) * std::sin(2.0 * std::numbers::pi * (k + 0.5) / samples - std::numbers::pi / 2.0));
        begun += spacing(i);
    }
    return trace;
}

TEST(RelayCycle, IsReadFromTheThirdToTheEighth)
{
    // crossings once a swing; a cycle lies between two of them
    const auto one = [](int) { return 0.2; };
    const auto hundred = [](int) { return 100.0; };
    const auto read = readRelay(swings(20, one, hundred));
    ASSERT_TRUE(read);
    EXPECT_EQ(read->cycles, 6);
    EXPECT_NEAR(read->period, 0.2, 1e-6);
    EXPECT_NEAR(read->amplitude, 100.0, 0.1);
    EXPECT_NEAR(read->scatter, 0.0, 1e-6);
    // what comes before the third and after the eighth does not count
    const auto beside = [](int i) { return i < 2 || i > 8 ? 0.3 : 0.2; };
    const auto inner = readRelay(swings(20, beside, hundred));
    ASSERT_TRUE(inner);
    EXPECT_NEAR(inner->scatter, 0.0, 1e-6);
}

TEST(RelayCycle, WantsThreeCycles)
{
    const auto one = [](int) { return 0.2; };
    const auto hundred = [](int) { return 100.0; };
    const auto read = readRelay(swings(6, one, hundred)); // six crossings
    ASSERT_TRUE(read);
    EXPECT_EQ(read->cycles, 3);
    EXPECT_FALSE(readRelay(swings(5, one, hundred)));
    EXPECT_FALSE(readRelay({}));
}

TEST(RelayCycle, PeriodsThatScatterByMoreThanATenthAreNoCycle)
{
    const auto hundred = [](int) { return 100.0; };
    const auto scattered = [&hundred](double by) {
        return readRelay(swings(
            20, [by](int i) { return i % 2 == 0 ? 0.2 * (1.0 + by) : 0.2 * (1.0 - by); }, hundred));
    };
    // a cycle is half of one swing and half of the next, but its crossing lies a quarter into a swing
    const auto mild = scattered(0.17);
    ASSERT_TRUE(mild);
    EXPECT_NEAR(mild->scatter, 0.5 * 0.17, 0.005);
    EXPECT_FALSE(scattered(0.23));
}

TEST(RelayCycle, ACrossingThatCountNoiseMadeIsNone)
{
    const auto one = [](int) { return 0.2; };
    const auto hundred = [](int) { return 100.0; };
    Trace trace = swings(20, one, hundred);
    int crossings = 0;
    for (std::size_t i = 1; i + 1 < trace.size(); ++i) {
        if (trace.y[i - 1] < 70.0 && trace.y[i] >= 70.0 && ++crossings % 3 == 1) {
            trace.y[i + 1] = 69.0; // back below the middle, and above it again
            i += 2;
        }
    }
    const auto read = readRelay(trace);
    ASSERT_TRUE(read);
    EXPECT_EQ(read->cycles, 6);
    EXPECT_NEAR(read->period, 0.2, 0.002);
}

/// A motor under a relay, simulated in small steps: half its way, and its speed at the change of sign.
ExactCycle simulatedCycle(double gain, double duty, double friction, double tau, double half, double braking)
{
    constexpr double shortPass = 1e-5;
    double speed = 0.0;
    double place = 0.0;
    double low = 0.0;
    double high = 0.0;
    double sign = 1.0;
    for (int i = 0; i < 12; ++i, sign = -sign) {
        if (i % 2 == 0)
            low = high = place;
        for (double t = 0.0; t < half; t += shortPass) {
            const double driving = gain * (sign * duty - std::copysign(friction, speed == 0.0 ? sign : speed));
            const bool brakes = speed * sign < 0.0;
            const double way = brakes ? gain * sign * (duty + friction / braking) : driving;
            speed += (way - speed) / (brakes ? tau / braking : tau) * shortPass;
            place += speed * shortPass;
            low = std::min(low, place);
            high = std::max(high, place);
        }
    }
    return {0.5 * (high - low), std::abs(speed)};
}

TEST(RelayCycle, TheExactCycleIsThatOfTheMotorWithFrictionAndAGearThatBrakes)
{
    struct Row {
        double friction, braking;
    };
    for (const Row &row : {Row{0.0, 1.0}, Row{0.05, 1.0}, Row{0.05, 2.0}, Row{0.0, 1.5}}) {
        const ExactCycle known = exactCycle(5000.0, 0.2, row.friction, 0.15, 0.1, row.braking);
        const ExactCycle seen = simulatedCycle(5000.0, 0.2, row.friction, 0.15, 0.1, row.braking);
        EXPECT_NEAR(known.amplitude, seen.amplitude, 0.002 * seen.amplitude) << row.friction << ' ' << row.braking;
        EXPECT_NEAR(known.speed, seen.speed, 0.002 * seen.speed) << row.friction << ' ' << row.braking;
    }
}

TEST(RelayCycle, TellsTheLagThatMadeItUpToTwentySeconds)
{
    for (const double tau : {0.001, 0.05, 0.4, 10.0}) {
        for (const double friction : {0.0, 0.06}) {
            RelayCycle cycle{0.3, 0.0, 0.0, 6};
            cycle.amplitude = exactCycle(5000.0, 0.2, friction, tau, 0.15, 1.4).amplitude;
            EXPECT_NEAR(tauFromRelay(cycle, 5000.0, 0.2, friction, 1.4).value_or(0.0), tau, 1e-4 * tau);
        }
    }
    // a motor without any lag goes this far, one of 20 s hardly moves
    const double most = 0.5 * 5000.0 * 0.2 * 0.15;
    EXPECT_FALSE(tauFromRelay({0.3, 1.001 * most, 0.0, 6}, 5000.0, 0.2, 0.0));
    EXPECT_FALSE(tauFromRelay({0.3, exactCycle(5000.0, 0.2, 0.0, 21.0, 0.15).amplitude, 0.0, 6}, 5000.0, 0.2, 0.0));
    EXPECT_TRUE(tauFromRelay({0.3, exactCycle(5000.0, 0.2, 0.0, 19.0, 0.15).amplitude, 0.0, 6}, 5000.0, 0.2, 0.0));
}

} // namespace
} // namespace mb::tuning
