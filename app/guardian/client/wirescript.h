// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/guardian/message.h"
#include "model/stopscript.h"
#include "transport/link.h"

namespace mb {

/// A stop script as it is written to the descriptor of a link.
[[nodiscard]] guardian::Script wireScript(const StopScript &script, Outlet::Form form);
/// The other way round, for what a guardian left behind.
[[nodiscard]] StopScript scriptFromWire(const guardian::Script &script, Outlet::Form form);
/// What guardian::makePort() calls this form; nullptr where nothing can be sent past the link.
[[nodiscard]] const char *wordOf(Outlet::Form form);

} // namespace mb
