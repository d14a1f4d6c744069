// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/family.h"

namespace mb::quadquad2drv {

/// What the maker does not tell (README.md#firmware), with the likely reading.
struct BootSettings {
    std::chrono::milliseconds lineTime{50};     ///< least time between lines
    std::chrono::milliseconds answerTime{2000}; ///< for the confirmation of a line
    std::chrono::seconds bannerTime{30};        ///< for jumper and reset, by hand
    int baudrate = 115200;
    std::string ending = "\r";         ///< of a line, as the terminal program of the data sheet sends it
    std::string banner = "bootloader"; ///< what its greeting holds, in whatever case
    std::vector<std::string> failures{"err", "fail", "bad", "invalid"}; ///< what a refusal holds, in whatever case
    std::string farewell = "reset"; ///< leaves the bootloader; empty: only jumper and reset do

    /// Takes the settings out of the options of `--via` (Family::routes). OutOfRange for a value that is none.
    [[nodiscard]] static Result<BootSettings> take(LinkAddress &via);
};

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
