// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/snapshot.h"

#include <map>
#include <optional>
#include <vector>

namespace mb {

/// Remembers what flash still has while RAM has something newer, and when that was written. The device does not tell:
/// it is what was read before the write.
class RamLedger {
public:
    struct Row {
        ParameterIndex index;
        std::optional<std::int64_t> flash; ///< nothing when it was never read
        std::int64_t ram = 0;
    };

    /// Follows every device of the snapshot, shown or not. `now` is on the line of all time stamps.
    void observe(const Snapshot &snapshot, Instant now);
    /// In table order.
    [[nodiscard]] std::vector<Row> rows(DeviceId device) const;
    /// Of the newest value that is in RAM only.
    [[nodiscard]] std::optional<Instant> lastWrite(DeviceId device) const;

private:
    struct Page {
        std::uint64_t revision = 0;
        std::vector<ParameterStore::Entry> entries;
        std::map<ParameterIndex, std::optional<std::int64_t>> flash;
        std::optional<Instant> lastWrite;
    };
    static void follow(Page &page, const DeviceView &device, Instant now);

    std::map<DeviceId, Page> m_pages;
};

} // namespace mb
