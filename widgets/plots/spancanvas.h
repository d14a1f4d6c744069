// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/plots/qcustomplotkeywords.h"

#include <QImage>

namespace mb {

/// The dense columns of all traces of a strip: written into one image, which is drawn once above the lines. Thousands of
/// vertical lines cost a painter several times as much. Traces add while they are drawn; on a layer above theirs.
class SpanCanvas : public QCPAbstractItem {
    Q_OBJECT
public:
    explicit SpanCanvas(QCPAxisRect &rect);

    /// Vertical lines one device pixel wide. `ratio`: device pixels for each pixel of the plot.
    void add(const QVector<QLineF> &spans, const QColor &color, double ratio);
    double selectTest(const QPointF &, bool, QVariant * = nullptr) const override { return -1; }

protected:
    void draw(QCPPainter *painter) override;

private:
    void begin(double ratio);

    QCPAxisRect &m_rect;
    QImage m_image;
    double m_ratio = 1.0;
    bool m_begun = false; ///< something was added since the last time it was drawn
    int m_top = 0;        ///< rows that are not empty: from here
    int m_bottom = -1;    ///< to here
};

} // namespace mb
