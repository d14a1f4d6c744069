// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/result.h"
#include "recording/mcapformat.h"

#include <vector>

namespace mb::mcap {

/// The records in a chunk, as they are or unpacked from zstd or lz4. OutOfRange with the cause: damaged, larger than 256 MB, or packed in a
/// way that the specification does not name.
[[nodiscard]] Result<std::vector<std::uint8_t>> recordsOf(View chunk);

} // namespace mb::mcap
