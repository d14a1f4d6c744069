// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/dmc60c/simulatorgains.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mb::dmc60c::simulation {
namespace {

constexpr double passSeconds = 0.0005;
constexpr double supplyVolts = 12.0;
constexpr double bridgeOhms = 0.005;
constexpr double one = 65536.0;

/// Speed over duty K e^(−θs)/(τs + 1), and the duty that friction eats.
struct Plant {
    double gain = 0.0;     ///< rad/s at full duty
    double lag = 0.0;      ///< s
    double deadTime = 0.0; ///< s, of the velocity loop
    double friction = 0.0; ///< duty
};

Plant plantOf(const MotorParameters &motor, double load, VelocityWindow window)
{
    const double resistance = motor.resistance + bridgeOhms;
    const double drive = motor.constant * (1.0 - motor.torqueLoss);
    const double perSpeed = motor.constant + resistance * motor.viscosity / drive;
    const double perAcceleration = resistance * motor.inertia * load / drive;
    Plant plant;
    plant.gain = supplyVolts / perSpeed;
    plant.lag = perAcceleration / perSpeed;
    plant.deadTime
        = (window == VelocityWindow::Rolling ? 0.050 : 0.096) + 1.5 * passSeconds + motor.inductance / resistance;
    plant.friction = resistance * motor.friction / drive / supplyVolts;
    return plant;
}

std::uint32_t fixed(double value)
{
    const double raw = std::clamp(std::round(value * one), -2147483648.0, 2147483647.0);
    return static_cast<std::uint32_t>(static_cast<std::int32_t>(raw));
}

void storeVelocity(ParameterBank &bank, const Plant &plant, double countsPerRadian, double closedLag)
{
    const double scale = countsPerRadian * 0.1; // counts per 100 ms
    const double kp = plant.lag / (plant.gain * (closedLag + plant.deadTime));
    const double ki = kp / std::min(plant.lag, 4.0 * (closedLag + plant.deadTime));
    const std::uint32_t integral = std::max(fixed(fullDuty * ki * passSeconds / scale), 1U);
    bank.set(number::slot0, fixed(fullDuty * kp / scale));
    bank.set(number::slot0 + 1, integral);
    bank.set(number::slot0 + 3, static_cast<std::uint32_t>(std::min(fullDuty * one / integral, 2147483647.0)));
}

void storePosition(ParameterBank &bank, const Plant &plant, double countsPerRadian)
{
    const double mostDerivative = 0.1 * passSeconds * countsPerRadian; // a tenth of full duty for one count
    const double bandwidth = std::min(20.0, (1.0 + plant.gain * mostDerivative) / (2.0 * plant.lag));
    const double kp = plant.lag * bandwidth * bandwidth / plant.gain;
    const double kd = std::max(0.0, (2.0 * bandwidth * plant.lag - 1.0) / plant.gain);
    const auto nominal = static_cast<std::int32_t>(std::lround(1.5 * plant.friction * fullDuty));
    bank.set(number::slot1, fixed(fullDuty * kp / countsPerRadian));
    bank.set(number::slot1 + 2, fixed(fullDuty * kd / (passSeconds * countsPerRadian)));
    bank.set(number::slot1 + 5, 4);
    bank.set(number::slot1 + 9, static_cast<std::uint32_t>(nominal));
    bank.set(number::slot1 + 10, static_cast<std::uint32_t>(-nominal));
}

} // namespace

void storeGains(ParameterBank &bank, StoredGains kind, const MotorParameters &motor, double load, VelocityWindow window)
{
    if (kind == StoredGains::Default)
        return;
    const Plant plant = plantOf(motor, load, window);
    const double countsPerRadian = motor.countsPerTurn / (2.0 * std::numbers::pi);
    const double closedLag = (kind == StoredGains::Tuned ? 1.5 : 0.25) * plant.deadTime;
    storeVelocity(bank, plant, countsPerRadian, closedLag);
    storePosition(bank, plant, countsPerRadian);
}

} // namespace mb::dmc60c::simulation
