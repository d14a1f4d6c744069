// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "settings/comparison.h"
#include "widgets/common/theme.h"

#include <QTableWidget>

namespace mb {

/// Two states of a unit against each other, a row for each parameter. What is legal of B can be ticked; what belongs to one unit
/// is not, until somebody does.
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
    /// The values of B that are ticked, in the order of the table.
    [[nodiscard]] std::vector<ParameterChange> ticked() const;
    void setNarrow(bool narrow);

private:
    void fitNames();
    void addRow(const Family &family, const settings::SideDifference &difference, bool differs);

    const ThemeSource &m_theme;
};

} // namespace mb
