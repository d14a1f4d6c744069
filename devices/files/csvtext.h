// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace mb {

/// A line of a table with commas, its end included; cells that need it are in quotes.
[[nodiscard]] std::string csvRow(const std::vector<std::string> &cells);
/// "2023-11-14T22:13:20Z" of Unix time: the same on every computer, so that tables can be joined.
[[nodiscard]] std::string csvTime(double unixTime);

} // namespace mb
