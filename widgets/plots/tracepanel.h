// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/plots/plotboard.h"

namespace mb {

class TraceList;

/// Beside the plots: what is plotted, with rate, loss and value or what lies between the cursors, and below it every
/// signal that could be. GUI thread.
class TracePanel : public QWidget {
    Q_OBJECT
public:
    TracePanel(Workbench &workbench, PlotStack &stack, PlotBoard &board, const ThemeSource &theme, QWidget *parent);
    [[nodiscard]] QSize sizeHint() const override;

    [[nodiscard]] SignalList &signalList() { return *m_signals; }
    /// Other traces are on the board.
    void followBoard();
    /// Numbers may be others.
    void showRows();

Q_SIGNALS:
    void derivedRequested();
    void spectrumRequested();
    /// Watch for an event of this trace.
    void triggerRequested(int id);

private:
    void buildLists();
    [[nodiscard]] QString statisticsOf(const PlotBoard::Trace &trace) const;
    /// In the digits of its axis, without a unit.
    [[nodiscard]] QString bareText(const PlotBoard::Trace &trace, double value) const;
    void showMenu(int id, const QPoint &at);

    Workbench &m_workbench;
    PlotStack &m_stack;
    PlotBoard &m_board;
    const ThemeSource &m_theme;
    TraceList *m_list = nullptr;
    SignalList *m_signals = nullptr;
};

} // namespace mb
