// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "recording/export.h"

namespace mb {

class PlotBoard;
struct Snapshot;

/// The signals that a file of samples gets: everything that there is, or what is plotted.
[[nodiscard]] std::vector<ExportChannel> exportChannels(
    const Snapshot &snapshot, const PlotBoard &board, bool everything);
/// What is known of every device, for the head of the file.
[[nodiscard]] std::vector<std::pair<std::string, mcap::Map>> aboutDevices(const Snapshot &snapshot);

} // namespace mb
