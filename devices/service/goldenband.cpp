// SPDX-License-Identifier: GPL-3.0-or-later
#include "service/goldenband.h"

#include "service/figuretext.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace mb::service {
namespace {

double medianOf(std::vector<double> values)
{
    std::ranges::sort(values);
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

} // namespace

std::optional<Band> bandOf(const std::vector<Visit> &passed, const std::string &key)
{
    std::map<std::string, double> byUnit;
    for (const Visit &visit : passed) {
        for (const TestValue &value : visit.test) {
            if (value.key == key && value.value && visit.outcome == Outcome::Passed)
                byUnit[numberOwnerOf(visit)] = *value.value;
        }
    }
    if (byUnit.size() < static_cast<std::size_t>(fewestForBand))
        return std::nullopt;
    std::vector<double> values;
    for (const auto &[unit, value] : byUnit)
        values.push_back(value);
    Band band;
    band.median = medianOf(values);
    for (double &value : values)
        value = std::abs(value - band.median);
    band.deviation = medianOf(values);
    band.units = static_cast<int>(values.size());
    return band;
}

Message markUnusual(std::vector<TestValue> &values, const std::vector<Visit> &passed)
{
    Message told;
    for (TestValue &value : values) {
        const auto band = bandOf(passed, value.key);
        value.unusual = band && value.value && (*value.value < band->low() || *value.value > band->high());
        if (value.unusual)
            told = joined(told,
                say("%1 %2 is unusual: %3 units have %4 to %5", figureName(value.key),
                    figureNumber(value.key, *value.value), band->units, figureNumber(value.key, band->low()),
                    figureNumber(value.key, band->high())));
    }
    return told;
}

} // namespace mb::service
