// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/result.h"

#include <string>
#include <string_view>

namespace mb::console {

/// The exit statuses of docs/names.md#exit-statuses.
enum Exit {
    exitDone = 0,
    exitDevice = 1, ///< the device answered with an error, or a read-back or verification differs
    exitUsage = 2,  ///< wrong usage or input; nothing was sent
    exitSilent = 3, ///< no such device, or no answer
    exitSafety = 4, ///< stopped for safety
    exitLink = 5,   ///< a link cannot be opened or was lost
};

/// `sent`: something has gone out, so that whatever is refused now is no wrong usage any more.
[[nodiscard]] int exitStatusOf(Fault fault, bool sent);
/// One line: the cause, and what helps. `verb`: that was run, whose page of the help is named where nothing better is known.
[[nodiscard]] std::string lineOf(const Error &error, std::string_view verb);
/// The same as `{"error":{"status","fault","cause","remedy"}}`.
[[nodiscard]] std::string jsonOf(const Error &error, int status, std::string_view verb);

/// Of what is refused before a verb begins: wrong usage, with the remedy that it would have had otherwise.
[[nodiscard]] Error asUsage(const Error &error);

} // namespace mb::console
