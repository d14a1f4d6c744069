// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/family.h"

namespace mb::quadquad2drv {

/// Family::routes: the serial port, what hands do, and what of the bootloader is not known.
[[nodiscard]] std::span<const UpdateRoute> routes();

/// Family::inspect: how many lines would be sent. The file names no version.
[[nodiscard]] Result<ImageSummary> inspect(const FirmwareImage &image);

/// Family::update, over the board's UART: `options.via` is its serial link. Waits for the bootloader's banner while the jumper
/// is being closed, sends the file line by line, each after the confirmation of the one before, resets the board, and
/// compares the version over SPI. Everything said goes to the log. Can be run again after any cut.
[[nodiscard]] Task<UpdateReport> update(
    Device &device, const FirmwareImage &image, UpdateOptions options, Progress &progress);

} // namespace mb::quadquad2drv
