// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/result.h"

#include <string>
#include <vector>

namespace mb::console {

/// The program with the window, which paints, takes the place of this one with these words: what it says and its exit status are
/// ours, and this program links nothing of a screen. Comes back only with why it cannot be run. Descriptors without FD_CLOEXEC
/// stay open, and signals are kept back until that program heeds them.
[[nodiscard]] Error becomeWindow(std::vector<std::string> words);

} // namespace mb::console
