// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/control/steplog.h"
#include "widgets/plots/displayunits.h"

#include <QWidget>

class QHBoxLayout;
class QLabel;
class QTableWidget;

namespace mb {

class CommandButton;

/// The steps of this session, newest first: what was asked, with which gains, and how well it went. A row can be shown in
/// the plot again, and its gains staged again. Stages and shows nothing by itself.
class StepTable : public QWidget {
    Q_OBJECT
public:
    explicit StepTable(const ThemeSource &theme, QWidget *parent = nullptr);

    void setUnits(const DisplayUnits &units);
    /// The family gives the gains their numbers.
    void setRecords(const Family *family, const std::vector<StepRecord> &records);
    void setRows(int rows);
    [[nodiscard]] QTableWidget &table() { return *m_table; }

Q_SIGNALS:
    void showRequested(const mb::StepRecord &record);
    void useRequested(const mb::StepRecord &record);

private:
    [[nodiscard]] QHBoxLayout *buildHead();
    void configure();
    void fill();
    [[nodiscard]] static QStringList notesOf(const StepRecord &record);
    void fillRow(int row, const StepRecord &record);
    void setCell(int row, int column, const QString &text, Tone tone = Tone::Text);
    [[nodiscard]] const StepRecord *current() const;
    void updateButtons();
    void fitHeight();

    const ThemeSource &m_theme;
    const Family *m_family = nullptr;
    DisplayUnits m_units;
    std::vector<StepRecord> m_records;
    int m_rows = 4;
    QLabel *m_count = nullptr;
    QLabel *m_empty = nullptr;
    QTableWidget *m_table = nullptr;
    CommandButton *m_show = nullptr;
    CommandButton *m_use = nullptr;
};

} // namespace mb
