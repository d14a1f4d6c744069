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
class Sparkline;
class StateGlyph;

/// The axes of a board beside each other: state, name, what each is told, its value and the last ten seconds of it. The name
/// selects the axis. Where four are too wide they stand two by two.
class AxisCells : public QWidget {
    Q_OBJECT
public:
    explicit AxisCells(const ThemeSource &theme, QWidget *parent = nullptr);
    void show(const DeviceView &device, Instant now);

Q_SIGNALS:
    void axisActivated(int axis);

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    struct Cell {
        QWidget *whole = nullptr;
        StateGlyph *glyph = nullptr;
        QPushButton *name = nullptr;
        ElidedLabel *command = nullptr;
        QLabel *value = nullptr;
        Sparkline *line = nullptr;
    };
    void add();
    void arrange();

    const ThemeSource &m_theme;
    QGridLayout *m_grid = nullptr;
    std::vector<Cell> m_cells;
    int m_columns = 0;
};

} // namespace mb
