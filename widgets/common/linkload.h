// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/snapshot.h"

namespace mb {

/// Fraction of the line in use, 0…1; NaN where its rate is not known, which is shown as "–". Of CAN 1 Mbit/s is assumed then.
[[nodiscard]] double loadOf(const LinkView &link);

} // namespace mb
