// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/traceraster.h"

#include <algorithm>
#include <cmath>

namespace mb {
namespace {

constexpr float Far = 1e6F;
constexpr int Opaque = 256;
constexpr int Ahead = 12;     ///< columns
constexpr int MostAhead = 16; ///< rows

/// `part` (0 … 256) of the colour over what is there.
QRgb mixed(QRgb below, QRgb color, int part)
{
    const auto above = static_cast<quint32>(part);
    const auto rest = static_cast<quint32>(Opaque - part);
    const quint32 redBlue = ((color & 0xFF00FFU) * above + (below & 0xFF00FFU) * rest) >> 8U;
    const quint32 alphaGreen = ((color >> 8U) & 0xFF00FFU) * above + ((below >> 8U) & 0xFF00FFU) * rest;
    return (redBlue & 0xFF00FFU) | (alphaGreen & 0xFF00FF00U);
}

/// The pixels of one column of the picture, below each other.
struct PixelColumn {
    QRgb *pixels;
    std::ptrdiff_t stride;
    int height;

    void fill(float top, float bottom, QRgb color) const
    {
        top = std::max(top, 0.0F);
        bottom = std::min(bottom, static_cast<float>(height));
        if (top >= bottom)
            return;
        const int first = static_cast<int>(top);
        const int last = static_cast<int>(bottom);
        if (first == last) {
            blend(first, color, bottom - top);
            return;
        }
        blend(first, color, static_cast<float>(first + 1) - top);
        QRgb *pixel = pixels + (first + 1) * stride;
        for (int row = first + 1; row < last; ++row, pixel += stride)
            *pixel = color;
        if (last < height)
            blend(last, color, bottom - static_cast<float>(last));
    }

private:
    void blend(int row, QRgb color, float part) const
    {
        QRgb &pixel = pixels[row * stride];
        pixel = mixed(pixel, color, static_cast<int>(part * Opaque + 0.5F));
    }
};

} // namespace

/// Takes points in the order of time and notes what each column sees of them and of the lines between them.
class TraceRaster::Collector {
public:
    Collector(TraceRaster &raster, const PixelMap &map, int width)
        : m_raster(raster)
        , m_map(map)
        , m_width(width)
        , m_before(-map.keyOffset / map.keyScale)
    {
    }

    /// From `point` to the end of the column that it is in, or to a gap; yields where to go on.
    const PlotPoint *add(const PlotPoint *point, const PlotPoint *end)
    {
        const double x = m_map.x(point->key);
        const double y = m_map.y(point->value);
        if (m_open)
            cross(x, y);
        m_column = columnOf(x);
        const double next = m_column < 0 ? m_before : (m_column + 1 - m_map.keyOffset) / m_map.keyScale;
        double low = point->value;
        double high = low;
        const PlotPoint *last = point;
        while (++point != end && point->key < next && std::isfinite(point->value)) {
            low = std::min(low, point->value);
            high = std::max(high, point->value);
            last = point;
        }
        m_x = m_map.x(last->key);
        m_y = m_map.y(last->value);
        m_open = true;
        finish(m_map.y(low), m_map.y(high));
        return point;
    }

    void breakLine() { m_open = false; }

private:
    /// −1 before the first, `width` after the last.
    int columnOf(double x) const { return static_cast<int>(std::clamp(x, -1.0, m_width + 0.0) + 1.0) - 1; }

    void finish(double low, double high)
    {
        if (m_column < 0 || m_column >= m_width)
            return;
        Column &column = touch(m_column);
        column.top = std::min(column.top, static_cast<float>(std::min(low, high)));
        column.bottom = std::max(column.bottom, static_cast<float>(std::max(low, high)));
    }

    /// The line from the last point to this one, in another column.
    void cross(double x, double y)
    {
        const int last = columnOf(x);
        const double slope = (y - m_y) / (x - m_x);
        for (int border = std::max(m_column + 1, 0); border <= std::min(last, m_width); ++border) {
            const auto at = static_cast<float>(m_y + slope * (border - m_x));
            if (border > 0)
                pass(border - 1, at);
            if (border < m_width)
                pass(border, at);
        }
    }

    void pass(int index, float y)
    {
        Column &column = touch(index);
        column.least = std::min(column.least, y);
        column.greatest = std::max(column.greatest, y);
    }

    Column &touch(int index)
    {
        m_raster.m_first = std::min(m_raster.m_first, index);
        m_raster.m_last = std::max(m_raster.m_last, index);
        return m_raster.m_columns[static_cast<std::size_t>(index)];
    }

