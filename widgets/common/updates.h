// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/snapshot.h"

#include <QString>

#include <string_view>
#include <vector>

namespace mb {

/// Firmware that is being written now, whatever is selected. Pointers into the snapshot.
[[nodiscard]] std::vector<const OperationView *> runningUpdates(const Snapshot &shot);
/// The one that has this link for itself; nullptr while nothing is written there.
[[nodiscard]] const OperationView *updateOn(const Snapshot &shot, std::string_view link);
/// "DMC60C #9 on sim:can": which unit an operation is about.
[[nodiscard]] QString placeOf(const Snapshot &shot, const OperationView &operation);

} // namespace mb
