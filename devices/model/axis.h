// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace mb {

/// Axes of a device with several count from 1, and what belongs to one has a key that begins with "ch1." … (docs/names.md#units,
/// "Modes and units"). 0 stands for the device as a whole.
[[nodiscard]] inline std::string axisKey(int axis, std::string_view key)
{
    return axis > 0 ? "ch" + std::to_string(axis) + '.' + std::string(key) : std::string(key);
}

/// The axis that a key belongs to; 0 for one of the whole device.
[[nodiscard]] constexpr int axisOf(std::string_view key)
{
    if (!key.starts_with("ch"))
        return 0;
    int axis = 0;
    for (std::size_t i = 2; i < key.size() && i < 5; ++i) {
        if (key[i] == '.')
            return axis;
        if (key[i] < '0' || key[i] > '9')
            return 0;
        axis = axis * 10 + (key[i] - '0');
    }
    return 0;
}

static_assert(axisOf("ch4.velocity") == 4 && axisOf("velocity") == 0 && axisOf("charge") == 0);

} // namespace mb
