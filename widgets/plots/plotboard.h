// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "recording/export.h"
#include "widgets/common/displayunits.h"
#include "widgets/common/selection.h"
#include "widgets/common/workbench.h"
#include "widgets/plots/plotstack.h"
#include "widgets/plots/signalbook.h"
#include "widgets/plots/telemetrysource.h"

namespace mb {

class FixedTrace;

/// What is on the plots page: which signals of which devices, in which pane, on which axis; derived signals; references
/// that were kept; notes. Fills a PlotStack and knows no other widget. GUI thread.
class PlotBoard : public QObject {
    Q_OBJECT
public:
    struct Trace {
        Signal signal;
        QString pane; ///< empty: one pane for each unit
        bool second = false;
        SignalAddress address{}; ///< by which it is found again
        int place = 0;           ///< in the order of all that are wished for
        std::shared_ptr<TelemetrySource> source{};
        const Channel *row = nullptr; ///< what it was dressed by
        TraceStyle style{};
        int id = 0; ///< in the stack
    };
    /// A stretch that was kept: its keys count from the left edge, or from the trigger.
    struct Reference {
        TraceStyle style;
        QString pane;
        std::shared_ptr<const FixedTrace> trace;
        int id = 0;
    };

    PlotBoard(Workbench &workbench, PlotStack &stack, QObject *parent);

    /// Those that are drawn.
    [[nodiscard]] const std::vector<Trace> &traces() const { return m_traces; }
    /// These and those that wait for their device, in order.
    [[nodiscard]] std::vector<const Trace *> wished() const;
    [[nodiscard]] const std::vector<Reference> &references() const { return m_kept.references; }
    /// What can be plotted.
    [[nodiscard]] SignalBook &book() { return m_book; }
    [[nodiscard]] const SignalBook &book() const { return m_book; }
    [[nodiscard]] const Trace *traceOf(int id) const;
    [[nodiscard]] bool isTouched() const { return m_touched; }

    /// Adds or removes a trace. `pane`: empty for the one of its unit.
    void choose(const Signal &signal, bool on, const QString &pane = {});
    /// The pane of a strip; a new one for -1.
    [[nodiscard]] QString paneOf(int strip);
    void moveToPane(int id, const QString &pane);
    void setSecondAxis(int id, bool second);
    /// Everything anew, as a layout says; what is not there yet follows by its address when it comes. Nothing is remembered of a
    /// person's choice when `touched` is false.
    void setTraces(std::vector<Trace> traces, bool touched);
    void reset();

    /// Yields what is wrong with the formula, or adds the signal and plots it.
    [[nodiscard]] Result<void> addDerived(const QString &name, const QString &unit, const QString &formula);
    void removeDerived(int place);

    /// What is seen of the measured traces, kept beside what comes.
    void keepReferences();
    void clearReferences();

    void addNote(double key, const QString &text);
    [[nodiscard]] const std::vector<TimedNote> &notes() const { return m_kept.notes; }

    /// The snapshot is a new one.
    void follow();
    void followRates();
    /// The time that the plots follow: of the link of the first trace, which may be a recording.
    [[nodiscard]] Instant present() const { return m_workbench.presentOf(link()); }
    /// Address of the link of the first trace; empty without one.
    [[nodiscard]] std::string link() const;
    /// Moves when a trace has something new.
    [[nodiscard]] std::uint64_t revision() const;

Q_SIGNALS:
    /// Traces, panes or references are others.
    void changed();

private:
    /// By the workbench, for the next board.
    struct Kept {
        std::vector<Reference> references;
        std::vector<TimedNote> notes;
    };
    void rebuild();
    bool letGo();
    bool takeIn();
    void dress(Trace &trace);
    [[nodiscard]] int stripOf(const QString &pane, const QString &unit);

    Workbench &m_workbench;
    PlotStack &m_stack;
    Kept &m_kept;
    DisplayUnits m_units;
    SignalBook m_book;
    std::vector<Trace> m_traces;
    std::vector<Trace> m_absent;   ///< wished for; their devices are not there
    QStringList m_panes;           ///< key of each strip, while rebuilding and after
    std::vector<TraceLook> m_used; ///< looks of the traces that are there, while rebuilding
    int m_newPanes = 0;
    int m_places = 0;
    bool m_touched = false; ///< by a person: the defaults do not follow the selection any more
};

} // namespace mb
