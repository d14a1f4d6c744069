// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>
#include <string>

namespace mb {

/// Every number of a JSON message by its way from the top, `/pose/x`, `/currents/2`: on and off are 1 and 0, texts and nothing are left
/// out, and of a list only the first 64. Whether it is JSON at all.
bool eachNumber(
    std::span<const unsigned char> json, const std::function<void(const std::string &way, double value)> &tell);

} // namespace mb
