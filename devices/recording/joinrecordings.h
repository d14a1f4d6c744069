// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "recording/export.h"

#include <string>
#include <vector>

namespace mb {

/// A fact of a channel in files that are joined: channels that have the same are one unit's, though it told its serial number late.
inline constexpr const char *trackFact = "track";

/// Several files of McapWriter as one: a topic of one unit and one serial number is one channel, and of facts the last count. Nothing
/// is left at `path` where it fails: Unsupported where they have nothing, Refused where one of them cannot be read.
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
