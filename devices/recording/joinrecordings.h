// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "recording/export.h"

#include <string>
#include <vector>

namespace mb {

/// Several files of McapWriter as one: topics and facts joined.
[[nodiscard]] Result<ExportReport> joinRecordings(
    const std::vector<std::string> &paths, const std::string &path, const ExportProgress &progress);

/// Runs that did not end by themselves (killed, power cut) leave their folder behind. Joins each into a file
/// `recovered-NAME.mcap` in `folder` and removes it; yields the files.
[[nodiscard]] Result<std::vector<std::string>> recoverRecordings(const std::string &folder);

} // namespace mb
