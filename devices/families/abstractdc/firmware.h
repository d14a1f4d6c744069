// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/family.h"

namespace mb::abstractdc {

/// Family::inspect: an STM32 program in Intel HEX with its vectors at 0x08000000 (README.md#firmware).
[[nodiscard]] Result<ImageSummary> inspect(const FirmwareImage &image);
/// Family::update: through OpenOCD and a debug probe. The wire carries no version: proved by the programmer's own verify and by
/// the drive, which answers again. A cut is never fatal: SWD reaches the microcontroller whatever its flash holds.
[[nodiscard]] Task<UpdateReport> update(
    Device &device, const FirmwareImage &image, UpdateOptions options, Progress &progress);

} // namespace mb::abstractdc
