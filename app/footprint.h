// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace mb {

/// Memory of this process that is in RAM now, bytes; 0 when the system does not tell.
[[nodiscard]] std::int64_t residentBytes();

} // namespace mb
