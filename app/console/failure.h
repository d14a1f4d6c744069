// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/result.h"

#include <string>

namespace mb::console {

/// The exit statuses of product.md, "Console verbs".
enum Exit {
    exitDone = 0,
    exitDevice = 1, ///< the device answered with an error, or a read-back or verification differs
    exitUsage = 2,  ///< wrong usage or input; nothing was sent
    exitSilent = 3, ///< no such device, or no answer
    exitSafety = 4, ///< stopped for safety
    exitLink = 5,   ///< a link cannot be opened or was lost
};

[[nodiscard]] int exitStatusOf(Fault fault);
/// One line: the cause, and what helps.
[[nodiscard]] std::string lineOf(const Error &error);

} // namespace mb::console
