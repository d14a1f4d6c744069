// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/family.h"
#include "model/operation.h"
#include "widgets/common/theme.h"

#include <QWidget>

#include <vector>

class QLabel;
class QVBoxLayout;

namespace mb {

class DrawingView;
class StateGlyph;

/// An update that needs hands, step by step (UpdateRoute::steps), with the drawing of the step that it is at.
class StepsPanel : public QWidget {
    Q_OBJECT
public:
    explicit StepsPanel(const ThemeSource &theme, QWidget *parent = nullptr);

    /// Empty: hidden.
    void setSteps(std::span<const GuidedStep> steps);
    /// nullptr: not begun.
    void follow(const OperationStatus *status);

private:
    struct Row {
        StateGlyph *glyph = nullptr;
        QLabel *title = nullptr;
        QLabel *text = nullptr;
    };
    void rebuild();
    void showStep(std::size_t step, PartState state, bool broken);

    const ThemeSource &m_theme;
    std::span<const GuidedStep> m_steps;
    QVBoxLayout *m_column = nullptr;
    QWidget *m_list = nullptr;
    DrawingView *m_drawing = nullptr;
    std::vector<Row> m_rows;
};

} // namespace mb
