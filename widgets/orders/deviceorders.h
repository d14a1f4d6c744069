// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/parameter.h"
#include "model/session.h"

#include <optional>
#include <string>

/// Orders to a device that concern who and how it is. Timeout when it is gone; those that talk to it are operations: Unsafe
/// while another one has it.
namespace mb::orders {

/// It blinks for some seconds.
struct Identify {
    DeviceId device;
};

struct Rename {
    DeviceId device;
    std::string name; ///< Latin-1, 1 to 64 characters
};

/// Another number (node, address) on its link.
struct Renumber {
    DeviceId device;
    int address = 0; ///< 1 to Capabilities::lastAddress; one that is taken is not checked here
};

/// Reads the faults and clears them.
struct ClearFaults {
    DeviceId device;
};

/// A number that only its user knows, by its key (model/deviceprofile.h).
struct Calibrate {
    DeviceId device;
    std::string key;
    std::optional<double> value; ///< in the unit of the calibration; nothing: not known
};

/// The dialect to speak against what the scan found. Unsafe while its motor is driven.
struct SetDialect {
    DeviceId device;
    std::string key; ///< empty: what the scan found
};

/// Telemetry while a page shows the device. What is asked for while it is busy is done once it is free, and answered then.
struct SetRate {
    DeviceId device;
    ChannelIndex channel;
    double hertz = 0.0; ///< samples per second wished for; 0 returns to the device's own
};

} // namespace mb::orders
