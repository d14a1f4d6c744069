// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/serviceview.h"
#include "widgets/common/stateglyph.h"

#include <QWidget>

#include <array>

class QGridLayout;
class QLabel;

namespace mb {

class CommandButton;

/// One unit of a queue: who it is, its steps with what came of each, and what can be ordered of it. GUI thread.
class UnitSteps : public QWidget {
    Q_OBJECT
public:
    UnitSteps(const ThemeSource &theme, QWidget *parent);

    /// nullptr: no unit. `recipe` tells which steps there are; nullptr: all.
    void show(const service::QueueRow *row, const QString &title, const service::Recipe *recipe);
    /// Its id; 0: no unit.
    [[nodiscard]] std::uint32_t row() const { return m_row; }
    [[nodiscard]] CommandButton &skip() const { return *m_skip; }
    [[nodiscard]] CommandButton &again() const { return *m_again; }

Q_SIGNALS:
    void skipWanted(std::uint32_t row);
    void againWanted(std::uint32_t row);

private:
    struct Line {
        StateGlyph *glyph = nullptr;
        QLabel *name = nullptr;
        QLabel *time = nullptr;
        QLabel *detail = nullptr;
    };
    void buildLine(QGridLayout &grid, service::Step step);
    void showStep(service::Step step, const service::QueueRow &row, bool wanted);

    const ThemeSource &m_theme;
    QLabel *m_title = nullptr;
    QLabel *m_serial = nullptr;
    std::array<Line, 7> m_lines{}; ///< by Step, Preflight … Proof
    CommandButton *m_skip = nullptr;
    CommandButton *m_again = nullptr;
    std::uint32_t m_row = 0;
};

} // namespace mb
