// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/parametertransfer.h"
#include "model/session.h"

#include <string>
#include <vector>

/// Orders to what is kept of a device's settings. Each is an operation of the device: Unsafe while another one has it, Timeout
/// when the device is gone.
namespace mb::orders {

/// Writes values that were kept, in a snapshot for one; first a snapshot of what is there is taken. Otherwise as WriteParameters.
struct RestoreParameters {
    DeviceId device;
    std::vector<ParameterChange> changes;
};

/// Takes back the last write to the unit that can be undone, of any day; or does `again` what was undone last. A new write with
/// its own proof. Refused when there is none.
struct UndoWrite {
    DeviceId device;
    bool again = false;
};

/// Somebody keeps a write that would go back by itself (Snapshot::unconfirmed); writes nothing. OutOfRange when it is none.
struct KeepChange {
    DeviceId device;
    std::int64_t change = 0; ///< UnconfirmedView::change
};

/// It goes back now. Unsafe while the motor is not seen to stand.
struct PutBackChange {
    DeviceId device;
    std::int64_t change = 0;
};

/// Keeps everything that can be read.
struct TakeSnapshot {
    DeviceId device;
    std::string name; ///< UTF-8; empty is "by hand"
};

} // namespace mb::orders
