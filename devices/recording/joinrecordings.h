// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "recording/export.h"

#include <string>
#include <vector>

namespace mb {

/// Several files of McapWriter as one: topics and facts joined. Nothing is left at `path` where it fails: Unsupported where they
/// have nothing, Refused where one of them cannot be read.
[[nodiscard]] Result<ExportReport> joinRecordings(
    const std::vector<std::string> &paths, const std::string &path, const ExportProgress &progress);

struct Recovered {
    std::vector<std::string> paths;
    std::vector<Error> failures; ///< of runs that stay for the next time
};

/// Runs that did not end by themselves (killed, power cut) leave their folder behind. Joins each into a file
/// `recovered-NAME.mcap` in `folder` and removes it. Of several programs that begin at once one does.
[[nodiscard]] Recovered recoverRecordings(const std::string &folder);

} // namespace mb
