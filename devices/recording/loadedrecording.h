// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "recording/mcapformat.h"
#include "telemetry/telemetry.h"

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
    bool shortened = false; ///< the file has more samples than were to be read: the first of them are here
    bool simulated = false;
    Instant first{};
    Instant last{};
};
/// Before the first sample.
void addLoadedChannel(LoadedRecording &loaded, const std::string &title, const std::string &unit);

/// What a channel of this name most likely measures.
[[nodiscard]] Quantity quantityOfKey(std::string_view key);

} // namespace mb
