// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/result.h"
#include "recording/loadedrecording.h"

#include <memory>

namespace mb {

/// What all channels of a recording hold together.
struct RecordingTotals {
    std::uint64_t samples = 0;
    std::uint64_t lost = 0;
    double seconds = 0.0;
};
[[nodiscard]] RecordingTotals totalsOf(const LoadedRecording &recording);

/// An .mcap of this program, or a table: `time_s,name (unit),…` with # lines before it, as this program writes, or
/// `t,channel,value,unit`, as `motorbenchctl watch` prints. OutOfRange with path, line and cause for anything else.
[[nodiscard]] Result<std::shared_ptr<const LoadedRecording>> loadRecording(const std::string &path);

} // namespace mb
