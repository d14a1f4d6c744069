// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/motorparameters.h"

#include <algorithm>
#include <array>

namespace mb {
namespace {

constexpr double kilogramCentimetre = 0.0980665; // N·m

/// The rows of docs/names.md#motor-model hold what vendors print; the rest follows from it as derived there.
constexpr MotorParameters derive(MotorParameters p)
{
    const double speed = p.rotorFreeSpeed();
    p.resistance = p.nominalVoltage / p.stallCurrent;
    p.constant = (p.nominalVoltage - p.resistance * p.freeCurrent) / speed;
    const double noLoad = p.constant * p.freeCurrent;
    p.friction = 0.8 * noLoad;
    p.viscosity = 0.2 * noLoad / speed;
    p.breakaway = 1.2 * p.friction;
    const double efficiency = p.stallTorque / (p.gearRatio * p.constant * p.stallCurrent);
    p.torqueLoss = std::max(0.0, 1.0 - efficiency * p.stallCurrent / (p.stallCurrent - p.freeCurrent));
    return p;
}

constexpr MotorParameters row(std::string_view name, std::string_view title, double stallTorque, double stallCurrent,
    double freeCurrent, double freeSpeed, double gearRatio, double inductance, double inertia, int countsPerTurn,
    std::optional<MotorThermal> thermal = std::nullopt)
{
    MotorParameters p;
    p.name = name;
    p.title = title;
    p.stallTorque = stallTorque;
    p.stallCurrent = stallCurrent;
    p.freeCurrent = freeCurrent;
    p.freeSpeed = freeSpeed;
    p.gearRatio = gearRatio;
    p.inductance = inductance;
    p.inertia = inertia;
    p.countsPerTurn = countsPerTurn;
    p.thermal = thermal;
    return derive(p);
}

constexpr double kgcm = kilogramCentimetre;
constexpr std::array<MotorParameters, 6> table{
    row("cim", "CIM", 2.42, 133, 2.7, 5310, 1.0, 60e-6, 7.75e-5, 4096, MotorThermal{55, 0.9, 420, 2.2}),
    row("775pro", "775pro", 0.71, 134, 0.7, 18730, 1.0, 25e-6, 1.2e-5, 4096, MotorThermal{20, 1.6, 140, 4}),
    row("rs775", "RS775-125", 0.28, 18, 1.6, 5800, 1.0, 900e-6, 2.0e-5, 4096),
    row("25d", "Pololu 25D HP12 46.85:1", 15 * kgcm, 5.0, 0.30, 220, 46.85, 1.1e-3, 5.5e-7, 48,
        MotorThermal{4, 8, 30, 14}),
    row("25dlp", "Pololu 25D LP12 74.83:1", 7.1 * kgcm, 0.9, 0.06, 75, 74.83, 6.0e-3, 5.5e-7, 48),
    row("n20", "Pololu N20 HPCB12 75.81:1", 1.0 * kgcm, 0.75, 0.08, 450, 75.81, 5.0e-3, 1.4e-8, 12),
};

constexpr double slipBreakaway = 2.5; // times the friction while moving
constexpr double slipShare = 0.02;    // of the free speed

constexpr MotorParameters withBacklash(MotorParameters motor, std::string_view name, double outputDegrees)
{
    motor.name = name;
    motor.backlash = outputDegrees * std::numbers::pi / 180.0 * motor.gearRatio;
    return motor;
}

constexpr MotorParameters withSlip(MotorParameters motor, std::string_view name)
{
    motor.name = name;
    motor.breakaway = slipBreakaway * motor.friction;
    motor.slipSpeed = slipShare * motor.rotorFreeSpeed();
    return motor;
}

constexpr std::array<MotorParameters, 4> awkward{
    withBacklash(table[0], "cim-backlash", 20.0),
    withBacklash(table[3], "25d-backlash", 2.0),
    withSlip(table[0], "cim-slip"),
    withSlip(table[3], "25d-slip"),
};

} // namespace

std::span<const MotorParameters> motors()
{
    return table;
}

const MotorParameters *motorByName(std::string_view name)
{
    for (const std::span<const MotorParameters> known : {motors(), std::span<const MotorParameters>(awkward)}) {
        for (const MotorParameters &motor : known) {
            if (motor.name == name)
                return &motor;
        }
    }
    return nullptr;
}

} // namespace mb
