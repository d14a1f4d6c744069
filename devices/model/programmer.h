// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/device.h"
#include "model/firmwareimage.h"
#include "transport/externalprogram.h"

#include <functional>
#include <memory>

class QTemporaryFile;

namespace mb {

/// What updates through somebody else's program (openocd, avrdude) have in common: the file it reads, its run, and the question
/// afterwards whether the device is back. Engine thread.

/// The image as an Intel HEX file that goes with the object; `program` stands in the error.
[[nodiscard]] Result<std::unique_ptr<QTemporaryFile>> hexFileFor(const FirmwareImage &image, std::string_view program);

/// Runs a program to its end and hands over everything it prints; whole lines go to the log too, but empty ones. LinkLost when
/// it cannot be started; Timeout, with `remedy`, when it says nothing for a minute, and then it is ended. `take` outlives the task.
[[nodiscard]] Task<ExternalProgram::Exit> runProgrammer(Clock &clock, ExternalProgram::Command command, Message remedy,
    std::function<void(const ExternalProgram::Piece &)> take, Progress &progress);

/// Whether the device answers again: asked every 500 ms, ten times. LinkLost.
[[nodiscard]] Task<bool> answersAgain(Device &device);

} // namespace mb
