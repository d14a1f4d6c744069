// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/family.h"
#include "model/operation.h"

#include <string>

namespace mb {

/// The log of a firmware update as a file of its own: what was said and answered, with Unix time, and how it ended.
struct Transcript {
    std::string folder; ///< made if need be
    std::string path;   ///< another for each unit on each link, and for each second
    std::string text;
};

[[nodiscard]] Transcript transcriptOf(
    const std::string &folder, const Device &device, const OperationStatus &status, const UpdateReport &report);
/// Any thread. Yields its path; OutOfRange when it cannot be made, NotKept when writing fails.
[[nodiscard]] Result<std::string> save(const Transcript &transcript);

} // namespace mb
