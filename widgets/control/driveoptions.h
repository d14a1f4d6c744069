// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/setpoint.h"
#include "widgets/common/theme.h"

#include <QWidget>

#include <optional>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;

namespace mb {

/// How the drive follows a set-point: ramp of the output, brake or coast, directions, limits switched off. Everything
/// starts as the device has it.
class DriveOptions : public QWidget {
    Q_OBJECT
public:
    explicit DriveOptions(const ThemeSource &theme, QWidget *parent = nullptr);

    /// Shows what means something in this mode; false: nothing does. What is not shown stays as it was entered, and is neither said
    /// nor refused.
    bool offer(const OutputOptions &can, Mode mode);
    /// Fills ramp, brake and flags; leaves mode and target alone.
    void apply(SetPoint &setPoint) const;
    /// Empty when everything here can be sent.
    [[nodiscard]] QString fault() const;
    /// "brake, ramp 2 duty/s": what differs from the device's own settings.
    [[nodiscard]] QString summary() const;
    /// What apply() has filled in; tells nobody.
    void show(const SetPoint &setPoint);

Q_SIGNALS:
    void changed();
    /// A direction or a limit changed: what was safe a moment ago may not be any more.
    void polarityChanged();

private:
    void addRamp();
    [[nodiscard]] QLabel *tallLabel(const QString &text);
    QCheckBox *addFlag(const QString &text, const QString &help);
    [[nodiscard]] std::optional<double> ramp() const;
    void checkRamp();

    const ThemeSource &m_theme;
    QFormLayout *m_form = nullptr;
    QWidget *m_rampRow = nullptr;
    QLineEdit *m_ramp = nullptr;
    QLabel *m_noRamp = nullptr; ///< what 0 means
    QLabel *m_fault = nullptr;
    QComboBox *m_brake = nullptr;
    QCheckBox *m_reverseMotor = nullptr;
    QCheckBox *m_reverseSensor = nullptr;
    QCheckBox *m_override = nullptr;
    QCheckBox *m_forwardOff = nullptr;
    QCheckBox *m_reverseOff = nullptr;
};

} // namespace mb
