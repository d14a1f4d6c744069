// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/family.h"

namespace mb::supermodified {

/// What a file would do. OutOfRange when it is no program for an ATmega328P.
[[nodiscard]] Result<ImageSummary> inspect(const FirmwareImage &image);

/// The update of README.md#firmware through avrdude, over the programming pins or the serial bootloader: written, read back and compared
/// by avrdude, and done only when the controller answered again. The wire carries no version. The link of the device is
/// closed meanwhile where it is the same port, and lost where that cannot be opened again at once. Device, image and progress
/// outlive the task.
[[nodiscard]] Task<UpdateReport> update(
    Device &device, const FirmwareImage &image, UpdateOptions options, Progress &progress);

} // namespace mb::supermodified
