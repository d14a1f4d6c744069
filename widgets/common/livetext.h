// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/snapshot.h"

#include <QString>

#include <optional>
#include <string_view>

namespace mb {

/// The newest committed value of a channel by key; nothing when it was never seen or is older than `staleAfter`.
[[nodiscard]] std::optional<double> liveValue(
    const DeviceView &device, std::string_view channel, Instant now, Duration staleAfter = std::chrono::seconds(2));

/// A value as it stands in every place of the window that shows what a device measures now.
struct LiveText {
    QString number; ///< "–" where nothing is known
    QString unit;   ///< that of the channel even then; empty where the device has no such channel

    [[nodiscard]] bool isKnown() const;
    /// "60 000 counts/s", "–"
    [[nodiscard]] QString whole() const;
};
[[nodiscard]] LiveText liveText(const DeviceView &device, std::string_view channel, Instant now);
/// The same of a value that a channel had.
[[nodiscard]] LiveText liveText(const Channel &row, std::optional<double> value);

} // namespace mb
