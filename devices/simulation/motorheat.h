// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/motorparameters.h"

namespace mb {

/// Temperatures of a simulated motor, and what they make of its winding and magnets.
class MotorHeat {
public:
    [[nodiscard]] double winding() const { return m_winding; } ///< °C
    [[nodiscard]] double housing() const { return m_housing; } ///< °C
    void set(double celsius) { m_winding = m_housing = celsius; }

    /// Ohm of a winding that has `cold` at air temperature.
    [[nodiscard]] double resistance(double cold) const { return cold * (1.0 + copper * (m_winding - air)); }
    /// V·s/rad, and N·m/A, of what has `cold` at air temperature.
    [[nodiscard]] double constant(double cold) const { return cold * (1.0 + magnet * (m_winding - air)); }

    /// `power` W into the winding for `seconds`.
    void step(const MotorThermal &thermal, double power, double seconds)
    {
        const double flow = (m_winding - m_housing) / thermal.windingToHousing;
        m_winding += seconds * (power - flow) / thermal.winding;
        m_housing += seconds * (flow - (m_housing - air) / thermal.housingToAir) / thermal.housing;
    }

private:
    static constexpr double air = 25.0;       // °C
    static constexpr double copper = 0.00393; // 1/K
    static constexpr double magnet = -0.002;  // 1/K

    double m_winding = air;
    double m_housing = air;
};

} // namespace mb
