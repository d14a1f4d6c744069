// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/plots/plotdecor.h"

namespace mb {

/// In front of the traces and around the strip: unit, title, legend, limits, notes, value tags.
class StripFace : public QCPAbstractItem {
    Q_OBJECT
public:
    StripFace(QCPAxisRect &rect, const ThemeSource &theme, const StripDecor &decor);
    double selectTest(const QPointF &, bool, QVariant * = nullptr) const override { return -1; }
    /// Room that the tags need at the right, from their widest text.
    static int tagWidth(const Theme &theme, const QFont &body, const QString &widest);

protected:
    void draw(QCPPainter *painter) override;

private:
    void drawHead(QCPPainter &painter, const QRectF &box) const;
    void drawKeyUnit(QCPPainter &painter, const QRectF &box) const;
    void drawLimits(QCPPainter &painter, const QRectF &box) const;
    void drawTags(QCPPainter &painter, const QRectF &box) const;
    void drawMarks(QCPPainter &painter, const QRectF &box) const;
    void drawTrigger(QCPPainter &painter, const QRectF &box) const;
    void drawWords(QCPPainter &painter) const;
    void drawLeader(QCPPainter &painter, const PlotNote &note, const QRectF &place) const;
    void drawNote(QCPPainter &painter, const PlotNote &note, const QRectF &place) const;
    void drawFlag(QCPPainter &painter, const PlotMark &mark, const QRectF &place) const;
    QFont caption() const;

    QCPAxisRect &m_rect;
    const ThemeSource &m_theme;
    const StripDecor &m_decor;
};

} // namespace mb
