// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiment/kepttrial.h"
#include "model/family.h"
#include "widgets/common/displayunits.h"
#include "widgets/common/theme.h"
#include "widgets/plots/curvelegend.h"

#include <QWidget>

namespace mb {

class PlotStack;
struct PlotPoint;
struct TraceStyle;

/// What one or two trials did, over the same t = 0: the measured value with set-point, ±2 % band and marks, below it duty and
/// current. A is the pinned one, dashed with hollow squares; B the current one, drawn heavier. Cursors (L) can be dragged;
/// they stand at the settling of A and B first.
class ResponsePlot : public QWidget {
    Q_OBJECT
public:
    explicit ResponsePlot(const ThemeSource &theme, QWidget *parent = nullptr);

    /// nullptr: none. With their signals. `family` tells quantities and units of the channels.
    void setTrials(const Family *family, const KeptTrial *a, const KeptTrial *b, const DisplayUnits &units);
    /// What the lines are stands in the plot, too; else in pictures of it only.
    void setHead(bool shown);
    /// What a screen reader says of it.
    [[nodiscard]] QString summary() const;
    [[nodiscard]] PlotStack &stack() { return *m_stack; }
    /// What the lines of the first strip are, which has no head of its own.
    [[nodiscard]] const std::vector<CurveLegend::Entry> &legend() const { return m_legend; }

Q_SIGNALS:
    /// There is room for more strips, or for fewer: setTrials() draws them.
    void roomChanged();

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    struct Side {
        const KeptTrial *kept = nullptr;
        QString letter;
        bool current = false;
    };
    void add(const Family &family, const Side &side, std::string_view channel, int strip, const DisplayUnits &units);
    void addSetPoint(const tuning::Trial &trial, const ShownUnit &unit, double length);
    void addMarks(const Side &a, const Side &b, const ShownUnit &unit);
    void addSpans(const Side &a, const Side &b);
    void addLimits(const tuning::Trial &trial, int strip, std::string_view channel);

    void addLine(const TraceStyle &style, std::vector<PlotPoint> points);
    void fitStrips();
    void showHead(bool shown);
    [[nodiscard]] static QString footNoteOf(const tuning::Trial &trial);
    /// Strips that are not flat: the measured value, duty, current.
    [[nodiscard]] int strips() const;

    const ThemeSource &m_theme;
    int m_drawnStrips = 3;
    bool m_hasHead = false;
    PlotStack *m_stack = nullptr;
    double m_length = 0.0;          ///< s, of the longest response
    bool m_isWithoutReturn = false; ///< each is drawn as long as it was held
    std::vector<CurveLegend::Entry> m_legend;
};

} // namespace mb
