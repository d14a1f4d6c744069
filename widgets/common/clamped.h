// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

namespace mb {

/// std::clamp() for bounds that come of a layout: where there is no room between them `low` counts, and std::clamp() may not be asked.
template <class T> [[nodiscard]] constexpr T clamped(T value, T low, T high)
{
    return std::max(low, std::min(value, high));
}

} // namespace mb
