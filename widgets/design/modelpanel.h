// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/modelfigures.h"
#include "widgets/common/theme.h"

#include <QWidget>

class QGridLayout;
class QLabel;
class QPushButton;

namespace mb {

class StateGlyph;

/// The model of a motor as it was found: each figure with its ±, what set-points may ask for, then every gate that it had to pass. Folded
/// it is one line.
class ModelPanel : public QWidget {
    Q_OBJECT
public:
    explicit ModelPanel(const ThemeSource &theme, QWidget *parent = nullptr);

    /// nullptr: none yet.
    void setReport(const tuning::TuneReport *report);
    /// Only a model that is believed folds.
    void setFolded(bool folded);
    [[nodiscard]] bool isFolded() const { return m_isFolded; }

Q_SIGNALS:
    /// By hand: all of it is wanted, or one line.
    void wanted(bool all);

private:
    QWidget *buildHead();
    void showNothing();
    void showFigures(const tuning::TuneReport &report);
    void addFigure(const ModelFigure &figure);
    void addWords(const QString &name, const QString &words);
    void addGates(const std::vector<tuning::Gate> &gates);

    const ThemeSource &m_theme;
    bool m_mayFold = false;
    bool m_isFolded = false;
    StateGlyph *m_glyph = nullptr;
    QLabel *m_verdict = nullptr;
    QPushButton *m_more = nullptr;
    QLabel *m_line = nullptr; ///< when it is folded
    QWidget *m_box = nullptr;
    QGridLayout *m_grid = nullptr;
};

} // namespace mb
