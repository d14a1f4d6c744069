// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/family.h"

namespace mb::supermodified {

/// Asks every id at every rate with gets only (section 6): the nodes that answered before first, then the usual ids at all rates,
/// then the others. Once known nodes have answered, only their rates are searched again, and silence is waited for as long
/// as their answers take. While a motor is driven on the line its rate is not changed.
[[nodiscard]] Task<void> scan(Link &link, Clock &clock, ScanSink &sink);
/// One id, at every rate.
[[nodiscard]] Task<void> probe(Link &link, Clock &clock, int address, ScanSink &sink);

} // namespace mb::supermodified
