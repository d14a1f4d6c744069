// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiment/localfit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace mb::tuning {
namespace {

constexpr std::size_t fewToSum = 256; ///< whose sums are made anew for each centre

std::optional<Parabola> parabolaOf(const std::array<double, 5> &s, const std::array<double, 3> &r, double half)
{
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

} // namespace

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

MovingParabola::MovingParabola(const Trace &trace, double half, std::size_t begin)
    : m_trace(trace)
    , m_half(half)
    , m_from(begin)
    , m_to(begin)
{
}

/// Sums that were moved on for long, or tell of few samples, would gather errors.
std::optional<Parabola> MovingParabola::fit(double centre)
{
    const auto &t = m_trace.t;
    const auto first = t.begin() + static_cast<std::ptrdiff_t>(m_from);
    const auto from = static_cast<std::size_t>(std::lower_bound(first, t.end(), centre - m_half) - t.begin());
    auto to = std::max(m_to, from);
    while (to < t.size() && t[to] <= centre + m_half)
        ++to;
    const bool anew = to - from <= fewToSum || m_moves >= to - from || from >= m_to;
    const double by = (centre - m_centre) / m_half;
    const std::size_t left = std::exchange(m_from, from);
    const std::size_t right = std::exchange(m_to, to);
    m_centre = centre;
    if (anew) {
        m_moves = 0;
        m_s = {};
        m_r = {};
        add(from, to, 1.0);
    } else {
        ++m_moves;
        shift(by);
        add(left, from, -1.0);
        add(right, to, 1.0);
    }
    return parabolaOf(m_s, m_r, m_half);
}

void MovingParabola::add(std::size_t from, std::size_t to, double sign)
{
    for (std::size_t at = from; at < to; ++at) {
        const double x = (m_trace.t[at] - m_centre) / m_half;
        double power = sign;
        for (std::size_t k = 0; k < m_s.size(); ++k, power *= x) {
            m_s[k] += power;
            if (k < m_r.size())
                m_r[k] += power * m_trace.y[at];
        }
    }
    m_looks += to - from;
}

/// (x − d)^k of each sample, for a centre that is d farther on.
void MovingParabola::shift(double by)
{
    const double square = by * by;
    const auto s = m_s;
    const auto r = m_r;
    m_s[1] = s[1] - by * s[0];
    m_s[2] = s[2] - 2.0 * by * s[1] + square * s[0];
    m_s[3] = s[3] - 3.0 * by * s[2] + 3.0 * square * s[1] - square * by * s[0];
    m_s[4] = s[4] - 4.0 * by * s[3] + 6.0 * square * s[2] - 4.0 * square * by * s[1] + square * square * s[0];
    m_r[1] = r[1] - by * r[0];
    m_r[2] = r[2] - 2.0 * by * r[1] + square * r[0];
}

std::optional<Parabola> fitParabola(const Trace &trace, double centre, double half, std::size_t begin)
{
    return MovingParabola(trace, half, begin).fit(centre);
}

std::vector<double> smoothed(const Trace &trace, std::size_t begin, double half)
{
    std::vector<double> values = trace.y;
    MovingParabola moving(trace, half, begin);
    for (std::size_t i = begin; i < trace.size(); ++i) {
        if (const auto fit = moving.fit(trace.t[i]))
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
