// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/diskthread.h"
#include "widgets/plots/plotboard.h"
#include "widgets/plots/plotlayout.h"

#include <QTimer>

#include <map>
#include <optional>

class QMenu;

namespace mb {

/// With which traces a page of plots begins, and what is kept of it: what its family's layout says, or position, velocity,
/// current and duty, of the selected device until a person chose; then what was there at the end of the last run, and
/// layouts by name. GUI thread. Destroy it before stack and board: it writes what has changed.
class PlotLayoutBook : public QObject {
    Q_OBJECT
public:
    PlotLayoutBook(Workbench &workbench, Selection &selection, PlotStack &stack, PlotBoard &board);
    ~PlotLayoutBook() override;

    /// Where layouts are kept; what was there at the end of the last run comes back. Without it nothing is remembered.
    void setFolder(const QString &folder);
    [[nodiscard]] const PlotLayouts &layouts() const { return m_layouts; }
    [[nodiscard]] PlotLayout current() const;
    /// Traces of devices that are not there yet follow when they come.
    void apply(const PlotLayout &layout);
    void reset();
    /// Devices or the selection may be others.
    void follow();
    /// Soon: what the board or the window has become is kept for the next run.
    void remember() { m_remember.start(); }
    /// What it has become is kept now, for the next window; waits for the disk.
    void finish();
    /// Names are asked above `parent`.
    void fillMenu(QMenu &menu, QWidget &parent);

Q_SIGNALS:
    /// All traces are gone; the usual ones come with the next follow().
    void wasReset();

private:
    void save();
    /// Nothing: it is forgotten.
    void keep(const QString &name, const std::optional<PlotLayout> &layout);
    [[nodiscard]] Result<PlotLayout> load(const QString &name) const;
    void takeDefaults();
    void addFamilyEntries(QMenu &menu);
    [[nodiscard]] std::vector<PlotBoard::Trace> tracesOf(const PlotLayout &layout, DeviceId standIn) const;

    Workbench &m_workbench;
    Selection &m_selection;
    PlotStack &m_stack;
    PlotBoard &m_board;
    PlotLayouts m_layouts;
    std::map<QString, std::optional<PlotLayout>> m_ordered; ///< until a disk has it: what its file will be, or none
    DeviceId m_defaultsOf;
    int m_defaultsOfAxis = 0;
    QTimer m_remember;
    bool m_unsaved = false; ///< said once, not with each change until a disk has room again
    DiskThread m_disk;
};

} // namespace mb
