// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tuning/autotune.h"
#include "widgets/common/theme.h"

#include <QWidget>

class QGridLayout;
class QLabel;

namespace mb {

class StateGlyph;

/// The model of a motor as it was found: each figure with its ±, then every gate that it had to pass.
class ModelPanel : public QWidget {
    Q_OBJECT
public:
    explicit ModelPanel(const ThemeSource &theme, QWidget *parent = nullptr);

    /// nullptr: none yet.
    void setReport(const tuning::TuneReport *report);

private:
    void addFigure(
        int row, const QString &name, double value, std::optional<double> error, int digits, const QString &unit);
    void addGates(const std::vector<tuning::Gate> &gates);

    const ThemeSource &m_theme;
    StateGlyph *m_glyph = nullptr;
    QLabel *m_verdict = nullptr;
    QWidget *m_box = nullptr;
    QGridLayout *m_grid = nullptr;
};

} // namespace mb
