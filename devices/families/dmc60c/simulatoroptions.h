// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/dmc60c/protocol.h"
#include "families/dmc60c/simulatorcontrol.h"
#include "families/dmc60c/simulatorflash.h"
#include "simulation/simulator.h"

#include <optional>
#include <string>
#include <vector>

namespace mb::dmc60c::simulation {

enum class StoredGains { Default, Tuned, Overshoot };

/// The options of simulator.h, checked.
struct UnitOptions {
    int number = 0;
    std::string motor = "cim";
    double load = 9.0;
    StoredGains gains = StoredGains::Tuned;
    std::string serial;
    std::string name = "DMC60C";
    std::optional<std::uint16_t> session;
    std::uint32_t product = productDmc60c;
    std::uint16_t firmware = 0x0117;
    bool inBootloader = false;
    bool brake = true; ///< stored setting of the button
    CrcVariant crc = CrcVariant::A;
    VelocityWindow velocity = VelocityWindow::Rolling;
    std::uint64_t seed = 1;
    std::vector<SimulatedFault> faults;

    [[nodiscard]] static Result<UnitOptions> parse(const SimulatedUnit &unit);
    /// The same number in another box.
    [[nodiscard]] UnitOptions twin() const;
};

} // namespace mb::dmc60c::simulation
