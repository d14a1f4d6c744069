// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/parameterfile.h"

#include <cmath>

namespace mb::tuning {

/// "12.5 %"
[[nodiscard]] inline MessageNumber percentText(double share)
{
    return {std::round(share * 1000.0) / 10.0, -1, "%"};
}
/// "250 ms"
[[nodiscard]] inline MessageNumber millisecondsText(double seconds)
{
    return {std::round(seconds * 1000.0), -1, "ms"};
}

} // namespace mb::tuning
