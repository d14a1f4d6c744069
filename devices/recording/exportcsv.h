// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "recording/export.h"

namespace mb {

/// A table with one row a time and one column a channel, in order of time; lines with # before it say what the columns
/// are. Numbers with a dot; `nan` where the line is broken. The file appears under its name only when it is complete. OutOfRange when it cannot be made, NotKept
/// when writing fails, Cancelled. Any thread: the recordings are locked a block at a time.
[[nodiscard]] Result<ExportReport> exportCsv(
    const ExportPlan &plan, const std::string &path, const ExportProgress &progress);

} // namespace mb
