// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/displayunits.h"
#include "widgets/control/setpointentries.h"

#include <QWidget>

#include <optional>

class QLabel;
class QLineEdit;
class QPushButton;
class QSlider;

namespace mb {

class DriveOptions;
class ProfileFields;
class SetPointRange;
class ThemeSource;

/// Where the motor is to go: number, slider, how fast the set-point gets there, how the drive follows. Sends nothing.
class SetPointPanel : public QWidget {
    Q_OBJECT
public:
    explicit SetPointPanel(const ThemeSource &theme, QWidget *parent = nullptr);

    /// What was entered, for each mode.
    [[nodiscard]] SetPointEntries entered() const;
    /// Another motor, with what was entered for it. What the family's set-points have besides a target, and how far they usually
    /// go.
    void show(const Family &family, Mode mode, const SetPointEntries &entered);
    void setMode(Mode mode);
    void setUnits(const DisplayUnits &units);
    /// The target in units of docs/names.md#units; nothing while the field is not legal, and then fault() says why.
    [[nodiscard]] std::optional<double> target() const;
    [[nodiscard]] QString fault() const;
    /// Shows a target that was set elsewhere.
    void showTarget(double target);
    /// The measured value, for the head, and as the target of a mode that must start where the motor is.
    void showPresent(std::optional<double> present);
    /// Largest change of the set-point per second; 0 jumps.
    [[nodiscard]] double slewRate() const;
    void apply(SetPoint &setPoint) const;
    /// The target is in use: it does not follow the motor any more.
    void keepTarget() { range().touched = true; }
    /// Positions mean another place now.
    void forgetTargets();

Q_SIGNALS:
    /// The slider moved or Enter was pressed in the field: obey if moving.
    void targetChosen();
    /// Something that decides whether and how a run may begin.
    void changed();
    void polarityChanged();
    /// The motor is to stop, and its position to count from 0.
    void zeroRequested();

private:
    QWidget *buildTarget();
    void buildOptions();
    void connectFields();
    void showSummary();
    void showExtras();
    void textTyped();
    void limitTyped(double shown);
    void sliderMoved(int place);
    void showRange();
    void showSlider();
    void showFault();
    [[nodiscard]] double limit() const { return m_entries.limit(m_family, m_mode); }
    [[nodiscard]] SetPointEntries::Range &range() { return m_entries.ranges[m_mode]; }
    [[nodiscard]] QString shown(double target) const;

    const ThemeSource &m_theme;
    const Family *m_family = nullptr;
    Mode m_mode = Mode::Off;
    DisplayUnits m_units;
    ShownUnit m_unit;
    SetPointEntries m_entries; ///< the targets and limits; entered() adds what stands in the other fields
    std::optional<double> m_present;
    QLabel *m_now = nullptr;
    QLineEdit *m_field = nullptr;
    QLabel *m_unitLabel = nullptr;
    QSlider *m_slider = nullptr;
    SetPointRange *m_range = nullptr;
    QLabel *m_fault = nullptr;
    ProfileFields *m_profile = nullptr;
    QPushButton *m_more = nullptr;
    DriveOptions *m_options = nullptr;
    QPushButton *m_zero = nullptr;
};

} // namespace mb
