// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/snapshot.h"

#include <QString>

#include <optional>
#include <string>
#include <vector>

namespace mb {

class Workbench;

/// Firmware that is being written now, whatever is selected, and whoever has begun it: what a queue writes has no id, for it is
/// no operation that could be cancelled by itself, and no log.
[[nodiscard]] std::vector<OperationView> runningUpdates(const Workbench &workbench);
/// The one that has this link for itself; nothing while nothing is written there.
[[nodiscard]] std::optional<OperationView> updateOn(const Workbench &workbench, const std::string &link);
/// A queue has this link for itself, also between two updates.
[[nodiscard]] bool isServed(const Workbench &workbench, const std::string &link);
/// "DMC60C #9 on sim:can": which unit an operation is about.
[[nodiscard]] QString placeOf(const Snapshot &shot, const OperationView &operation);
/// What a cancel leaves after so many pages.
[[nodiscard]] QString leftAfter(int pages, const UpdateWords &words);

} // namespace mb
