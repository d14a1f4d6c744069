// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/snapshot.h"

#include <optional>

namespace mb {

/// What a motor has now of the quantity that a mode commands; nothing while that is not measured.
[[nodiscard]] std::optional<double> presentValue(const DeviceView &view, Mode mode, int axis, Instant now);

} // namespace mb
