// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/family.h"

namespace mb::dmc60c {

/// What a file would do: pages in the order they are written, version, notes. OutOfRange with the reason of the preflight.
[[nodiscard]] Result<ImageSummary> inspect(const FirmwareImage &image);

/// The update of README.md#updates: preflight, bootloader, page 30 first, page 0 last, reset, version read back. Rerunnable after any
/// interruption: it asks the device where it stands first, and starts again at page 30 whenever the device may have
/// restarted. Never reports Done before the device has answered with the version of the file. Device, image and progress
/// outlive the task.
[[nodiscard]] Task<UpdateReport> update(
    Device &device, const FirmwareImage &image, UpdateOptions options, Progress &progress);

} // namespace mb::dmc60c
