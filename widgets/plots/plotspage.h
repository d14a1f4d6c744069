// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/selection.h"
#include "widgets/common/workbench.h"
#include "widgets/plots/displayunits.h"
#include "widgets/plots/plotstack.h"
#include "widgets/plots/signallist.h"
#include "widgets/plots/telemetrysource.h"

#include <QTimer>
#include <QWidget>

#include <vector>

class QComboBox;
class QHBoxLayout;
class QStackedWidget;

namespace mb {

class CommandButton;
class EmptyState;
class IconButton;
class PlotStack;
class TraceList;

/// Signals of any devices against time, live: one strip for each unit, what is plotted and what could be at the right.
/// Starts with position, velocity, current and duty of the selected device. Fetches and draws only while it is visible
/// and something is new.
class PlotsPage : public QWidget {
    Q_OBJECT
public:
    PlotsPage(Workbench &workbench, Selection &selection, const ThemeSource &theme, QWidget *parent);

    void addSignal(const Signal &signal);
    void removeSignal(const Signal &signal);
    [[nodiscard]] std::size_t traceCount() const { return m_traces.size(); }
    [[nodiscard]] PlotStack &stack() { return *m_stack; }
    [[nodiscard]] SignalList &signalList() { return *m_signals; }

protected:
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;

private:
    struct Trace {
        Signal signal;
        std::shared_ptr<TelemetrySource> source;
        TraceStyle style;
        int id = 0; ///< in the stack
    };
    QWidget *buildBar();
    void buildView(QHBoxLayout &row);
    QWidget *buildPlots();
    QWidget *buildSide();
    void follow();
    void followRates();
    void takeDefaults();
    void rebuild();
    void choose(const Signal &signal, bool on);
    void showRows();
    void tick();
    [[nodiscard]] std::uint64_t revision() const;

    Workbench &m_workbench;
    Selection &m_selection;
    const ThemeSource &m_theme;
    DisplayUnits m_units;
    std::vector<Trace> m_traces;
    bool m_touched = false; ///< by a person: the defaults do not follow the selection any more
    DeviceId m_defaultsOf;
    std::uint64_t m_drawn = 0;
    double m_drawnAt = 0.0;
    QTimer m_tick;
    QStackedWidget *m_pages = nullptr;
    EmptyState *m_empty = nullptr;
    QStackedWidget *m_plots = nullptr;
    PlotStack *m_stack = nullptr;
    QComboBox *m_window = nullptr;
    CommandButton *m_pause = nullptr;
    TraceList *m_list = nullptr;
    SignalList *m_signals = nullptr;
};

} // namespace mb
