// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/fixedtrace.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mb {
namespace {

using Iterator = std::vector<PlotPoint>::const_iterator;

/// First, smallest, largest and last of a run of finite points, in order of time, each once.
void appendColumn(Iterator begin, Iterator end, std::vector<PlotPoint> &out)
{
    const auto [low, high]
        = std::minmax_element(begin, end, [](const PlotPoint &a, const PlotPoint &b) { return a.value < b.value; });
    std::array<Iterator, 4> picked{begin, std::min(low, high), std::max(low, high), end - 1};
    Iterator last = end;
    for (const Iterator point : picked) {
        if (point != last)
            out.push_back(*point);
        last = point;
    }
}

} // namespace

FixedTrace::FixedTrace(std::vector<PlotPoint> points, QString foot)
    : m_points(std::move(points))
    , m_foot(std::move(foot))
{
}

void FixedTrace::columns(double from, double to, int pixels, std::vector<PlotPoint> &points) const
{
    points.clear();
    const auto before = [](const PlotPoint &point, double key) { return point.key < key; };
    Iterator it = std::lower_bound(m_points.begin(), m_points.end(), from, before);
    if (it != m_points.begin())
        --it;
    const double column = (to - from) / std::max(pixels, 1);
    const auto columnOf = [&](const PlotPoint &point) { return std::floor((point.key - from) / column); };
    while (it != m_points.end()) {
        if (std::isnan(it->value)) {
            points.push_back(*it++);
            continue;
        }
        const double here = columnOf(*it);
        const bool beyond = it->key > to;
        const Iterator end = std::find_if(
            it, m_points.end(), [&](const PlotPoint &p) { return std::isnan(p.value) || columnOf(p) != here; });
        appendColumn(it, beyond ? it + 1 : end, points);
        if (beyond)
            return;
        it = end;
    }
}

std::optional<double> FixedTrace::latest() const
{
    if (m_points.empty() || std::isnan(m_points.back().value))
        return {};
    return m_points.back().value;
}

} // namespace mb
