// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wire/canframe.h"

#include <cstdint>

/// Device values to the three status frames (README.md#status-frames), in the device's own units.
namespace mb::dmc60c::simulation {

struct LimitPin {
    bool level = true; ///< pulled up: high with the switch open
    bool hit = false;
    bool disabled = false;
    bool normallyClosed = false;
    bool disabledByFrame = false;
    bool softHit = false;
    bool softEnabled = false;
};

struct GeneralState {
    std::int32_t duty = 0; ///< −32768…32767
    LimitPin forward;
    LimitPin reverse;
    bool limitOverride = false;
    bool currentLimitActive = false;
    bool overTemperature = false;
    bool underVoltage = false;
    bool gateDriver = false;
    int mode = 15;
    std::int64_t error = 0; ///< counts per 100 ms, counts, or 8.16 A / V, by mode
};

struct EncoderState {
    std::int32_t position = 0; ///< counts
    std::int32_t velocity = 0; ///< counts per 100 ms
    bool pinA = false;
    bool pinB = false;
    bool pinIndex = false;
};

struct AnalogState {
    double input = 0.0;        ///< V
    double current = 0.0;      ///< A, positive from M+ to M−
    double temperature = 25.0; ///< °C
    double bus = 12.0;         ///< V
};

[[nodiscard]] CanFrame generalFrame(int device, const GeneralState &state);
/// Divides what does not fit, and says so in the flags; a velocity beyond that saturates, a position wraps.
[[nodiscard]] CanFrame encoderFrame(int device, const EncoderState &state);
/// Saturates at ±128.
[[nodiscard]] CanFrame analogFrame(int device, const AnalogState &state);

} // namespace mb::dmc60c::simulation
