// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/plots/plotdecor.h"

namespace mb {

/// Behind the traces: watermark, bands, spans, gaps.
class StripBackdrop : public QCPAbstractItem {
    Q_OBJECT
public:
    StripBackdrop(QCPAxisRect &rect, const ThemeSource &theme, const StripDecor &decor);
    double selectTest(const QPointF &, bool, QVariant * = nullptr) const override { return -1; }

protected:
    void draw(QCPPainter *painter) override;

private:
    void drawWatermark(QCPPainter &painter, const QRectF &box) const;
    void drawBands(QCPPainter &painter, const QRectF &box) const;
    void drawSpans(QCPPainter &painter, const QRectF &box) const;
    void drawGaps(QCPPainter &painter, const QRectF &box) const;

    QCPAxisRect &m_rect;
    const ThemeSource &m_theme;
    const StripDecor &m_decor;
};

} // namespace mb
