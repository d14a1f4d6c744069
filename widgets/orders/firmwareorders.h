// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "firmware/firmwareimage.h"
#include "model/family.h"
#include "model/snapshot.h"

#include <memory>

namespace mb::orders {

/// Writes firmware. An operation of the device, whose report is in the snapshot; one a bus. Unsafe while another one has the
/// device or the bus, Timeout when it is gone; else the fault that the report tells.
struct UpdateFirmware {
    DeviceId device;
    std::shared_ptr<const FirmwareImage> image;
    UpdateOptions options;
};

/// Ends an operation; whoever gave its order is answered with Cancelled, a trial stops first and puts back what it changed. No
/// errors: one that has ended stays as it is.
struct CancelOperation {
    OperationId operation;
};

} // namespace mb::orders
