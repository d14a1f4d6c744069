// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/parametertransfer.h"
#include "model/session.h"

#include <vector>

/// Orders to the parameters of a device. Each is an operation of the device: Unsafe while another one has it, Timeout when the
/// device is gone.
namespace mb::orders {

/// Reads everything that can be read. Fails with the first fault, though what gave an answer was read.
struct ReadParameters {
    DeviceId device;
};

/// Writes raw values (checked against their tables) in this order and reads each back, into RAM; kept in the history. Ends at
/// the first error: what was written before is in force.
struct WriteParameters {
    DeviceId device;
    std::vector<ParameterChange> changes;
};

/// Stores RAM to flash and waits for the device's own proof.
struct StoreParameters {
    DeviceId device;
};

/// Writes what a reset took (DeviceProfile::lost) again.
struct RewriteSettings {
    DeviceId device;
};

} // namespace mb::orders
