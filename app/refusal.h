// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/result.h"

namespace mb {

/// One line on standard error in the words of the console, whose place this program has taken for a picture or a report. Yields the
/// exit status: 2, of wrong input, or 1 where what was made could not be written.
[[nodiscard]] int refuse(const Error &error, bool json);

/// From now on SIGINT, SIGTERM and SIGHUP, and one that came while the console kept them back, end the program with such a line and
/// status 1, whatever it is in the middle of: painting needs no event loop. SIGHUP stays ignored where `nohup` has made it so.
void endOnSignals(bool json);

} // namespace mb
