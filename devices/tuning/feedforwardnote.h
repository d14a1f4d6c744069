// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tuning/tunereport.h"

namespace mb::tuning {

/// Why F is written as 0, so that one that was there does not stay; empty where the proposed set has none, or has one. `family` tells
/// what the parameters of a tuning from a file are for.
[[nodiscard]] Message feedForwardNote(const TuneReport &report, const Family *family = nullptr);

} // namespace mb::tuning
