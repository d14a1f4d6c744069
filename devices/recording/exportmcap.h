// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "recording/export.h"

namespace mb {

/// What an MCAP file says of a channel.
[[nodiscard]] mcap::Map aboutChannel(const ExportChannel &channel);
/// The samples of all channels as MCAP: see McapWriter. Appears, fails and locks like exportCsv().
[[nodiscard]] Result<ExportReport> exportMcap(
    const ExportPlan &plan, const std::string &path, const ExportProgress &progress);

} // namespace mb
