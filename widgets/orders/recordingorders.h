// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "transport/backends/replay.h"

#include <string>

/// Orders to what is recorded of a link, and to recordings that are played.
namespace mb::orders {

/// Writes what passes a CAN link to a file, as a candump log, or as Vector ASC where its name ends in `.asc`. How it goes is in the
/// snapshot; when it ends, also by itself, a notice tells. LinkLost (no such link, or a folder that cannot be written),
/// Unsupported (no CAN), Unsafe (it is being recorded already).
struct StartRecording {
    std::string link;
    std::string path; ///< as the file system has it
};

/// No errors: what is not recorded stays so.
struct StopRecording {
    std::string link;
};

/// Where a `replay:` link stands, runs and how fast; a new position ends what its devices were doing. LinkLost, Unsupported (no
/// replay), OutOfRange.
struct SteerReplay {
    std::string link;
    ReplayOrder order;
};

} // namespace mb::orders
