// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/result.h"
#include "model/telemetry.h"
#include "recording/mcapformat.h"

#include <deque>
#include <memory>

namespace mb {

/// A file read back: histories like those of a device.
struct LoadedRecording {
    std::deque<std::string> words; ///< what the table points to
    std::vector<Channel> table;    ///< key is the title: "dmc60c:5 velocity"
    std::shared_ptr<Telemetry> telemetry;
    std::map<std::string, mcap::Map> about; ///< "device …", "parameters …", "loss …"
    bool hasClock = false;                  ///< time stamps are Unix time; else seconds since the start
    bool complete = true;                   ///< false: the end is missing
    bool simulated = false;
    Instant first{};
    Instant last{};
};

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

/// What a channel of this name most likely measures.
[[nodiscard]] Quantity quantityOfKey(std::string_view key);

} // namespace mb
