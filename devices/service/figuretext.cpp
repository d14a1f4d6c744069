// SPDX-License-Identifier: GPL-3.0-or-later
#include "service/figuretext.h"

#include "experiment/metrics.h"
#include "service/recipe.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mb::service {
namespace {

struct Row {
    std::string_view key;
    const char *name;
};

constexpr std::array<Row, 15> rows{{
    {"rise", MB_LABEL("rise")},
    {"settle", MB_LABEL("settle")},
    {"overshoot", MB_LABEL("overshoot")},
    {"undershoot", MB_LABEL("undershoot")},
    {"sse", MB_LABEL("error at rest")},
    {"iae", "IAE"},
    {"itae", "ITAE"},
    {"peak_current", MB_LABEL("peak current")},
    {"rms_duty", MB_LABEL("chatter of the duty")},
    {"saturated", MB_LABEL("time at the duty limit")},
    {"noise", MB_LABEL("noise")},
    {figure::resistance, MB_LABEL("resistance")},
    {figure::friction, MB_LABEL("friction")},
    {figure::gain, MB_LABEL("gain")},
    {figure::encoder, MB_LABEL("encoder")},
}};

double threeDigits(double number)
{
    if (number == 0.0 || !std::isfinite(number))
        return 0.0;
    const double perUnit = std::pow(10.0, std::max(0.0, 2.0 - std::floor(std::log10(std::abs(number)))));
    return std::round(number * perUnit) / perUnit; // a quotient of whole numbers is the nearest to its decimals
}

} // namespace

Message figureName(std::string_view key)
{
    const auto *const row = std::ranges::find(rows, key, &Row::key);
    return row == rows.end() ? Message::verbatim(std::string(key)) : Message::label(row->name);
}

MessageNumber figureNumber(std::string_view key, double value)
{
    if (const tuning::MetricKey *const metric = tuning::findMetric(key))
        return {threeDigits(value * metric->scale), -1, std::string(metric->unit)};
    return {threeDigits(value), -1, key == figure::resistance ? "Ω" : ""};
}

} // namespace mb::service
