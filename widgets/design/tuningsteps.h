// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/snapshot.h"
#include "tuning/autotune.h"
#include "widgets/common/theme.h"

#include <QWidget>

class QLabel;
class QVBoxLayout;

namespace mb {

class StateGlyph;

/// What an order will do, before; what it is doing, meanwhile; what came of it, after.
class TuningSteps : public QWidget {
    Q_OBJECT
public:
    explicit TuningSteps(const ThemeSource &theme, QWidget *parent = nullptr);

    /// `running` while it runs; else the last report, or nullptr.
    void show(const OperationView *running, const tuning::TuneReport *report);

private:
    void say(QStringList lines);

    const ThemeSource &m_theme;
    StateGlyph *m_glyph = nullptr;
    QLabel *m_head = nullptr;
    QLabel *m_words = nullptr;
    QVBoxLayout *m_lines = nullptr;
    QStringList m_said;
};

/// "kept", "rolled back" …, in front of people.
[[nodiscard]] QString resultText(tuning::TuneResult result);

} // namespace mb
