// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/parameterfile.h"

#include <cmath>
#include <string>

namespace mb::tuning {

/// "12.5 %"
[[nodiscard]] inline std::string percentText(double share)
{
    return numberText(std::round(share * 1000.0) / 10.0) + " %";
}
/// "250 ms"
[[nodiscard]] inline std::string millisecondsText(double seconds)
{
    return numberText(std::round(seconds * 1000.0)) + " ms";
}

} // namespace mb::tuning
