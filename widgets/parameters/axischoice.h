// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/selection.h"
#include "widgets/common/workbench.h"

class QLayout;

namespace mb {

class CommandButton;
class Segmented;
class ThemeSource;

/// Which axis of a board is looked at: all of them, one, or what the board has once; and what one axis takes from another.
/// Its two widgets stand in the row of somebody else and are hidden for devices that have no axes.
class AxisChoice : public QObject {
    Q_OBJECT
public:
    AxisChoice(const ThemeSource &theme, Workbench &workbench, Selection &selection, QWidget &row);

    void addTo(QLayout &row);
    /// px that it takes in a row with this gap, not folded; 0: it is hidden.
    [[nodiscard]] int neededWidth(int gap) const;
    /// The axes as a list that opens.
    void setFolded(bool folded);
    /// Another device or another selection.
    void follow(const Family &family);
    /// Only rows of this axis, 0: those of the board; nothing: all.
    [[nodiscard]] std::optional<int> chosen() const;

Q_SIGNALS:
    void changed();

private:
    void choose(int place);
    void nameAxes();
    void copyFrom(int axis);
    void fillMenu();
    [[nodiscard]] const DeviceView *device() const { return m_workbench.snapshot().device(m_selection.device()); }

    Workbench &m_workbench;
    Selection &m_selection;
    Segmented *m_axes = nullptr;
    CommandButton *m_copy = nullptr;
    bool m_boardOnly = false;
};

} // namespace mb
