// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/signal.h"
#include "widgets/plots/triggerwatch.h"

#include <QWidget>

#include <optional>

class QComboBox;
class QLabel;
class QLineEdit;

namespace mb {

class Segmented;

/// One line under the bar of the page: which trace, which edge, which level, how much before, normal or single.
class TriggerBar : public QWidget {
    Q_OBJECT
public:
    TriggerBar(const ThemeSource &theme, QWidget *parent);

    struct Choice {
        int id = 0; ///< of the trace
        Signal signal;
        QString name;
        QString unit;
    };
    /// False where the one that was chosen is not among them; then it is the first.
    bool setTraces(const std::vector<Choice> &traces);
    [[nodiscard]] int trace() const;
    void choose(int id);
    /// Nothing while what stands in the field is no level.
    [[nodiscard]] std::optional<TriggerSetup> setup() const;
    void setLevel(double level);
    /// "trigger ↑ 20 A, 0.5 s before"
    [[nodiscard]] QString description(const TriggerSetup &setup, double window) const;

Q_SIGNALS:
    /// Something was chosen or typed: arm anew.
    void changed();
    void closed();

private:
    void buildChoices();
    void buildLevel();
    void levelTyped();

    const ThemeSource &m_theme;
    std::vector<Choice> m_choices;
    QComboBox *m_trace = nullptr;
    QComboBox *m_kind = nullptr;
    QLineEdit *m_level = nullptr;
    QLabel *m_unit = nullptr;
    QComboBox *m_before = nullptr;
    Segmented *m_mode = nullptr;
};

} // namespace mb
