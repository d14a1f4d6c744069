// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "recording/loadrecording.h"

namespace mb {

void addLoadedChannel(LoadedRecording &loaded, const std::string &title, const std::string &unit);
/// The CSV half of loadRecording().
[[nodiscard]] Result<std::shared_ptr<LoadedRecording>> loadTable(const std::string &path);

} // namespace mb
