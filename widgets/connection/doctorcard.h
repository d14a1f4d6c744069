// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/card.h"
#include "widgets/common/workbench.h"

#include <string>
#include <vector>

namespace mb {

/// The connection doctor: a row for each link, with its cause, its remedy, and a button that does it or copies the command.
/// Rows are made anew only when what they say has changed, so that a button under the pointer stays.
class DoctorCard : public Card {
    Q_OBJECT
public:
    /// `all`: links that work have a row too; without, the card hides while nothing is wrong.
    DoctorCard(Workbench &workbench, const ThemeSource &theme, bool all, QWidget *parent = nullptr);

    /// From the workbench's snapshot and listings.
    void follow();

private:
    struct Row {
        std::string link; ///< address, as the row's title
        Message text;     ///< of a healthy one
        Diagnosis diagnosis;
        bool reconnect = false; ///< a link of ours that is lost, or was asked for in vain
        friend bool operator==(const Row &, const Row &) = default;
    };

    [[nodiscard]] std::vector<Row> rows() const;
    void build();
    [[nodiscard]] QWidget *makeRow(const Row &row);
    void addButtons(QHBoxLayout &place, const Row &row, QWidget &parent);
    void copy(const std::string &command);

    Workbench &m_workbench;
    const ThemeSource &m_theme;
    bool m_all;
    QVBoxLayout *m_column = nullptr;
    std::vector<Row> m_rows;
    bool m_built = false;
};

} // namespace mb
