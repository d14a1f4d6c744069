// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace mb {

/// Of an attribute of sysfs, without the end of the line; empty where there is none.
[[nodiscard]] std::string firstLine(const std::filesystem::path &file);

} // namespace mb
