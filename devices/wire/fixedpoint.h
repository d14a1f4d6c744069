// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>

namespace mb {

/// Nearest integer to `value * one`, where `one` is the raw value of 1.0 (65536 for 16.16, 256 for 8.8). Nearest, so that a
/// text that was read, shown and entered again gives the same raw value. The caller checks the range of the wire type.
[[nodiscard]] inline std::int64_t toFixed(double value, double one)
{
    return std::llround(value * one);
}

[[nodiscard]] constexpr double fromFixed(std::int64_t raw, double one)
{
    return static_cast<double>(raw) / one;
}

} // namespace mb
