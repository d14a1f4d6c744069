// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiment/stimulus.h"
#include "model/setpoint.h"
#include "widgets/common/displayunits.h"
#include "widgets/common/theme.h"

#include <QWidget>

#include <optional>
#include <span>

class QComboBox;
class QLabel;
class QLineEdit;

namespace mb {

class ElidedLabel;
class StateGlyph;

/// What an experiment asks of a loop, in units of docs/names.md#units.
struct StimulusChoice {
    tuning::Profile profile = tuning::Profile::Step;
    std::optional<double> from; ///< nothing: where the motor is in position mode, else 0
    std::optional<double> to;   ///< nothing: nobody has said so yet
    std::optional<double> seconds;
    int repeat = 1;

    friend bool operator==(const StimulusChoice &, const StimulusChoice &) = default;
};

/// The stimulus of the next experiment: kind, from where to where, how long, how often, and whether it stays inside the
/// envelope. Starts nothing.
class StimulusBar : public QWidget {
    Q_OBJECT
public:
    explicit StimulusBar(const ThemeSource &theme, QWidget *parent = nullptr);

    /// All kinds, in the order of the list.
    [[nodiscard]] static std::span<const tuning::Profile> kinds();
    void setUnits(Mode mode, const DisplayUnits &units);
    /// Without a signal.
    void setChoice(const StimulusChoice &choice);
    [[nodiscard]] const StimulusChoice &choice() const { return m_choice; }
    /// What stands in the fields and cannot be read as a number; empty: all is legal.
    [[nodiscard]] QString fault() const { return m_fault; }
    /// A kind that would leave the envelope cannot be chosen, and says why; `fault` empty: it can.
    void setKindFault(tuning::Profile kind, const QString &fault);
    /// Whether the stimulus stays inside the envelope, with the numbers.
    void setVerdict(bool good, const QString &text);

Q_SIGNALS:
    void changed();

private:
    QWidget *buildRow();
    QLineEdit *field(const QString &name, const QString &tip);
    void read();
    void write();
    void fillKinds();

    const ThemeSource &m_theme;
    StimulusChoice m_choice;
    ShownUnit m_unit;
    QString m_fault;
    QComboBox *m_kind = nullptr;
    QLineEdit *m_from = nullptr;
    QLineEdit *m_to = nullptr;
    QLabel *m_unitLabel = nullptr;
    QLabel *m_timeLabel = nullptr;
    QLineEdit *m_seconds = nullptr;
    QComboBox *m_repeat = nullptr;
    StateGlyph *m_glyph = nullptr;
    ElidedLabel *m_verdict = nullptr;
};

} // namespace mb
