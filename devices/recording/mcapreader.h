// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/result.h"
#include "recording/mcapformat.h"

#include <functional>

namespace mb {

/// Reads files of McapWriter, also such that end in the middle because the program or the machine did, and files of other programs: with
/// chunks, packed or not, every number of each message in JSON being a signal (`/topic/way/to/it`). Calls back in the order of the
/// file; unset functions skip.
struct McapReader {
    std::function<void(std::uint16_t id, const std::string &topic, const mcap::Map &about)> channel;
    std::function<void(std::uint16_t channel, std::int64_t nanoseconds, double value, std::uint64_t lost, bool gap)>
        sample;
    std::function<void(const std::string &name, const mcap::Map &facts)> metadata;

    /// Asked before each record: true ends the reading, as if the file ended there.
    std::function<bool()> enough;

    /// Whether the file is complete. OutOfRange with path and cause: not MCAP, damaged chunks, no channel of samples. Blocks as long as the disk does.
    [[nodiscard]] Result<bool> read(const std::string &path) const;
};

} // namespace mb
