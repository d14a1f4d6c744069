// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/plots/columnpath.h"

#include <QImage>

namespace mb {

/// How a trace is written into a picture. Lengths in pixels of the picture.
struct TraceStroke {
    QRgb color = 0xFF000000;
    double width = 1.4;
    int dash = 0;  ///< so many columns drawn …
    int pause = 0; ///< … and so many left out; 0: no pattern
};

/// Writes traces, which never turn back in time, straight into the pixels of a picture: for each pixel column what the
/// trace covers of it, antialiased at both ends. A painter needs ten to fifty times as long for the same. What a sample
/// reaches is always covered, so a one-sample spike stays visible at every zoom. Dashes are anchored to key 0 and so
/// travel with the data. Keeps its memory: one for all traces.
class TraceRaster {
public:
    /// `map` yields pixels counted from the upper left corner of `clip`, which lies in the picture; its columns are
    /// pixels. The picture has the format RGB32 or ARGB32_Premultiplied and is not shared with a copy.
    void draw(QImage &image, const QRect &clip, const std::vector<PlotPoint> &points, const PixelMap &map,
        const TraceStroke &stroke);

private:
    /// Of one pixel column: what the line passes through, and what samples reach.
    struct Column {
        float least, greatest;
        float top, bottom;
    };
    class Collector;

    void collect(const std::vector<PlotPoint> &points, const PixelMap &map, int width);
    void slim(float width);
    void dilate(float radius);
    static void prefetch(const QRgb *pixels, std::ptrdiff_t stride, const Column &column, int height);
    void paint(QImage &image, const QRect &clip, const TraceStroke &stroke, int phase) const;

    std::vector<Column> m_columns;
    int m_first = 0; ///< columns that are not empty: from here …
    int m_last = -1; ///< … to here
};

} // namespace mb
