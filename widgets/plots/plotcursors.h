// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"

#include "widgets/plots/qcustomplotkeywords.h"
#include <optional>
#include <vector>

namespace mb {

/// A line of the box beside the cursors.
struct PlotCursorRow {
    QString name;
    QString value;
    bool strong = false;
    int strip = 0;
    QString brief{}; ///< in the box of a strip whose head tells the rest of the name; empty: the name
};

/// Two vertical lines A and B through all strips, their flags, and in each strip a box with its differences: beside B, or
/// where it hides less of the curves.
class PlotCursors : public QCPAbstractItem {
    Q_OBJECT
public:
    using Row = PlotCursorRow;
    PlotCursors(QCustomPlot &plot, const ThemeSource &theme);

    void setRects(std::vector<QCPAxisRect *> rects) { m_rects = std::move(rects); }
    void setRows(std::vector<Row> rows) { m_rows = std::move(rows); }
    const std::vector<Row> &rows() const { return m_rows; }
    double key(bool second) const { return second ? m_b : m_a; }
    void setKey(bool second, double key) { (second ? m_b : m_a) = key; }
    /// Which cursor lies within a few pixels of x: false A, true B.
    std::optional<bool> hit(double x) const;
    /// Where the boxes were drawn.
    const std::vector<QRectF> &boxes() const { return m_boxes; }
    double selectTest(const QPointF &, bool, QVariant * = nullptr) const override { return -1; }

protected:
    void draw(QCPPainter *painter) override;

private:
    double pixel(double key) const;
    void drawLine(QCPPainter &painter, double key, const QString &flag) const;
    void drawBox(QCPPainter &painter, std::size_t strip);
    [[nodiscard]] QRectF boxFor(const QSizeF &size, std::size_t strip);

    const ThemeSource &m_theme;
    std::vector<QCPAxisRect *> m_rects;
    std::vector<Row> m_rows;
    std::vector<QRectF> m_boxes;
    std::vector<std::size_t> m_places; ///< of each strip's box, so that it stays where it is while the curves pass
    double m_a = 0.0;
    double m_b = 0.0;
};

} // namespace mb
