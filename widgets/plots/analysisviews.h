// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/plots/curveplot.h"
#include "widgets/plots/plotboard.h"

class QComboBox;
class QMenu;

namespace mb {

// Other views of what a stack of plots shows: of A … B while the cursors are shown, of what is seen otherwise.

/// Adds what can be copied and exported of a plot of curves; a file that was written, or could not be, is reported.
void fillExportMenu(QMenu &menu, CurvePlot &plot, Workbench &workbench);

/// One signal against another, both chosen above the plot. GUI thread.
class AgainstView : public QWidget {
    Q_OBJECT
public:
    AgainstView(PlotStack &stack, PlotBoard &board, const ThemeSource &theme, QWidget *parent);
    [[nodiscard]] CurvePlot &plot() { return *m_plot; }
    /// Other signals are on the board.
    void follow();
    void refresh();

private:
    PlotStack &m_stack;
    PlotBoard &m_board;
    CurvePlot *m_plot;
    std::vector<Signal> m_listed; ///< what both boxes offer
    QComboBox *m_across;
    QComboBox *m_upwards;
};

/// Amplitude of every signal against frequency. GUI thread.
class SpectrumView : public QWidget {
    Q_OBJECT
public:
    SpectrumView(PlotStack &stack, PlotBoard &board, const ThemeSource &theme, QWidget *parent);
    [[nodiscard]] CurvePlot &plot() { return *m_plot; }
    /// Other traces are on the board.
    void follow();
    void refresh();

private:
    PlotStack &m_stack;
    PlotBoard &m_board;
    CurvePlot *m_plot;
};

} // namespace mb
