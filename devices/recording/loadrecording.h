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

/// Of samples that are kept in memory: 1.4 GB, some two hours of sixteen signals at 1 kHz.
inline constexpr std::uint64_t mostLoadedSamples = 100'000'000;
/// Of memory for them: a sample takes 14 bytes, but as much as 56 kB where an hour lies before the next.
inline constexpr std::size_t mostLoadedBytes = 2ULL << 30U;

/// An .mcap of this program, or a table: `time_s,name (unit),…` with # lines before it, as this program writes, or
/// `t,channel,value,unit`, as `motorbenchctl watch` prints. OutOfRange with path, line and cause for anything else.
/// Of a file that has more than `mostSamples` or `mostBytes` (of the second kind of table a third: its rows are kept twice) the first are read, and
/// LoadedRecording::shortened says so.
[[nodiscard]] Result<std::shared_ptr<const LoadedRecording>> loadRecording(
    const std::string &path, std::uint64_t mostSamples = mostLoadedSamples, std::size_t mostBytes = mostLoadedBytes);

} // namespace mb
