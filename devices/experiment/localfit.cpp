// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiment/localfit.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mb::tuning {

Line fitLine(const std::vector<double> &x, const std::vector<double> &y)
{
    if (x.empty())
        return {};
    const auto n = static_cast<double>(x.size());
    double meanX = 0.0;
    double meanY = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        meanX += x[i] / n;
        meanY += y[i] / n;
    }
    double xx = 0.0;
    double xy = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        xx += (x[i] - meanX) * (x[i] - meanX);
        xy += (x[i] - meanX) * (y[i] - meanY);
    }
    const double slope = xx > 0.0 ? xy / xx : 0.0;
    return {meanY - slope * meanX, slope};
}

std::optional<Parabola> fitParabola(const Trace &trace, double centre, double half, std::size_t begin)
{
    const auto from = trace.t.begin() + static_cast<std::ptrdiff_t>(begin);
    auto at = static_cast<std::size_t>(std::lower_bound(from, trace.t.end(), centre - half) - trace.t.begin());
    std::array<double, 5> s{}; // Σ x^0 … Σ x^4, x in half widths
    std::array<double, 3> r{}; // Σ y x^0 … Σ y x^2
    for (; at < trace.size() && trace.t[at] <= centre + half; ++at) {
        const double x = (trace.t[at] - centre) / half;
        double power = 1.0;
        for (std::size_t k = 0; k < s.size(); ++k, power *= x) {
            s[k] += power;
            if (k < r.size())
                r[k] += power * trace.y[at];
        }
    }
    if (s[0] < 3.0)
        return std::nullopt;
    const double determinant
        = s[0] * (s[2] * s[4] - s[3] * s[3]) - s[1] * (s[1] * s[4] - s[2] * s[3]) + s[2] * (s[1] * s[3] - s[2] * s[2]);
    if (std::abs(determinant) < 1e-12)
        return std::nullopt;
    Parabola fit;
    fit.a
        = (r[0] * (s[2] * s[4] - s[3] * s[3]) - s[1] * (r[1] * s[4] - r[2] * s[3]) + s[2] * (r[1] * s[3] - r[2] * s[2]))
        / determinant;
    fit.b
        = (s[0] * (r[1] * s[4] - r[2] * s[3]) - r[0] * (s[1] * s[4] - s[2] * s[3]) + s[2] * (s[1] * r[2] - s[2] * r[1]))
        / determinant / half;
    fit.c
        = (s[0] * (s[2] * r[2] - s[3] * r[1]) - s[1] * (s[1] * r[2] - s[2] * r[1]) + r[0] * (s[1] * s[3] - s[2] * s[2]))
        / determinant / half / half;
    return fit;
}

std::vector<double> smoothed(const Trace &trace, std::size_t begin, double half)
{
    std::vector<double> values = trace.y;
    for (std::size_t i = begin; i < trace.size(); ++i) {
        if (const auto fit = fitParabola(trace, trace.t[i], half, begin))
            values[i] = fit->a;
    }
    return values;
}

std::optional<double> vertexNear(const Trace &trace, std::size_t at, std::size_t begin, double reach)
{
    const auto fit = fitParabola(trace, trace.t[at], reach, begin);
    if (!fit || fit->c >= 0.0 || std::abs(fit->b / (2.0 * fit->c)) > reach)
        return std::nullopt;
    double lowest = trace.y[at];
    double highest = trace.y[at];
    for (std::size_t i = begin; i < trace.size(); ++i) {
        if (std::abs(trace.t[i] - trace.t[at]) <= reach) {
            lowest = std::min(lowest, trace.y[i]);
            highest = std::max(highest, trace.y[i]);
        }
    }
    // Samples of several runs that lie upon each other in time tell no curve: their parabola may go anywhere.
    const double top = fit->a - fit->b * fit->b / (4.0 * fit->c);
    return top - highest <= highest - lowest ? std::optional(top) : std::nullopt;
}

} // namespace mb::tuning
