// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/result.h"

namespace mb {

/// One line on standard error in the words of the console, whose place this program has taken for a picture or a report. Yields the
/// exit status: 2, of wrong input, or 1 where what was made could not be written.
[[nodiscard]] int refuse(const Error &error, bool json);

} // namespace mb
