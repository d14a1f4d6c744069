// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/plots/plotboard.h"
#include "widgets/plots/triggerbar.h"
#include "widgets/plots/triggerwatch.h"

namespace mb {

/// The trigger of a page of plots: its bar, its line in the plots and the watch for it are one. Off at first, with the bar
/// hidden. GUI thread.
class TriggerControl : public QObject {
    Q_OBJECT
public:
    TriggerControl(PlotStack &stack, PlotBoard &board, const ThemeSource &theme, QWidget *parent);

    [[nodiscard]] TriggerBar &bar() { return *m_bar; }
    [[nodiscard]] const TriggerWatch &watch() const { return m_watch; }
    /// Shows the line and arms it on a trace; the level is the middle of what is seen unless one was typed.
    void armOn(int id);
    void disarm();
    /// On the first trace, if there is one; or off.
    void setOn(bool on);
    /// Other traces are on the board.
    void follow();
    /// Call it on every tick, before the stack is refreshed.
    void poll(double now) { m_watch.poll(now); }

Q_SIGNALS:
    void armedChanged(bool armed);

private:
    void arm();
    void showLine();

    PlotStack &m_stack;
    PlotBoard &m_board;
    TriggerBar *m_bar;
    TriggerWatch m_watch;
};

} // namespace mb
