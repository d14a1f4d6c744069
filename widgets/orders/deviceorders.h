// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/parameter.h"
#include "model/session.h"

#include <optional>
#include <string>
#include <vector>

namespace mb {

/// Samples per second of one channel that somebody would see.
struct RateWish {
    DeviceId device;
    ChannelIndex channel;
    double hertz = 0.0;
    friend bool operator==(const RateWish &, const RateWish &) = default;
};

} // namespace mb

/// Orders to a device that concern who and how it is. Timeout when it is gone; those that talk to it are operations: Unsafe
/// while another one has it.
namespace mb::orders {

/// It blinks for some seconds.
struct Identify {
    DeviceId device;
};

struct Rename {
    DeviceId device;
    std::string name; ///< UTF-8; a family may take fewer characters (OutOfRange)
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

/// Telemetry as often as somebody would see it, instead of all that the same one wished for before; no wishes: it sees nothing any
/// more. Answered at once: what becomes of wishes is in app/engine/rates.h.
struct WishRates {
    std::uint64_t wisher = 0; ///< who; a number of its own
    std::vector<RateWish> wishes;
};

} // namespace mb::orders
