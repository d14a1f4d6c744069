// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/guardian/message.h"
#include "app/guardian/port.h"
#include "model/stopscript.h"
#include "transport/link.h"

#include <optional>

namespace mb {

/// A stop script as it is written to the descriptor of a link.
[[nodiscard]] guardian::Script wireScript(const StopScript &script, Outlet::Form form);
/// The other way round, for what a guardian left behind.
[[nodiscard]] StopScript scriptFromWire(const guardian::Script &script, Outlet::Form form);
/// How a guardian sends there; nothing where nothing can be sent past the link.
[[nodiscard]] std::optional<guardian::PortForm> portFormOf(Outlet::Form form);

} // namespace mb
