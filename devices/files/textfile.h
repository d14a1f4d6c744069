// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/result.h"

#include <cstddef>
#include <string>

namespace mb {

/// The whole of a regular file, byte for byte. Fault::OutOfRange with path and cause when there is none, when it is
/// something else (a directory, a pipe), may not be read, or is longer than `maxBytes`. Blocks as long as the disk
/// does.
[[nodiscard]] Result<std::string> readTextFile(const std::string &path, std::size_t maxBytes);

} // namespace mb
