// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/target.h"

#include <CLI/CLI.hpp>

namespace mb::console {

/// What `drive` was given, as typed.
struct DriveArguments {
    std::string device;
    std::string mode;
    std::string target;
    std::string seconds;
    std::string axis;
    std::string slot;
    std::string velocity;
    std::string acceleration;
    std::string ramp;
    std::string slew;
    bool brake = false;
    bool coast = false;
    bool reverseMotor = false;
    bool reverseSensor = false;
    bool zero = false;
    bool relative = false;
    bool buffered = false;
    bool halt = false;
    std::string limitOverride;

    void declare(CLI::App &arguments);
};

/// What is driven, checked by the family before anything is opened.
struct DrivePlan {
    Target target;
    SetPoint setPoint;
    double slew = 0.0; ///< greatest change of the target per second; 0 jumps
    Duration time{};
    bool zero = false;
    bool halt = false; ///< before it is switched off
};

/// Brakes to a halt and holds the position.
[[nodiscard]] SetPoint holding();

/// Usage or OutOfRange for what cannot be meant, does not belong together, or is not offered by the family. Nothing is sent.
[[nodiscard]] Result<DrivePlan> planOf(Console &console, const DriveArguments &arguments);

} // namespace mb::console
