// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/plots/axislabels.h"
#include "widgets/plots/curvemarks.h"
#include "widgets/plots/traceplottable.h"

#include <QWidget>

namespace mb {

/// A line of a CurvePlot.
struct Curve {
    QString name;
    TraceLook look;
    QVector<double> x;
    QVector<double> y;
    /// A band around it, at the same x; empty: none.
    QVector<double> low{};
    QVector<double> high{};
    bool points = false; ///< its values are marks without a line between them
    bool hollow = false; ///< and only their outline
};

/// Values against something else than time: a spectrum, one signal against another. One plot, named axes, a legend
/// above it, a line of words under it. Wheel and drag zoom and move; 0 or a double click fits.
class CurvePlot : public QWidget {
    Q_OBJECT
public:
    CurvePlot(const ThemeSource &theme, const QString &accessibleName, QWidget *parent = nullptr);

    void setAxes(const QString &x, const QString &y, bool logarithmicY, bool logarithmicX = false);
    void setCurves(const std::vector<Curve> &curves);
    /// Drawn behind them, without bands, and no reason for fit() to make room.
    void setBehind(std::vector<Curve> curves);
    /// What stands beside the curves: bands, lines, words at their places.
    void setMarks(std::vector<CurveMark> marks);
    [[nodiscard]] const std::vector<CurveMark> &marks() const { return m_marks->marks(); }
    void setNote(const QString &note);
    /// What stands around the curves; names and notes may have another place on the page.
    struct Surroundings {
        bool legend = true;
        bool note = true;
        bool xLabels = true;
        int left
            = 0; ///< units of room for the labels of y, so that plots below each other stand in line; 0: what they need
        bool unitAtEnd = false; ///< the name of x stands behind its numbers, not below them
    };
    void setSurroundings(const Surroundings &surroundings);
    /// Values of y that fit() shows in any case.
    void setLeastRange(double lower, double upper) { m_least = QCPRange(lower, upper); }
    void setWatermark(const QString &text);
    void fit();
    /// As addPictures() wants it.
    [[nodiscard]] QByteArray contentAs(const QString &kind);
    [[nodiscard]] QPixmap picture() { return m_plot->toPixmap(0, 0, 2.0); }
    [[nodiscard]] const std::vector<Curve> &curves() const { return m_curves; }
    [[nodiscard]] QString note() const { return m_note; }
    QCustomPlot &plot() { return *m_plot; }

protected:
    void keyPressEvent(QKeyEvent *event) override;
    void showEvent(QShowEvent *) override { replotSoon(); }
    void resizeEvent(QResizeEvent *event) override;

private:
    void addBand(const Curve &curve);
    void addCurve(const Curve &curve);
    void setAxis(QCPAxis &axis, const QString &label, bool logarithmic);
    void replotSoon();
    void showLabels();
    void showLegend();
    void showNote();
    void restyle();

    const ThemeSource &m_theme;
    QCustomPlot *m_plot = nullptr;
    QCPTextElement *m_words = nullptr;
    QCPItemText *m_mark = nullptr;
    AxisLabels *m_labels = nullptr;
    QString m_nameOfX;
    CurveMarks *m_marks = nullptr;
    std::vector<Curve> m_curves;
    std::vector<Curve> m_behind;
    Surroundings m_around;
    QCPRange m_least; ///< of no size: whatever the curves have
    QString m_note;
    bool m_fitted = false;
};

} // namespace mb
