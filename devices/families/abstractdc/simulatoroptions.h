// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/abstractdc/protocol.h"
#include "families/abstractdc/simulatorflash.h"
#include "simulation/motormodel.h"
#include "simulation/simulator.h"

#include <array>
#include <vector>

namespace mb::abstractdc::simulation {

enum class StoredGains { Tuned, Default, Overshoot };

/// The options of simulator.h.
struct UnitOptions {
    int offset = 0;
    const Dialect *dialect = &dialectF;
    const MotorParameters *motor = nullptr;
    double load = 5.0;
    StoredGains gains = StoredGains::Tuned;
    int glitches = 0;          ///< every so many position logs; 0: none but those that the timer makes
    int temperatureOffset = 0; ///< counts; no two sensors are alike
    std::uint64_t seed = 1;
    std::vector<SimulatedFault> faults;

    [[nodiscard]] static Result<UnitOptions> parse(const SimulatedUnit &unit);
    [[nodiscard]] const SimulatedFault *find(FaultKind fault) const;
};

/// Gains for velocity, current, position that fit the motor and the loop of 20 ms (docs/names.md#integer-gains), or blank flash.
[[nodiscard]] std::array<Record, 3> storedGains(const UnitOptions &options);

constexpr double countsPerAmpere = 20.0;
constexpr double countsPerDegree = 10.0;

} // namespace mb::abstractdc::simulation
