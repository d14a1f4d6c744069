// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"

#include <chrono>

/// How long and how often the verbs wait on a motion: durations of the program's clock.
namespace mb::console {

inline constexpr Duration lookEvery = std::chrono::milliseconds(5);      ///< between two looks at what a device tells
inline constexpr Duration masterListen = std::chrono::milliseconds(150); ///< another master sends at least this often

} // namespace mb::console
