// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "settings/comparison.h"
#include "widgets/common/theme.h"

#include <QTableWidget>

#include <map>

namespace mb {

/// Two states of a unit against each other, a row for each parameter below its group. What is legal of B can be ticked, alone or
/// with its group; what belongs to one unit stands last, and is ticked only alone.
class DifferenceTable : public QTableWidget {
    Q_OBJECT
public:
    DifferenceTable(const ThemeSource &theme, QWidget *parent);

    struct Counts {
        std::size_t differences = 0;
        int all = 0; ///< settings that both sides know
    };
    /// `everything`: also what is the same on both sides.
    Counts show(const Family &family, const settings::Side &a, const settings::Side &b, bool everything);
    /// Another A or B: what somebody ticked was meant for the values of the one before. `on`: rows come ticked, but for what
    /// belongs to one unit.
    void forgetTicks(bool on);
    /// The values of B that are ticked, in the order of the table.
    [[nodiscard]] std::vector<ParameterChange> ticked() const;
    /// What is shown, for the clipboard: key, A, B and unit with tabulators between them.
    [[nodiscard]] QString asText() const;
    void setNarrow(bool narrow);

protected:
    void keyPressEvent(QKeyEvent *event) override;

private:
    struct Shown {
        settings::SideDifference values;
        bool differs = false;
    };
    void keepTicks();
    void addGroup(const Family &family, const QString &title, bool ofUnit, const std::vector<Shown> &rows, int spoken);
    void addRow(const Family &family, const Shown &shown);
    void follow(QTableWidgetItem *item);
    void judgeGroup(int row);
    [[nodiscard]] bool isGroup(int row) const;

    const ThemeSource &m_theme;
    std::map<std::uint16_t, bool> m_ticks; ///< by parameter, of rows that were shown
    bool m_comeTicked = true;
};

} // namespace mb
