// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/stateglyph.h"
#include "widgets/common/theme.h"

#include <QWidget>

#include <vector>

class QButtonGroup;
class QCheckBox;
class QGridLayout;
class QLabel;
class QPushButton;
class QToolButton;

namespace mb {

class ElidedLabel;

/// The axes of a board: which one the page is about, what each does now, and which ones Run moves at the same moment.
class AxesPanel : public QWidget {
    Q_OBJECT
public:
    explicit AxesPanel(const ThemeSource &theme, QWidget *parent = nullptr);

    /// What a row says.
    struct State {
        GlyphState glyph = GlyphState::Gone;
        QString command; ///< what it is told, or what Run would tell it
        QString value;
    };

    /// Hides itself for a device with one motor; what was ticked is forgotten.
    void setAxes(int count);
    [[nodiscard]] int count() const { return static_cast<int>(m_rows.size()); }
    [[nodiscard]] int axis() const { return m_axis; }
    /// Without a signal.
    void setAxis(int axis);
    void setState(int axis, const State &state);
    /// What Run moves, in order: the axis that is shown, and those that are ticked.
    [[nodiscard]] std::vector<int> together() const;
    void setTogether(const std::vector<int> &axes);
    /// Puts the buttons behind `before` in the order of Tab; yields the last.
    QWidget *chainAfter(QWidget *before);

Q_SIGNALS:
    void axisChosen(int axis);
    void togetherChanged();
    /// Mode and set-point of the axis that is shown, for all that are ticked.
    void spreadRequested();
    void copyGainsRequested(int from);

private:
    struct Row {
        QToolButton *name = nullptr;
        StateGlyph *glyph = nullptr;
        ElidedLabel *command = nullptr;
        QLabel *value = nullptr;
        QCheckBox *together = nullptr;
        bool ticked = false;
    };
    void add();
    void buildFoot();
    void fillCopyMenu();
    void showTicks();

    const ThemeSource &m_theme;
    int m_axis = 0;
    std::vector<Row> m_rows;
    QButtonGroup *m_group = nullptr;
    QGridLayout *m_grid = nullptr;
    QCheckBox *m_all = nullptr;
    QPushButton *m_spread = nullptr;
    QPushButton *m_copy = nullptr;
};

} // namespace mb
