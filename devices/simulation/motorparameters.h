// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numbers>
#include <optional>
#include <span>
#include <string_view>

namespace mb {

/// Two heat stores, winding and housing: J/K and K/W (docs/names.md#motor-model).
struct MotorThermal {
    double winding = 0.0;
    double windingToHousing = 0.0;
    double housing = 0.0;
    double housingToAir = 0.0;
};

/// A motor with its gear, SI units on the rotor side unless it says otherwise (docs/names.md#motor-model).
struct MotorParameters {
    std::string_view name; ///< of `motor=`
    std::string_view title;
    double nominalVoltage = 12.0;        ///< V
    double stallTorque = 0.0;            ///< N·m, at the output
    double stallCurrent = 0.0;           ///< A
    double freeCurrent = 0.0;            ///< A
    double freeSpeed = 0.0;              ///< rpm, at the output
    double gearRatio = 1.0;              ///< rotor turns per output turn
    double inductance = 0.0;             ///< H
    double inertia = 0.0;                ///< kg·m², the rotor's
    int countsPerTurn = 4096;            ///< encoder, per rotor turn
    std::optional<MotorThermal> thermal; ///< stays at air temperature without

    // Derived: one constant for torque and voltage, so that no energy comes from nowhere; what is missing of the
    // vendor's stall torque is a loss that grows with torque.
    double resistance = 0.0; ///< Ohm at 25 °C
    double constant = 0.0;   ///< V·s/rad and N·m/A at 25 °C
    double friction = 0.0;   ///< N·m while moving
    double viscosity = 0.0;  ///< N·m·s/rad
    double torqueLoss = 0.0; ///< fraction of the torque
    double breakaway = 0.0;  ///< N·m at rest

    // Of the motors that tests are meant to fail on:
    double backlash = 0.0;  ///< rad of the rotor, between it and its load as a mass of its own; 0: one mass
    double slipSpeed = 0.0; ///< rad/s in which friction falls from `breakaway` (Stribeck); 0: at the first move

    [[nodiscard]] constexpr double rotorFreeSpeed() const ///< rad/s
    {
        return freeSpeed * 2.0 * std::numbers::pi / 60.0 * gearRatio;
    }
};

/// cim, 775pro, rs775, 25d, 25dlp, n20.
[[nodiscard]] std::span<const MotorParameters> motors();
/// One of them, or one with what no model of a tuning has: cim-backlash, 25d-backlash (two masses), cim-slip, 25d-slip (friction
/// that falls with speed). nullptr when there is no such motor.
[[nodiscard]] const MotorParameters *motorByName(std::string_view name);

} // namespace mb
