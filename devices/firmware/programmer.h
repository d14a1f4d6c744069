// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"
#include "async/progress.h"
#include "async/task.h"
#include "firmware/firmwareimage.h"
#include "transport/externalprogram.h"

#include <functional>
#include <memory>

class QTemporaryFile;

namespace mb {

/// What updates through somebody else's program (openocd, avrdude) have in common: the file it reads, and its run. Engine thread.

/// The image as an Intel HEX file that goes with the object; `program` stands in the error.
[[nodiscard]] Result<std::unique_ptr<QTemporaryFile>> hexFileFor(const FirmwareImage &image, std::string_view program);

/// Runs a program to its end and hands over everything it prints; whole lines go to the log too, but empty ones. LinkLost when
/// it cannot be started; Timeout, with `remedy`, when it says nothing for a minute, and then it is ended. `take` outlives the task.
[[nodiscard]] Task<ExternalProgram::Exit> runProgrammer(Clock &clock, ExternalProgram::Command command, Message remedy,
    std::function<void(const ExternalProgram::Piece &)> take, Progress &progress);

} // namespace mb
