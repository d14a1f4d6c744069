// SPDX-License-Identifier: GPL-3.0-or-later
// Margins of loops whose margins are known in closed form.
#include "tuning/margins.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace mb::tuning {
namespace {

constexpr double toDegrees = 180.0 / std::numbers::pi;

TEST(Margins, OfAnIntegratorWithADelayAreKnown)
{
    // p·(tau·s + 1)/(tau·s) on gain·e^(-L·s)/(tau·s + 1): gain·p/tau/s·e^(-L·s)
    const PlantModel plant{1000.0, 0.2, 0.05};
    const double k = 6.0; // rad/s
    const double p = k * plant.tau / plant.gain;
    const Margins margins = marginsOf(Mode::Velocity, plant, {p, p / plant.tau});
    EXPECT_NEAR(margins.crossover, k, 0.01 * k);
    EXPECT_NEAR(margins.phase, 90.0 - k * plant.delay * toDegrees, 0.1);
    const double turn = std::numbers::pi / 2.0 / plant.delay;
    EXPECT_NEAR(margins.turnover, turn, 0.01 * turn);
    EXPECT_NEAR(margins.gain, turn / k, 0.01 * turn / k);
    // gain margin and sensitivity of the same loop: 1/|1 + L|, largest where the derivative vanishes, found by a fine search
    double ms = 0.0;
    for (double omega = 0.1; omega < 100.0; omega += 0.001)
        ms = std::max(ms, 1.0 / std::abs(1.0 + std::polar(k / omega, -std::numbers::pi / 2.0 - omega * plant.delay)));
    EXPECT_NEAR(margins.ms, ms, 0.002 * ms);
    EXPECT_TRUE(margins.isStable());
}

TEST(Margins, ThirtyPointsADecadeAreExactToAHundredth)
{
    const PlantModel plant{1000.0, 0.2, 0.05};
    const ContinuousGains gains{0.0012, 0.006};
    const Margins fine = marginsOf(Mode::Velocity, plant, gains);
    const Margins coarse = marginsOf(Mode::Velocity, plant, gains, 30);
    EXPECT_NEAR(coarse.ms, fine.ms, 0.01 * fine.ms);
    EXPECT_NEAR(coarse.crossover, fine.crossover, 0.08 * fine.crossover);
}

TEST(Margins, APositionLoopHasTheIntegratorOfItsShaft)
{
    // gain·p/(s·(tau·s + 1)): phase −90° − atan(omega·tau), and never −180°
    const PlantModel plant{1000.0, 0.2, 0.0};
    const Margins margins = marginsOf(Mode::Position, plant, {0.01});
    const double omega = std::sqrt((std::sqrt(1.0 + 4.0 * 100.0 * 0.04) - 1.0) / (2.0 * 0.04));
    EXPECT_NEAR(margins.crossover, omega, 0.01 * omega);
    EXPECT_NEAR(margins.phase, 90.0 - std::atan(0.2 * omega) * toDegrees, 0.3);
    EXPECT_TRUE(std::isinf(margins.gain));
    EXPECT_EQ(margins.turnover, 0.0);
}

TEST(Margins, TwoIntegratorsBeginAtMinus180Degrees)
{
    // PI on an integrator: (p·s + i)·gain/s² over the lag of the motor
    const PlantModel plant{1000.0, 0.001, 0.0};
    const Margins margins = marginsOf(Mode::Position, plant, {0.02, 0.1});
    const double omega = std::sqrt(200.0 + std::sqrt(200.0 * 200.0 + 100.0 * 100.0)); // omega⁴ = 20²·omega² + 100²
    EXPECT_NEAR(margins.crossover, omega, 0.01 * omega);
    EXPECT_NEAR(margins.phase, (std::atan(0.2 * omega) - std::atan(0.001 * omega)) * toDegrees, 0.2);
    EXPECT_TRUE(margins.isStable());
}

TEST(Margins, APhaseBeyond180DegreesIsNotTakenForOneThatLeads)
{
    // an integral quicker than the lag: −180° + atan(omega·p/i) − atan(omega·tau) of a position loop, and a double integrator's size
    const PlantModel plant{1000.0, 0.2, 0.0};
    const Margins margins = marginsOf(Mode::Position, plant, {0.01, 0.2});
    const double omega = margins.crossover;
    const double size = 1000.0 * std::hypot(0.01 * omega, 0.2) / (omega * omega * std::hypot(0.2 * omega, 1.0));
    EXPECT_NEAR(size, 1.0, 0.02);
    EXPECT_NEAR(margins.phase, (std::atan(0.05 * omega) - std::atan(0.2 * omega)) * toDegrees, 0.2);
    EXPECT_LT(margins.phase, -20.0);
    EXPECT_FALSE(margins.isStable());
    EXPECT_TRUE(std::isinf(margins.ms));
    // a derivative brings it back: −180° − 90° + its lead
    const Margins led = marginsOf(Mode::Position, plant, {0.01, 0.2, 0.02});
    const double w = led.crossover;
    const double lead
        = 180.0 - std::atan(0.01 * w / (0.02 * w * w - 0.2)) * toDegrees; // of i + p·s + d·s², beyond its quarter
    EXPECT_NEAR(led.phase, lead - std::atan(0.2 * w) * toDegrees, 0.2);
    EXPECT_TRUE(led.phase > 0.0);
}

TEST(Margins, ALoopWithoutGainHasThemAll)
{
    const Margins margins = marginsOf(Mode::Velocity, {1000.0, 0.2, 0.05}, {});
    EXPECT_NEAR(margins.ms, 1.0, 1e-9);
    EXPECT_EQ(margins.phase, 180.0);
    EXPECT_EQ(margins.crossover, 0.0);
    EXPECT_TRUE(std::isinf(margins.gain));
}

TEST(Margins, TheDampingOfADerivativeIsInThem)
{
    // p + d·s = p·(1 + tau·s) cancels the lag: gain·p/s of a position loop
    const PlantModel plant{1000.0, 0.2, 0.02};
    const Margins margins = marginsOf(Mode::Position, plant, {0.01, 0.0, 0.01 * 0.2});
    EXPECT_NEAR(margins.crossover, 10.0, 0.1);
    EXPECT_NEAR(margins.phase, 90.0 - 10.0 * 0.02 * toDegrees, 0.1);
}

TEST(Margins, TheOpenLoopIsThatOfTheMotorAndItsDelay)
{
    const PlantModel plant{1000.0, 0.2, 0.05};
    const std::complex<double> value = openLoop(Mode::Velocity, plant, {0.002, 0.01, 0.0001}, 5.0);
    const std::complex<double> s(0.0, 5.0);
    const std::complex<double> exact = 1000.0 / (0.2 * s + 1.0) * (0.002 + 0.01 / s + 0.0001 * s) * std::exp(-0.05 * s);
    EXPECT_NEAR(std::abs(value - exact), 0.0, 1e-9);
    const std::complex<double> place = openLoop(Mode::Position, plant, {0.002}, 5.0);
    EXPECT_NEAR(std::abs(place - 1000.0 / (0.2 * s + 1.0) / s * 0.002 * std::exp(-0.05 * s)), 0.0, 1e-9);
}

} // namespace
} // namespace mb::tuning
