// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/arming.h"

#include "experiment/experiment.h"
#include "model/leaserenewal.h"
#include "tuning/autotune.h"
#include "tuning/frequencyresponse.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/guarded.h"
#include "widgets/common/numberformat.h"
#include "widgets/control/motionwords.h"
#include "widgets/control/trialwords.h"

#include <QPointer>

#include <algorithm>

namespace mb {

/// What an experiment ended by: `reason` as in Trial.
struct TrialEnding {
    tuning::EndReason reason = tuning::EndReason::None;
    Message detail;
};

namespace {

constexpr Duration startTime = std::chrono::seconds(1);
constexpr std::chrono::minutes armedTime{5}; // without motion
constexpr std::chrono::seconds namedTime{8}; // as a line in the status bar

/// How long the computer has slept by now.
Duration sleptOf(Workbench &workbench)
{
    return workbench.sleeps().sleptAt(workbench.now());
}

/// A lease that ran out is a word of the program's; what people saw is a window that hung.
QString endOf(const MotionView &motion, Duration silence)
{
    if (motion.end != SetPointStream::End::LeaseExpired)
        return messageText(motion.reason);
    return Arming::tr("this window did not respond for %1 s")
        .arg(formatNumber(std::chrono::duration<double>(std::max<Duration>(silence, LeaseRenewal::term)).count(), 1));
}

/// What ends an arming that nothing else has ended; empty: nothing.
QString lossOf(const DeviceView &view)
{
    if (!view.mayNotMove.empty())
        return messageText(view.mayNotMove);
    if (!view.liveness.heard)
        return Arming::tr("it is not heard");
    return view.liveness.restarted ? Arming::tr("it has restarted") : QString();
}

/// Also one that was ordered a moment ago, of which no snapshot tells yet.
bool hasExperiment(const Arming &arming, const Snapshot &shot, DeviceId device)
{
    return arming.isOnTrial(device) || isTried(shot, device);
}

/// Empty: it can be.
QString whyNotArmed(const Arming &arming, const Snapshot &shot, const DeviceView &view)
{
    if (const QString lost = lossOf(view); !lost.isEmpty())
        return lost;
    if (hasExperiment(arming, shot, view.id))
        return Arming::tr("an experiment on it has not ended");
    const QString turning = namesThatMayTurn(shot);
    return turning.isEmpty() ? QString() : Arming::tr("%1 may still turn").arg(turning);
}

bool isAnyMoving(const Snapshot &shot)
{
    return !namesThatMayTurn(shot).isEmpty() || std::ranges::any_of(shot.devices, [](const DeviceView &device) {
        return device.motion.running || device.liveness.moving || device.stop == StopState::Stopping;
    });
}

/// What nothing has cut short is done.
tuning::EndReason reasonOf(tuning::EndReason cutShort)
{
    return cutShort == tuning::EndReason::None ? tuning::EndReason::Done : cutShort;
}

TrialEnding endingOf(const tuning::Trial &trial)
{
    return {trial.reason, trial.detail};
}

TrialEnding endingOf(const tuning::TuneReport &report)
{
    return {reasonOf(report.stopReason), report.evidence};
}

TrialEnding endingOf(const tuning::FrequencyResponse &response)
{
    return {reasonOf(response.stopReason), response.evidence};
}

} // namespace

Arming::Arming(Workbench &workbench, QObject *parent)
    : QObject(parent)
    , m_workbench(workbench)
    , m_renewal(workbench)
{
    connect(&workbench, &Workbench::changed, this, &Arming::follow);
}

bool Arming::hasMotion() const
{
    const auto &all = m_workbench.snapshot().devices;
    return isMoving() || std::ranges::any_of(all, [](const DeviceView &device) { return device.motion.running; });
}

/// The Arm button never says safe or stopped while a motor turns, or may.
LampStatus Arming::status(DeviceId candidate) const
{
    const Snapshot &shot = m_workbench.snapshot();
    LampStatus status = statusOf(shot.device(candidate));
    if (const QString names = namesThatMayTurn(shot); !names.isEmpty()) {
        status.state = LampState::MayTurn;
        status.detail = tr("%1: cut its power").arg(names);
        status.remaining.reset();
        status.armable = false;
    } else if (const DeviceView *other = m_state == LampState::Moving ? nullptr : experimentedWith(shot)) {
        status.state = LampState::Moving;
        status.detail = addressIn(shot, other->id) + QLatin1Char(' ') + tr("experiment");
    } else if (m_state != LampState::Moving && isStopping(shot)) {
        status.state = LampState::Stopping;
        status.detail = tr("until it is seen");
        status.remaining.reset();
    }
    return status;
}

LampStatus Arming::statusOf(const DeviceView *view) const
{
    const Snapshot &shot = m_workbench.snapshot();
    LampStatus status;
    status.state = m_state;
    status.candidate = view ? view->id : DeviceId{};
    status.armable = view && whyNotArmed(*this, m_workbench.snapshot(), *view).isEmpty();
    switch (m_state) {
    case LampState::Safe:
        if (!view)
            status.detail = tr("nothing to arm");
        else if (!view->busy.empty() || hasExperiment(*this, shot, view->id))
            status.detail = tr("arming off while busy");
        else if (!status.armable)
            status.detail = tr("%1 cannot be armed").arg(addressIn(shot, view->id));
        break;
    case LampState::Armed:
        status.remaining = std::chrono::duration_cast<std::chrono::seconds>(
            std::max(m_armedUntil - m_workbench.now(), Duration::zero()));
        status.detail = addressIn(shot, m_device);
        break;
    case LampState::Moving:
        status.detail
            = addressIn(shot, m_device) + QLatin1Char(' ') + whatMoves(shot.device(m_device), m_setPoint.mode);
        break;
    case LampState::Stopped:
        if (!m_leftOut.isEmpty() && m_workbench.now() - m_stoppedAt < namedTime)
            status.detail = tr("not sent to %1").arg(m_leftOut);
        else if (!status.armable)
            status.detail
                = view && hasExperiment(*this, shot, view->id) ? tr("arming off while busy") : tr("nothing to arm");
        break;
    case LampState::Stopping:
    case LampState::MayTurn: break; // what becomes of a stop, never where the arming stands
    }
    return status;
}

void Arming::enter(LampState state, const QString &reason)
{
    if (state == LampState::Armed && m_state != LampState::Moving)
        ++m_armingNumber;
    m_state = state;
    m_reason = reason;
    m_byHand = false;
    m_started = false;
    m_renewal.keep(state == LampState::Moving ? std::vector{m_device} : std::vector<DeviceId>());
    if (state == LampState::Armed)
        m_armedUntil = m_workbench.now() + armedTime;
    Q_EMIT changed();
}

void Arming::arm(DeviceId device)
{
    const DeviceView *view = m_workbench.snapshot().device(device);
    if (!view)
        return;
    if (const QString why = whyNotArmed(*this, m_workbench.snapshot(), *view); !why.isEmpty()) {
        m_workbench.report(Severity::Caution, titleOf(*view), tr("not armed: %1").arg(why));
        return;
    }
    m_device = device;
    m_slept = sleptOf(m_workbench);
    m_workbench.report(Severity::Info, titleOf(*view), tr("armed"));
    enter(LampState::Armed);
}

void Arming::disarm()
{
    if (m_state == LampState::Moving)
        m_workbench.send(orders::StopMotion{m_device});
    else if (const DeviceView *other = experimentedWith(m_workbench.snapshot()))
        m_workbench.send(orders::StopMotion{other->id});
    if (m_state != LampState::Safe)
        enter(LampState::Safe);
}

void Arming::run(const SetPoint &setPoint, const Glide &glide)
{
    if (!isArmed(m_device) || isOnTrial(m_device))
        return;
    m_setPoint = setPoint;
    const bool begins = m_state != LampState::Moving;
    const auto finished = guarded(this, [this, begins](const Result<void> &result) {
        if (!result)
            refused(result.error(), begins);
    });
    if (!begins) {
        m_workbench.send(orders::UpdateMotion{m_device, setPoint, glide}, finished);
        return;
    }
    m_runAt = m_workbench.now();
    enter(LampState::Moving);
    m_workbench.send(orders::StartMotion{m_device, setPoint, LeaseRenewal::term, glide}, finished);
}

void Arming::refused(const Error &error, bool isStart)
{
    m_workbench.report(Severity::Danger, titleIn(m_workbench.snapshot(), m_device), errorText(error));
    if (isStart && !m_started && m_state == LampState::Moving)
        enter(LampState::Armed);
}

template <class O, class T>
void Arming::runExperiment(O order, Mode mode, int axis, std::function<void(const Result<T> &)> finished)
{
    if (m_state != LampState::Armed || isOnTrial(m_device)) {
        if (finished)
            finished(fail(Fault::Unsafe, say("it is not armed, or moves")));
        return;
    }
    m_setPoint = {};
    m_setPoint.mode = mode;
    m_setPoint.axis = axis;
    m_trialOf = m_device;
    enter(LampState::Moving);
    m_workbench.send(std::move(order),
        [self = QPointer<Arming>(this), device = m_device, finished = std::move(finished)](const Result<T> &result) {
            if (self)
                self->trialEnded(device, result ? Result<TrialEnding>(endingOf(*result)) : fail(result.error()));
            if (finished)
                finished(result);
        });
}

void Arming::runTrial(
    const tuning::ExperimentPlan &plan, Workbench::TrialMeasured measured, Workbench::TrialFinished finished)
{
    runExperiment<orders::RunTrial, tuning::Trial>(
        {m_device, plan, std::move(measured)}, plan.mode, plan.axis, std::move(finished));
}

void Arming::runTuning(const tuning::TunePlan &plan, Workbench::TuningFinished finished)
{
    runExperiment<orders::RunTuning, tuning::TuneReport>({m_device, plan}, plan.loop, plan.axis, std::move(finished));
}

void Arming::runSweep(const tuning::SweepPlan &plan, const tuning::PlantModel &plant, Workbench::SweepFinished finished)
{
    runExperiment<orders::RunSweep, tuning::FrequencyResponse>(
        {m_device, plan, plant}, Mode::Duty, plan.axis, std::move(finished));
}

/// A guard's stop is latched, as every stop that nobody asked for. Whatever another device does meanwhile goes on.
void Arming::trialEnded(DeviceId device, const Result<TrialEnding> &ending)
{
    if (!isOnTrial(device))
        return;
    m_trialOf.reset();
    if (m_state != LampState::Moving || m_device != device)
        return;
    if (!ending)
        m_workbench.report(Severity::Danger, titleIn(m_workbench.snapshot(), m_device), errorText(ending.error()));
    if (!ending || ending->reason == tuning::EndReason::Done || ending->reason == tuning::EndReason::Interrupted)
        enter(LampState::Armed);
    else
        enter(LampState::Stopped,
            tr("%1 guard, %2", "guard and what tripped it")
                .arg(guardText(ending->reason), messageText(ending->detail)));
}

void Arming::halt()
{
    if (m_state != LampState::Moving)
        return;
    m_workbench.send(orders::StopMotion{m_device});
    if (isOnTrial(m_device))
        return;
    enter(LampState::Armed);
}

void Arming::haltAxis(int axis)
{
    const DeviceView *view = m_workbench.snapshot().device(m_device);
    if (m_state != LampState::Moving || !view)
        return;
    const auto &all = view->motion.setPoints;
    const bool others = std::ranges::any_of(all, [axis](const SetPoint &setPoint) { return setPoint.axis != axis; });
    if (!others)
        return halt();
    SetPoint off;
    off.axis = axis;
    m_workbench.send(orders::UpdateMotion{m_device, off});
}

void Arming::stopAll(const QString &reason)
{
    stop(StopCause::User, reason);
}

void Arming::stopMoved(const QString &reason)
{
    stop(StopCause::Program, reason);
}

void Arming::stop(StopCause cause, const QString &reason)
{
    m_workbench.stopAll(cause); // first, before anything that could take time
    const bool live = m_state == LampState::Armed || m_state == LampState::Moving;
    const Snapshot &shot = m_workbench.snapshot();
    m_leftOut = cause == StopCause::User ? namesLeftOut(shot) : QString();
    m_stoppedAt = m_workbench.now();
    // Where nothing moves the key had another purpose, such as to close a dialog.
    const bool idle = !live && !isAnyMoving(shot);
    m_workbench.report(idle ? Severity::Info : Severity::Caution, {},
        idle || m_leftOut.isEmpty() ? tr("STOP: %1").arg(reason)
                                    : tr("STOP: %1; not sent to %2").arg(reason, namesLeftOut(shot, true)));
    Q_EMIT stopSent();
    if (!live)
        return;
    enter(LampState::Stopped, reason);
    m_byHand = cause == StopCause::User;
    Q_EMIT changed();
}

void Arming::follow()
{
    if (m_state == LampState::Armed && m_workbench.now() >= m_armedUntil) {
        m_workbench.report(Severity::Info, titleIn(m_workbench.snapshot(), m_device),
            tr("disarmed after %1 min without motion").arg(armedTime.count()));
        enter(LampState::Safe);
        return;
    }
    if (m_state != LampState::Armed && m_state != LampState::Moving)
        return;
    if (sleptOf(m_workbench) > m_slept)
        return stopMoved(tr("the computer slept"));
    const DeviceView *view = m_workbench.snapshot().device(m_device);
    if (!view) {
        enter(LampState::Stopped, tr("the device is gone"));
        return;
    }
    if (m_state == LampState::Armed) {
        if (const QString lost = lossOf(*view); !lost.isEmpty())
            enter(LampState::Stopped, lost);
        return;
    }
    if (isOnTrial(m_device)) // between its phases nothing runs
        return;
    m_started = m_started || view->motion.running;
    const bool ended = !view->motion.running && (m_started || m_workbench.now() - m_runAt > startTime);
    if (ended)
        enter(LampState::Stopped, endOf(view->motion, m_renewal.silence()));
}

} // namespace mb
