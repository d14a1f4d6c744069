// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/family.h"
#include "model/operation.h"

#include <string>

namespace mb {

/// The log of a firmware update as a file of its own in `folder`, which is made if need be: what was said and answered, with
/// Unix time, and how it ended. Yields its path; OutOfRange when it cannot be written.
[[nodiscard]] Result<std::string> saveTranscript(
    const std::string &folder, const Device &device, const OperationStatus &status, const UpdateReport &report);

} // namespace mb
