// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"
#include "widgets/common/workbench.h"

#include <QWidget>

#include <vector>

class QGridLayout;
class QLabel;
class QPushButton;

namespace mb {

class ElidedLabel;
class StateGlyph;

/// The axes of a board in a few lines: state, name, what each is told, its value. The name selects the axis.
class AxisRows : public QWidget {
    Q_OBJECT
public:
    explicit AxisRows(const ThemeSource &theme, QWidget *parent = nullptr);
    void show(const DeviceView &device, Instant now);

Q_SIGNALS:
    void axisActivated(int axis);

private:
    struct Row {
        StateGlyph *glyph = nullptr;
        QPushButton *name = nullptr;
        ElidedLabel *command = nullptr;
        QLabel *value = nullptr;
    };
    void add();

    const ThemeSource &m_theme;
    QGridLayout *m_grid = nullptr;
    std::vector<Row> m_rows;
};

} // namespace mb
