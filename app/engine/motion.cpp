// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/engine/motion.h"

#include <QtGlobal>

namespace mb {

Motion::Motion(const EngineContext &context, MotionGuard *guard)
    : m_context(context)
    , m_stopChanged(context.session.stopChanged().add([this](Device &device) { followStop(device); }))
{
    if (guard)
        m_guardianActed = guard->acted().add(
            [this](const std::string &name, MotionGuard::Verdict verdict) { guardianActed(name, verdict); });
}

void Motion::stopAll(StopCause cause)
{
    m_context.session.stopAll(cause);
    m_context.operations.stopExperiments();
}

void Motion::forget(const Link &link)
{
    for (const Device *device : m_context.session.devices()) {
        if (&device->link() == &link)
            m_streams.erase(m_context.session.idOf(*device));
    }
}

/// The stream of an experiment is its own until what it has changed is put back.
Result<Device *> Motion::freeDevice(DeviceId id) const
{
    Device *const device = m_context.session.find(id);
    if (!device)
        return fail(Fault::Timeout, say("the device is gone"));
    if (m_context.operations.isLent(device->link()))
        return fail(Fault::Unsafe, say("units are served on this link"));
    if (m_context.operations.isTried(id))
        return fail(Fault::Unsafe, say("an experiment on it has not ended"), say("wait until it has, or stop it"));
    return device;
}

void Motion::carryOut(const orders::StartMotion &order, const Finished &finished)
{
    const Result<Device *> found = freeDevice(order.device);
    if (!found)
        return finished(fail(found.error()));
    Device *const device = *found;
    SetPointStream &stream = m_context.session.stream(*device);
    m_streams[order.device] = stream.changed().add([this, id = order.device] { streamChanged(id); });
    if (const Message caution = device->caution(order.setPoint); !caution.empty())
        m_context.log.tell(Severity::Caution, *device, caution);
    finished(stream.start(order.setPoint, order.lease, order.glide));
}

void Motion::streamChanged(DeviceId id)
{
    Device *device = m_context.session.find(id);
    if (!device)
        return;
    const SetPointStream &stream = m_context.session.stream(*device);
    if (!stream.isRunning() && stream.end() != SetPointStream::End::Stopped)
        m_context.log.tell(Severity::Danger, *device,
            stream.end() == SetPointStream::End::LeaseExpired ? say("stopped: the window did not respond in time")
                                                              : say("stopped: %1", stream.reason()));
}

void Motion::carryOut(const orders::UpdateMotion &order, const Finished &finished)
{
    const Result<Device *> device = freeDevice(order.device);
    finished(device ? m_context.session.stream(**device).update(order.setPoint, order.glide) : fail(device.error()));
}

void Motion::carryOut(const orders::RenewMotion &order, const Finished &finished)
{
    if (Device *device = m_context.session.find(order.device))
        m_context.session.stream(*device).renew();
    finished({});
}

void Motion::carryOut(const orders::StopMotion &order, const Finished &finished)
{
    if (Device *device = m_context.session.find(order.device))
        m_context.session.stream(*device).stop();
    m_context.operations.interruptTrials(order.device);
    finished({});
}

void Motion::carryOut(const orders::ReleaseMoves &order, const Finished &finished)
{
    const Result<Device *> device = freeDevice(order.device);
    finished(device ? m_context.session.stops().releaseMoves(**device) : fail(device.error()));
}

/// A set-point that goes on would start it again; an order that is refused ends no motion.
void Motion::carryOut(const orders::ZeroPosition &order, const Finished &finished)
{
    m_context.operations.begin(
        order.device, say("Count from 0"),
        [this](Device &device, Progress &) {
            m_context.session.stream(device).stop();
            return device.zeroPosition();
        },
        finished);
}

void Motion::carryOut(const orders::DismissStops &, const Finished &finished)
{
    m_context.session.stops().dismiss();
    m_context.log.tell(Severity::Info, std::string(),
        say("the motors that were not seen to stand were looked at; their stops are dismissed"));
    finished({});
}

void Motion::followStop(Device &device)
{
    const DeviceStop &stop = device.stopping();
    switch (stop.state()) {
    case StopState::Owed:
        if (!stop.isForMotion())
            break;
        m_context.log.tell(Severity::Danger, device,
            say("the stop could not be sent, and is the first thing that goes out when the line is back; cut its "
                "power"));
        break;
    case StopState::Unconfirmed:
        m_context.log.tell(Severity::Danger, device,
            stop.isDue() ? say("was not seen to stop: the motor may still turn, cut its power")
                         : say("is told no more to stop after 10 minutes: the motor may still turn, cut its power"));
        break;
    case StopState::ByWatchdog:
        m_context.log.tell(
            Severity::Caution, device, say("gave no sign after the stop; its own watchdog switches it off"));
        break;
    case StopState::Silent: m_context.log.tell(Severity::Caution, device, say("gave no sign after the stop")); break;
    case StopState::Seen:
        if (m_mayTurn.erase(m_context.session.idOf(device)) > 0)
            m_context.log.tell(Severity::Good, device, say("was seen to stand"));
        break;
    case StopState::None:
    case StopState::Stopping: break;
    }
    if (stop.mayTurn())
        m_mayTurn.insert(m_context.session.idOf(device));
}

void Motion::guardianActed(const std::string &name, MotionGuard::Verdict verdict)
{
    switch (verdict) {
    case MotionGuard::Verdict::Confirmed:
        m_context.log.tell(Severity::Good, name, say("the guardian has stopped the motor"));
        break;
    case MotionGuard::Verdict::Sent:
        m_context.log.tell(Severity::Caution, name,
            say("the guardian has sent the stop, which nothing on this link confirms; look whether the motor stands"));
        break;
    case MotionGuard::Verdict::Failed:
        m_context.log.tell(Severity::Danger, name,
            say("the guardian tried in vain to stop the motor; it may still turn: cut its power"));
        break;
    }
}

} // namespace mb
