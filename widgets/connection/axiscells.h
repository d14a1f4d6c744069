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

/// The axes of a board: state, name, what each is told and its value. The name selects the axis.
class AxisCells : public QWidget {
    Q_OBJECT
public:
    enum class Look {
        Rows, ///< a line each
        Cells ///< beside each other, each with its last ten seconds; where four are too wide they stand two by two
    };
    AxisCells(const ThemeSource &theme, Look look, QWidget *parent = nullptr);
    void show(const DeviceView &device, Instant now);

Q_SIGNALS:
    void axisActivated(int axis);

protected:
    void resizeEvent(QResizeEvent *) override { arrange(); }

private:
    struct Cell {
        QWidget *whole = nullptr;
        StateGlyph *glyph = nullptr;
        QPushButton *name = nullptr;
        ElidedLabel *command = nullptr;
        QLabel *value = nullptr;
        Sparkline *line = nullptr; ///< of a cell
    };
    void add();
    void fill(Cell &cell);
    void arrange();

    const ThemeSource &m_theme;
    const Look m_look;
    QGridLayout *m_grid = nullptr;
    std::vector<Cell> m_cells;
    int m_columns = 0;
};

} // namespace mb
