// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/console.h"
#include "async/task.h"

#include <string>

namespace mb::console {

/// Asks on standard error, and reads a line from the terminal that standard input is; anything but yes is no. The loop goes on
/// meanwhile. Cancelled by a signal, which ends the verb then.
[[nodiscard]] Task<bool> ask(Console &console, std::string question);

/// Yes only from somebody who sits at a terminal and says so; a script is never asked.
[[nodiscard]] Task<bool> isAgreedTo(Console &console, std::string question);

} // namespace mb::console