    TraceRaster &m_raster;
    const PixelMap &m_map;
    int m_width;
    double m_before; ///< key of the left edge
    bool m_open = false;
    int m_column = 0;
    double m_x = 0.0; ///< of the last point
    double m_y = 0.0;
};

void TraceRaster::draw(QImage &image, const QRect &clip, const std::vector<PlotPoint> &points, const PixelMap &map,
    const TraceStroke &stroke)
{
    const QRect inside = clip & image.rect();
    if (inside != clip || clip.isEmpty())
        return;
    collect(points, map, clip.width());
    const auto width = static_cast<float>(stroke.width);
    slim(width);
    dilate(width / 2);
    const int period = stroke.dash + stroke.pause;
    const double begin = period > 0 ? std::fmod(std::floor(-map.keyOffset + 0.5), period) : 0.0;
    paint(image, clip, stroke, static_cast<int>(begin < 0 ? begin + period : begin));
}

void TraceRaster::collect(const std::vector<PlotPoint> &points, const PixelMap &map, int width)
{
    m_columns.assign(static_cast<std::size_t>(width), Column{Far, -Far, Far, -Far});
    m_first = width;
    m_last = -1;
    Collector collector(*this, map, width);
    const PlotPoint *end = points.data() + points.size();
    for (const PlotPoint *point = points.data(); point != end;) {
        if (std::isfinite(point->value)) {
            point = collector.add(point, end);
        } else {
            collector.breakLine();
            ++point;
        }
    }
}

/// A line that passes with slope s covers width · √(1 + s²) of its column, which is less than s + width; a sample is
/// covered wholly.
void TraceRaster::slim(float width)
{
    for (int i = m_first; i <= m_last; ++i) {
        Column &column = m_columns[static_cast<std::size_t>(i)];
        const float slope = column.greatest - column.least;
        if (slope < 0) { // no line passes
            column.least = column.top;
            column.greatest = column.bottom;
            continue;
        }
        const float half = std::min(slope, width * (std::sqrt(1 + slope * slope) - 1)) / 2;
        const float middle = (column.least + column.greatest) / 2;
        column.least = std::min(column.top, middle); // for the columns beside, when the brush is wide
        column.greatest = std::max(column.bottom, middle);
        column.top = std::min(column.top, middle - half);
        column.bottom = std::max(column.bottom, middle + half);
    }
}

/// A round brush: above and below by its radius, and into the columns beside.
void TraceRaster::dilate(float radius)
{
    const int reach = static_cast<int>(radius);
    const int end = static_cast<int>(m_columns.size()) - 1;
    const int from = std::max(m_first - reach, 0);
    const int to = std::min(m_last + reach, end);
    for (int i = from; i <= to; ++i) {
        Column &column = m_columns[static_cast<std::size_t>(i)];
        column.top -= radius;
        column.bottom += radius;
        for (int beside = std::max(i - reach, 0); reach > 0 && beside <= std::min(i + reach, end); ++beside) {
            const auto distance = static_cast<float>(beside - i);
            const float height = std::sqrt(radius * radius - distance * distance);
            const Column &other = m_columns[static_cast<std::size_t>(beside)];
            column.top = std::min(column.top, other.least - height);
            column.bottom = std::max(column.bottom, other.greatest + height);
        }
    }
    if (m_last >= m_first) {
        m_first = from;
        m_last = to;
    }
}

/// The rows of a picture are far from each other: what a column needs comes too late when it is asked for then.
void TraceRaster::prefetch(const QRgb *pixels, std::ptrdiff_t stride, const Column &column, int height)
{
    const auto limit = static_cast<float>(height - 1);
    const auto first = static_cast<int>(std::clamp(column.top, 0.0F, limit));
    const auto last = static_cast<int>(std::clamp(column.bottom, 0.0F, limit));
    for (int row = first; row <= std::min(last, first + MostAhead); ++row)
        __builtin_prefetch(pixels + row * stride, 1);
}

void TraceRaster::paint(QImage &image, const QRect &clip, const TraceStroke &stroke, int phase) const
{
    const auto stride = static_cast<std::ptrdiff_t>(image.bytesPerLine()) / static_cast<std::ptrdiff_t>(sizeof(QRgb));
    QRgb *corner = reinterpret_cast<QRgb *>(image.bits()) + clip.top() * stride + clip.left();
    const int period = stroke.dash + stroke.pause;
    for (int i = m_first; i <= m_last; ++i) {
        const Column &column = m_columns[static_cast<std::size_t>(i)];
        if (i + Ahead <= m_last)
            prefetch(corner + i + Ahead, stride, m_columns[static_cast<std::size_t>(i + Ahead)], clip.height());
        const PixelColumn pixels{corner + i, stride, clip.height()};
        const bool steep = column.bottom - column.top - static_cast<float>(stroke.width) > 1.0F;
        if (period > 0 && steep) { // its dashes lie below each other
            const auto step = static_cast<float>(period);
            for (float top = std::floor(column.top / step) * step; top < column.bottom; top += step)
                pixels.fill(std::max(column.top, top), std::min(column.bottom, top + static_cast<float>(stroke.dash)),
                    stroke.color);
        } else if (period == 0 || (i + phase) % period < stroke.dash) {
            pixels.fill(column.top, column.bottom, stroke.color);
        }
    }
}

} // namespace mb
