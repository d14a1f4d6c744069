// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/family.h"
#include "model/setpoint.h"
#include "widgets/plots/displayunits.h"

#include <QWidget>

#include <map>

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QSlider;

namespace mb {

class DriveOptions;

/// Where the motor is to go: number, slider, how fast the set-point gets there, how the drive follows. Sends nothing.
class SetPointPanel : public QWidget {
    Q_OBJECT
public:
    explicit SetPointPanel(const ThemeSource &theme, QWidget *parent = nullptr);

    struct Range {
        double target = 0.0;
        double limit = 0.0;
        bool touched = false; ///< by a person
    };
    /// What a person has entered, for each mode.
    struct Entered {
        std::map<Mode, Range> ranges;
        int slew = -1;                ///< place in the list; -1: the usual
        double velocity = 2000.0;     ///< of a profile, counts/s
        double acceleration = 4000.0; ///< counts/s²
    };
    /// One of several axes is shown instead of another: see restore().
    [[nodiscard]] Entered entered() const;
    void restore(const Entered &entered);
    /// Where a mode starts: a hand cannot do much harm within it, and it can be raised.
    [[nodiscard]] double usualLimit(Mode mode) const;
    [[nodiscard]] static bool startsAtPresent(Mode mode);
    /// How fast a set-point of `mode` moves with these entries; 0 jumps.
    [[nodiscard]] double slewRate(const Entered &entered, Mode mode) const;

    /// What the family's set-points have besides a target, and how far they usually go.
    void setFamily(const Family &family);
    void setMode(Mode mode);
    [[nodiscard]] Mode mode() const { return m_mode; }
    void setUnits(const DisplayUnits &units);
    /// Forgets everything that was entered: another device, which can do this.
    void reset(const Capabilities &can);

    /// The target in units of docs/names.md#units; nothing while the field is not legal, and then fault() says why.
    [[nodiscard]] std::optional<double> target() const;
    [[nodiscard]] QString fault() const;
    /// Shows a target that was set elsewhere.
    void showTarget(double target);
    /// The measured value, for the head, and as the target of a mode that must start where the motor is.
    void showPresent(std::optional<double> present);
    /// ± this far, in units of docs/names.md#units.
    [[nodiscard]] double limit() const;
    /// Largest change of the set-point per second; 0 jumps.
    [[nodiscard]] double slewRate() const;
    void apply(SetPoint &setPoint) const;
    /// The target is in use: it does not follow the motor any more.
    void keepTarget() { range().touched = true; }
    /// Positions mean another place now.
    void forgetTargets();
    [[nodiscard]] DriveOptions &options() { return *m_options; }
    void focusField();

Q_SIGNALS:
    /// The slider moved or Enter was pressed in the field: obey if moving.
    void targetChosen();
    /// Something that decides whether and how a run may begin.
    void changed();
    void polarityChanged();
    /// The motor is to stop, and its position to count from 0.
    void zeroRequested();

private:
    void buildProfile();
    void showExtras();
    [[nodiscard]] bool isProfiled() const;
    [[nodiscard]] QString profileFault() const;
    QWidget *buildTarget();
    QWidget *buildRange();
    void buildOptions();
    void textTyped();
    void limitTyped();
    void sliderMoved(int place);
    void showRange();
    void showSlider();
    void showFault();
    [[nodiscard]] Range &range() { return m_ranges[m_mode]; }
    [[nodiscard]] QString shown(double target) const;

    const ThemeSource &m_theme;
    Mode m_mode = Mode::Off;
    DisplayUnits m_units;
    ShownUnit m_unit;
    std::map<Mode, Range> m_ranges;
    std::optional<double> m_present;
    QLabel *m_now = nullptr;
    QLineEdit *m_field = nullptr;
    QLabel *m_unitLabel = nullptr;
    QSlider *m_slider = nullptr;
    QWidget *m_rangeBox = nullptr;
    QLineEdit *m_limit = nullptr;
    QLabel *m_limitUnit = nullptr;
    QComboBox *m_slew = nullptr;
    QLabel *m_fault = nullptr;
    QPushButton *m_more = nullptr;
    DriveOptions *m_options = nullptr;
    QPushButton *m_zero = nullptr;
    QWidget *m_profileBox = nullptr;
    QLineEdit *m_velocity = nullptr;
    QLineEdit *m_acceleration = nullptr;
    QLabel *m_moves = nullptr;
    Capabilities m_can;
    std::span<const ModeRange> m_modeRanges;
};

} // namespace mb
