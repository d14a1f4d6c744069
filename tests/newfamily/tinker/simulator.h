// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/simulator.h"
#include "transport/link.h"

#include <memory>

namespace mb::tinker {

/// Family::simulate. Address 1 to 15. Option: `motor` (simulation/motormodel.h; 25d). disturb(): what a motor knows, and "end-switch" (0/1).
[[nodiscard]] Result<std::unique_ptr<Simulator>> simulate(Link &link, Clock &clock, const SimulatedUnit &unit);

} // namespace mb::tinker
