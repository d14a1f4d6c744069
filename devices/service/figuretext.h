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
    const double perUnit = std::pow(10.0, std::max(0.0, 2.0 - std::floor(std::log10(std::abs(number)))));
    return numberText(
        std::round(number * perUnit) / perUnit); // a quotient of whole numbers is the nearest to its decimals
}

} // namespace mb::service
