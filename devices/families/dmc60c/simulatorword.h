// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/dmc60c/protocol.h"

#include <span>

namespace mb::dmc60c::simulation {

/// CANCTRL0 (README.md#byte-orders).
struct ControlWord {
    ControlMode mode = ControlMode::NoDrive;
    int slot = 0;
    bool overrideNeutral = false;
    bool brake = false;
    bool reverseSensor = false;
    bool reverseMotor = false;
    bool overrideLimits = false;
    bool forwardLimitOff = false;
    bool reverseLimitOff = false;
    std::int32_t target = 0; ///< 24 bits; duty has its 16, follower the master's number
    std::int32_t ramp = 0;

    [[nodiscard]] static ControlWord decode(std::span<const std::uint8_t> bytes);
};

} // namespace mb::dmc60c::simulation
