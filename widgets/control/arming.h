// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/lamp.h"
#include "widgets/common/motionrenewal.h"

#include <QTimer>

namespace mb {

struct TrialEnding;

/// Whether energy may flow, and to which device: Safe → Armed (by holding the Arm button) → Moving → Stopped, which needs a new
/// arming. Everything that moves a motor from the window goes through here. Renews the motion lease from the GUI thread, so
/// that a window that hangs ends in a stop by the engine.
class Arming : public QObject {
    Q_OBJECT
public:
    explicit Arming(Workbench &workbench, QObject *parent = nullptr);

    [[nodiscard]] LampState state() const { return m_state; }
    [[nodiscard]] DeviceId device() const { return m_device; }
    [[nodiscard]] bool isArmed(DeviceId device) const
    {
        return device == m_device && (m_state == LampState::Armed || m_state == LampState::Moving);
    }
    [[nodiscard]] bool isMoving() const { return m_state == LampState::Moving; }
    /// For the Arm button in the header. `candidate` is the device that holding would arm.
    [[nodiscard]] LampStatus status(DeviceId candidate) const;
    /// Why it was stopped, for people; empty while armed.
    [[nodiscard]] const QString &reason() const { return m_reason; }
    /// Stopped because the user said so: no alarm.
    [[nodiscard]] bool isStoppedByHand() const { return m_state == LampState::Stopped && m_byHand; }

    /// The Arm button was held. Refused, with a notice, when the device may not move.
    void arm(DeviceId device);
    /// Back to safe; stops first when something moves.
    void disarm();
    /// Starts the armed device, or changes what it does. Nothing happens when it is not armed.
    void run(const SetPoint &setPoint, const Glide &glide = {});
    /// Runs an experiment on the armed device, and renews its lease. Nothing happens, and `finished` gets Unsafe, when it is not
    /// armed or moves. Once it is over the device is armed again, or stopped by whatever stopped it.
    void runTrial(
        const tuning::ExperimentPlan &plan, Workbench::TrialMeasured measured, Workbench::TrialFinished finished);
    /// Tunes a loop of the armed device by itself; everything of runTrial() holds.
    void runTuning(const tuning::TunePlan &plan, Workbench::TuningFinished finished);
    /// The same with the sines of a frequency response.
    void runSweep(const tuning::SweepPlan &plan, const tuning::PlantModel &plant, Workbench::SweepFinished finished);
    /// An experiment of this device, or of any, moves it, or still puts back what it has changed.
    [[nodiscard]] bool isOnTrial(std::optional<DeviceId> device = {}) const
    {
        return device ? m_trialOf == device : m_trialOf.has_value();
    }
    /// Another number with every arming: what waits for something else is not begun once that arming is over.
    [[nodiscard]] std::uint64_t armingNumber() const { return m_armingNumber; }
    /// Ends the motion and stays armed; a trial puts back what it changed first.
    void halt();
    /// Takes one axis out while others go on; the last one ends the motion.
    void haltAxis(int axis);
    /// STOP: everything, everywhere, latched until armed again.
    void stopAll(const QString &reason);
    /// The same for what this program has moved, for a cause that is not the user's STOP.
    void stopMoved(const QString &reason);
    /// Something is moved by this program, an experiment's motor too.
    [[nodiscard]] bool hasMotion() const;

Q_SIGNALS:
    void changed();
    /// stopAll() or stopMoved() has gone out, whatever the state: what somebody holds to arm or to begin ends for nothing.
    void stopSent();

private:
    void follow();
    void enter(LampState state, const QString &reason = {});
    /// `order` is of the armed device.
    template <class O, class T>
    void runExperiment(O order, Mode mode, int axis, std::function<void(const Result<T> &)> finished);
    /// `isStart`: what was refused is the start of the motion, not another order to it.
    void refused(const Error &error, bool isStart);
    /// An error: nothing has moved.
    void trialEnded(DeviceId device, const Result<TrialEnding> &ending);
    void stop(StopCause cause, const QString &reason);
    [[nodiscard]] LampStatus statusOf(const DeviceView *candidate) const;

    Workbench &m_workbench;
    LampState m_state = LampState::Safe;
    DeviceId m_device;
    SetPoint m_setPoint;
    QString m_reason;
    QString m_leftOut; ///< of the last STOP
    Instant m_stoppedAt{};
    bool m_byHand = false;
    std::optional<DeviceId> m_trialOf; ///< whose experiment was begun last and has not ended
    std::uint64_t m_armingNumber = 0;
    bool m_started = false; ///< a snapshot has shown the motion running
    Instant m_runAt{};
    Instant m_armedUntil{};
    Duration m_slept{}; ///< by the computer, when it was armed
    MotionRenewal m_renewal;
};

} // namespace mb
