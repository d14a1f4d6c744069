// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/selection.h"
#include "widgets/common/theme.h"
#include "widgets/connection/devicemodel.h"
#include "widgets/connection/firstselection.h"

#include <QWidget>

#include <functional>
#include <utility>

class QHBoxLayout;
class QMenu;
class QPushButton;
class QTreeView;
class QVBoxLayout;

namespace mb {

class EmptyState;
class IconButton;
class SearchField;

/// The left dock: links, their devices with state, name and live word, the axes of those that have several, and under them
/// channels that a double click, Enter or a drag brings into a plot; rescan, filter; add a link or open the simulated bench.
class DeviceTree : public QWidget {
    Q_OBJECT
public:
    DeviceTree(Workbench &workbench, Selection &selection, const ThemeSource &theme, QWidget *parent = nullptr);
    [[nodiscard]] DeviceModel &model() { return *m_model; }
    [[nodiscard]] QSize sizeHint() const override;
    /// Whether a link, by its address, is opened at every start.
    void setKept(std::function<bool(const QString &)> isKept) { m_isKept = std::move(isKept); }

Q_SIGNALS:
    void addLinkRequested();
    void simulateRequested();
    void closeLinkRequested(const QString &address);
    /// Open it at every start, or no more.
    void keepLinkRequested(const QString &address, bool keep);
    void collapseRequested();
    /// These are to be plotted.
    void plotRequested(const std::vector<mb::Signal> &wanted);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void buildHead(QVBoxLayout &column);
    void buildTree(QVBoxLayout &column);
    void buildFoot(QVBoxLayout &column);
    void choose(const QModelIndex &current);
    [[nodiscard]] bool isSelected(const QModelIndex &row) const;
    void follow();
    void showSelection();
    void addSearch(QMenu &menu, const LinkView &link);
    void expandInserted(const QModelIndex &parent, int first, int last);
    void showMenu(const QPoint &position);

    Workbench &m_workbench;
    Selection &m_selection;
    const ThemeSource &m_theme;
    DeviceModel *m_model = nullptr;
    FirstSelection m_first;
    std::function<bool(const QString &)> m_isKept;
    QTreeView *m_view = nullptr;
    SearchField *m_filter = nullptr;
    bool m_moved = false; ///< what is current, by rows that came or went
    EmptyState *m_empty = nullptr;
    QPushButton *m_waiting = nullptr; ///< new rows that would move what is under the mouse
    IconButton *m_rescan = nullptr;
};

} // namespace mb
