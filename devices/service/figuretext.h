// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/parameter.h"

#include <cmath>
#include <string>

namespace mb::service {

/// A measured number with three digits: "0.0916", "46.1", "4310".
[[nodiscard]] inline std::string figureText(double number)
{
    if (number == 0.0 || !std::isfinite(number))
        return "0";
    const double step = std::pow(10.0, std::min(0.0, std::floor(std::log10(std::abs(number))) - 2.0));
    return numberText(std::round(number / step) * step);
}

} // namespace mb::service
