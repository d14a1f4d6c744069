// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace mb {

/// What a target means: docs/names.md#units. A family offers what its device has.
enum class Mode : std::uint8_t { Off, Duty, Velocity, Position, Current, Voltage, Follow, RampPosition, RampVelocity };

/// duty, velocity, …, as on the command line.
[[nodiscard]] std::string_view toString(Mode mode);
[[nodiscard]] std::optional<Mode> modeFromString(std::string_view text);
/// Unit of the target: fraction, counts/s, counts, A, V; empty for follow and off.
[[nodiscard]] std::string_view unitOf(Mode mode);

/// One command to a motor. Targets are in the units of docs/names.md#units whatever the wire uses.
struct SetPoint {
    Mode mode = Mode::Off;
    double target = 0.0;
    int axis = 1; ///< 1…
    int slot = 0; ///< gain set, where the device has several
    std::optional<bool>
        brake;         ///< override: true brakes, false coasts at zero output; nothing leaves the stored setting
    double ramp = 0.0; ///< greatest change of output in duty per second, 0 = OutputOptions::usualRamp, or immediate
    bool reverseMotor = false;
    bool reverseSensor = false;
    bool overrideLimits = false; ///< the two flags below replace the device's own enables
    bool disableForwardLimit = false;
    bool disableReverseLimit = false;
    double velocity = 0.0;     ///< of profiled modes, counts/s
    double acceleration = 0.0; ///< of profiled modes, counts/s²
    // Where Capabilities says so:
    bool relative = false;   ///< position modes: the target is a distance; 0 holds where it is
    bool buffered = false;   ///< the device keeps it until Device::releaseMoves()
    std::uint32_t order = 0; ///< another number is another order: tells two equal relative moves apart

    friend bool operator==(const SetPoint &, const SetPoint &) = default;
};

/// What of a SetPoint's options for the output means something; DeviceDriver::check() refuses the rest.
struct OutputOptions {
    std::span<const Mode> ramp{}; ///< modes in which it is kept
    double usualRamp = 0.0;       ///< what a ramp of 0 means
    bool brake = false;
    bool directions = false; ///< those of motor and sensor can be exchanged
    bool limits = false;     ///< its limits can be overridden

    [[nodiscard]] bool ramps(Mode mode) const { return std::ranges::find(ramp, mode) != ramp.end(); }
};

} // namespace mb
