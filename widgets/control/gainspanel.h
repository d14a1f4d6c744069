// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/displayunits.h"
#include "widgets/common/workbench.h"
#include "widgets/control/gainrow.h"

#include <QPointer>

class QVBoxLayout;
class QPushButton;

namespace mb {

class SectionLabel;

/// The gains of one loop and slot, and what bounds them. Shows and stages; the page writes.
class GainsPanel : public QWidget {
    Q_OBJECT
public:
    explicit GainsPanel(const ThemeSource &theme, QWidget *parent = nullptr);

    /// Which rows: made anew when anything but the units differs from before. `edits` outlives the panel's use of it.
    void choose(const Family &family, StagedEdits &edits, Mode mode, int slot, int axis = 0);
    void clear();
    void setUnits(const DisplayUnits &units) { m_units = units; }
    void refresh(const DeviceView &device, bool reading);

    /// Rows of this panel that are staged and legal, by name, for the button: "P, I".
    [[nodiscard]] QStringList stagedNames() const;
    /// What a write sends, in the safe order (see writeRank): only rows of this panel.
    [[nodiscard]] std::vector<ParameterChange> toWrite() const;
    [[nodiscard]] bool hasFault() const;
    /// A gain makes a leap that nobody has confirmed: its short name and what it is, "P: 27 × as large as now, 1.2."
    [[nodiscard]] QString unconfirmed() const;
    void revertAll();
    void focusFirst();
    [[nodiscard]] GainRow *row(Role role) const;

private:
    void rebuild();
    void showBounds(bool shown);
    void explain();

    const ThemeSource &m_theme;
    const Family *m_family = nullptr;
    QPointer<StagedEdits> m_edits;
    Mode m_mode = Mode::Off;
    int m_slot = -1;
    int m_axis = 0;
    DisplayUnits m_units;
    std::vector<GainRow *> m_rows;
    SectionLabel *m_title = nullptr;
    QVBoxLayout *m_column = nullptr;
    QWidget *m_content = nullptr;
    QWidget *m_bounds = nullptr;
    QLabel *m_note = nullptr;
    QPushButton *m_more = nullptr;
    bool m_boundsShown = false;
};

} // namespace mb
