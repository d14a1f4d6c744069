// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/supermodified/protocol.h"
#include "simulation/simulator.h"

#include <optional>
#include <string>

namespace mb::supermodified::simulation {

/// What `simulate` may say about a unit.
struct UnitOptions {
    int node = factoryNode;
    Dialect dialect = Dialect::D1;
    std::string motor = "25d";
    double load = 5.0;
    bool tuned = true;
    std::optional<int> baudrate;
    int mask = exactMask;
    int level = 0;
    bool halfPacket = false;
    bool hangs = true;
    std::uint64_t seed = 1;
    std::vector<SimulatedFault> faults;

    [[nodiscard]] static Result<UnitOptions> parse(const SimulatedUnit &unit);
};

} // namespace mb::supermodified::simulation
