// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/control/arming.h"
#include "widgets/control/statusline.h"
#include "widgets/control/tunechoices.h"

namespace mb {

class TuneColumn;

/// Motors driven by hand: the set-points that the Tune page sends to the one that is shown, and to axes beside it. Every
/// motion goes through Arming.
class TuneMotion : public QObject {
    Q_OBJECT
public:
    TuneMotion(Workbench &workbench, Arming &arming, TuneChoices &choices, TuneColumn &column);

    /// Starts, or applies what is chosen to a motor that moves. The first set-point is where the motor is, then no faster than
    /// the hand's limit; a step of another quantity than position goes out at once. Of several axes, once each holds where it is.
    void start();
    /// Of a board: what Run has started, the axis that is shown or all that are ticked.
    void halt();
    /// Lets the position of a motor that stands count from 0; Run starts it again.
    void zero();
    /// Has the device blink, where it can; nothing moves.
    void identify();
    /// A change of this needs a new arming.
    void disarmBecause(const QString &what);

    /// Shows where the motor is, and a set-point that was given elsewhere.
    void follow(const DeviceView &view);
    [[nodiscard]] bool isMoving(const DeviceView &view, int axis) const;
    /// What the live view says of the motor that is shown.
    [[nodiscard]] PageStatus status(const DeviceView &view, const QString &name) const;
    /// What Run would send to an axis: of one that is not shown, what was entered for it.
    [[nodiscard]] SetPoint wanted(const DeviceView &view, int axis) const;
    /// Gently, without a loop where the device can: for as long as J or K is held. Nothing while the motor is not armed.
    [[nodiscard]] std::optional<SetPoint> jog(bool forwards) const;
    [[nodiscard]] std::optional<double> present(const DeviceView &view, Mode mode, int axis) const;

    /// It has to begin where it is, and nobody knows where that is.
    [[nodiscard]] bool hasNoStart(const DeviceView &view, int axis) const;

private:
    [[nodiscard]] SetPoint entered() const;
    void startAxis(const DeviceView &view, int axis, bool several);
    void followForeignRun(const DeviceView &view);
    [[nodiscard]] QString describe(const SetPoint &setPoint) const;
    [[nodiscard]] QString othersText(const DeviceView &view) const;

    Workbench &m_workbench;
    Arming &m_arming;
    TuneChoices &m_choices;
    TuneColumn &m_column;
    std::optional<std::pair<TuneMotor, double>> m_foreign; ///< the last set-point that was given elsewhere
};

} // namespace mb
