// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/family.h"

namespace mb::supermodified {

/// Asks with gets only (README.md#scan): the nodes that answered before first, then the usual ids at all rates, then all ids at the rates
/// where somebody answered, or at all rates where nobody did. Once somebody has answered, silence is waited for only as long
/// as four answers take. When all nodes of an earlier scan answered, only their rates are searched again. While a motor is
/// driven on the line its rate is not changed.
[[nodiscard]] Task<void> scan(Link &link, Clock &clock, ScanSink &sink);
/// One id, at every rate.
[[nodiscard]] Task<void> probe(Link &link, Clock &clock, int address, ScanSink &sink);

} // namespace mb::supermodified
