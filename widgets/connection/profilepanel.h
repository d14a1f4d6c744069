// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"
#include "widgets/common/workbench.h"

#include <QWidget>

#include <vector>

class QComboBox;
class QLabel;
class QLineEdit;
class QVBoxLayout;

namespace mb {

/// What only the user of a device knows: what a count of its sensors stands for, and which dialect it speaks if not the one that
/// was found. What can be found out by trying has a button. Rows come from the tables of the family; hidden where there are none.
class ProfilePanel : public QWidget {
    Q_OBJECT
public:
    ProfilePanel(Workbench &workbench, const ThemeSource &theme, QWidget *parent = nullptr);
    /// nullptr: no device.
    void show(const DeviceView *device);

private:
    struct Row {
        const Calibration *calibration = nullptr;
        QLineEdit *field = nullptr;
        QComboBox *choices = nullptr; ///< of a row that has some
    };
    void rebuild(const Family &family);
    void buildDialects(const Family &family, QVBoxLayout &column);
    void buildRow(const Calibration &calibration, QVBoxLayout &column);
    void buildChoices(const Calibration &calibration, QVBoxLayout &column);
    void buildExperiments(const Family &family, QVBoxLayout &column);
    void chosen(const Row &row, int place);
    void experiment(const Experiment &experiment);
    void showRow(const Row &row, const DeviceView &device, bool another);
    void typed(const Row &row);
    void chooseDialect(int place);
    void say(const Result<void> &result);

    Workbench &m_workbench;
    const ThemeSource &m_theme;
    QVBoxLayout *m_column = nullptr;
    QWidget *m_content = nullptr;
    QComboBox *m_dialects = nullptr;
    QLabel *m_trouble = nullptr;
    std::vector<Row> m_rows;
    const Family *m_family = nullptr;
    DeviceId m_device;
};

} // namespace mb
