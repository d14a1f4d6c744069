// SPDX-License-Identifier: GPL-3.0-or-later
// STOP, and what became of it.
#include "app/enginecore.h"

#include <QtGlobal>

namespace mb {

void EngineCore::stopAll(StopCause cause)
{
    m_session.stopAll(cause);
    for (Running &running : m_operations) { // one that prepares has nothing to stop yet, and would move later
        if (running.isExperiment)
            (void)running.operation->cancel();
    }
    interruptTrials(std::nullopt);
    touch();
}

void EngineCore::dismissStops()
{
    m_session.dismissStops();
    notice(Severity::Info, {}, say("the motors that were not seen to stand were looked at; their stops are dismissed"));
    touch();
}

void EngineCore::releaseMoves(DeviceId id, const Finished &finished)
{
    Device *device = m_session.find(id);
    const Result<void> released
        = device ? m_session.releaseMoves(*device) : Result<void>(fail(Fault::Timeout, say("the device is gone")));
    if (finished)
        finished(released);
}

void EngineCore::followStop(const Device &device)
{
    const DeviceStop &stop = device.stopping();
    switch (stop.state()) {
    case StopState::Owed:
        if (!stop.isForMotion())
            break;
        notice(Severity::Danger, labelOf(device),
            say("the stop could not be sent, and is the first thing that goes out when the line is back; cut its "
                "power"));
        break;
    case StopState::Unconfirmed:
        notice(Severity::Danger, labelOf(device), say("was not seen to stop: the motor may still turn, cut its power"));
        break;
    case StopState::ByWatchdog:
        notice(
            Severity::Caution, labelOf(device), say("gave no sign after the stop; its own watchdog switches it off"));
        break;
    case StopState::Silent: notice(Severity::Caution, labelOf(device), say("gave no sign after the stop")); break;
    case StopState::Seen:
        if (m_mayTurn.erase(m_session.idOf(device)) > 0)
            notice(Severity::Good, labelOf(device), say("was seen to stand"));
        break;
    case StopState::None:
    case StopState::Stopping: break;
    }
    if (stop.mayTurn())
        m_mayTurn.insert(m_session.idOf(device));
    touch();
}

void EngineCore::guardianActed(const std::string &name, MotionGuard::Verdict verdict)
{
    switch (verdict) {
    case MotionGuard::Verdict::Confirmed:
        notice(Severity::Good, name, say("the guardian has stopped the motor"));
        break;
    case MotionGuard::Verdict::Sent:
        notice(Severity::Caution, name,
            say("the guardian has sent the stop, which nothing on this link confirms; look whether the motor stands"));
        break;
    case MotionGuard::Verdict::Failed:
        notice(Severity::Danger, name,
            say("the guardian tried in vain to stop the motor; it may still turn: cut its power"));
        break;
    }
}

} // namespace mb
