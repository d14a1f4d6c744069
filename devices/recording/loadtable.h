// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/result.h"
#include "recording/loadedrecording.h"

namespace mb {

/// The CSV half of loadRecording().
[[nodiscard]] Result<std::shared_ptr<LoadedRecording>> loadTable(
    const std::string &path, std::uint64_t mostSamples, std::size_t mostBytes);

} // namespace mb
