// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/family.h"

namespace mb::dmc60c {

/// Finds the units of a bus (README.md#enumeration): three windows of 150 ms, their union paired by number and session; up to
/// three more while half an answer is missing. Descriptors are read one device at a time in the quiet part of the windows. Only gets,
/// never a set. Unsupported when the link is no CAN link.
[[nodiscard]] Task<void> scan(Link &link, Clock &clock, ScanSink &sink);

} // namespace mb::dmc60c
