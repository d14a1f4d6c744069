// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/columnpath.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mb {
namespace {

/// The points of one pixel column, in pixels: all of them while they are few, else its two ends.
struct PathColumn {
    static constexpr int Few = 4;
    double index = 0.0;
    std::array<QPointF, Few> points;
    QPointF last;
    int count = 0;
    double top = 0.0;
    double bottom = 0.0;

    bool dense() const { return count > 2 && bottom - top >= 1.0; }
};

class PathBuilder {
public:
    PathBuilder(const PixelMap &map, ColumnPath &path)
        : m_map(map)
        , m_path(path)
        , m_perColumn(1.0 / map.columnWidth)
    {
    }

    void add(const PlotPoint &point)
    {
        const QPointF at(m_map.x(point.key), m_map.y(point.value));
        const double index = std::floor(at.x() * m_perColumn);
        if (m_column.count > 0 && index != m_column.index)
            finishColumn();
        if (m_column.count == 0) {
            m_column.index = index;
            m_column.top = m_column.bottom = at.y();
        }
        if (m_column.count < PathColumn::Few)
            m_column.points[static_cast<std::size_t>(m_column.count)] = at;
        m_column.last = at;
        ++m_column.count;
        m_column.top = std::min(m_column.top, at.y());
        m_column.bottom = std::max(m_column.bottom, at.y());
    }

    void breakLine()
    {
        finishColumn();
        finishLine();
        m_haveLast = false;
    }

private:
    void finishColumn()
    {
        if (m_column.count == 0)
            return;
        if (m_column.dense())
            addSpan();
        else
            addLine();
        m_last = m_column.last;
        m_haveLast = true;
        m_column.count = 0;
    }

    void addLine()
    {
        if (m_line.isEmpty() && m_haveLast)
            m_line << m_last;
        // Several points that are less than a pixel apart are as good as their ends.
        const int visible = m_column.count > 2 ? 1 : m_column.count;
        for (int i = 0; i < visible; ++i)
            m_line << m_column.points[static_cast<std::size_t>(i)];
        if (m_column.count > 2)
            m_line << m_column.last;
    }

    void addSpan()
    {
        double top = m_column.top;
        double bottom = m_column.bottom;
        const double x = (m_column.index + 0.5) * m_map.columnWidth;
        const bool touching
            = m_haveLast && m_line.isEmpty() && m_column.points[0].x() - m_last.x() < 2 * m_map.columnWidth;
        if (touching) {
            top = std::min(top, m_last.y());
            bottom = std::max(bottom, m_last.y());
        } else if (m_haveLast) {
            if (m_line.isEmpty())
                m_line << m_last;
            m_line << m_column.points[0];
            finishLine();
        }
        m_path.spans << QLineF(x, top, x, bottom);
    }

    void finishLine()
    {
        if (!m_line.isEmpty())
            m_path.lines << m_line;
        m_line.clear();
    }

    const PixelMap &m_map;
    ColumnPath &m_path;
    double m_perColumn;
    PathColumn m_column;
    QPolygonF m_line;
    QPointF m_last;
    bool m_haveLast = false;
};

} // namespace

ColumnPath columnPath(const std::vector<PlotPoint> &points, const PixelMap &map)
{
    ColumnPath path;
    path.spans.reserve(static_cast<int>(points.size() / 3));
    PathBuilder builder(map, path);
    for (const PlotPoint &point : points) {
        if (std::isfinite(point.value))
            builder.add(point);
        else
            builder.breakLine();
    }
    builder.breakLine();
    return path;
}

std::vector<std::pair<double, double>> gapsOf(const std::vector<PlotPoint> &points, double to)
{
    std::vector<std::pair<double, double>> gaps;
    const auto finite = [](const PlotPoint &point) { return std::isfinite(point.value); };
    auto it = points.begin();
    while ((it = std::find_if_not(it, points.end(), finite)) != points.end()) {
        const double begin = it->key;
        it = std::find_if(it, points.end(), finite);
        const double end = it == points.end() ? to : it->key;
        if (begin < end)
            gaps.emplace_back(begin, end);
    }
    return gaps;
}

double valueAt(const std::vector<PlotPoint> &points, double key)
{
    constexpr double Nothing = std::numeric_limits<double>::quiet_NaN();
    const auto after = std::lower_bound(
        points.begin(), points.end(), key, [](const PlotPoint &point, double wanted) { return point.key < wanted; });
    if (after == points.end())
        return Nothing;
    if (after->key <= key)
        return after->value;
    if (after == points.begin())
        return Nothing;
    const PlotPoint &left = *(after - 1);
    const double span = after->key - left.key;
    return span > 0 ? left.value + (after->value - left.value) * (key - left.key) / span : left.value;
}

std::optional<std::pair<double, double>> valueRange(const std::vector<PlotPoint> &points, double from, double to)
{
    const auto before = [](const PlotPoint &point, double key) { return point.key < key; };
    const auto after = [](double key, const PlotPoint &point) { return key < point.key; };
    const auto begin = std::lower_bound(points.begin(), points.end(), from, before);
    const auto end = std::upper_bound(begin, points.end(), to, after);
    constexpr double infinity = std::numeric_limits<double>::infinity();
    double low = infinity;
    double high = -infinity;
    for (auto point = begin; point != end; ++point) {
        const double value = point->value; // what is not finite is neither less nor greater
        low = value < low && value > -infinity ? value : low;
        high = value > high && value < infinity ? value : high;
    }
    if (low > high)
        return {};
    return std::pair(low, high);
}

} // namespace mb
