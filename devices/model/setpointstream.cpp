// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/setpointstream.h"

#include "model/family.h"

namespace mb {
namespace {

/// A device that was just woken may need this long before its telemetry comes.
constexpr Duration grace = std::chrono::milliseconds(500);

} // namespace

SetPointStream::SetPointStream(Device &device, Clock &clock)
    : m_device(device)
    , m_clock(clock)
    , m_timer(clock)
{
}

SetPointStream::~SetPointStream()
{
    if (m_running)
        m_device.stop();
}

Result<void> SetPointStream::start(const SetPoint &setPoint, Duration lease)
{
    if (m_running)
        return update(setPoint);
    if (auto sent = m_device.command(setPoint); !sent)
        return sent;
    m_setPoint = setPoint;
    m_running = true;
    m_end = End::None;
    m_reason.clear();
    m_startedAt = m_clock.now();
    m_next = m_startedAt + m_device.family().capabilities.commandPeriod;
    m_timer.start(m_next, [this] { tick(); });
    m_lease = std::make_unique<Lease>(
        m_clock, lease, [this] { finish(End::LeaseExpired, "nobody renewed the motion lease"); });
    m_linkState = m_device.link().stateChanged().add([this](LinkState) { (void)checkDevice(); });
    m_deviceChanged = m_device.changed().add([this] { (void)checkDevice(); });
    m_changed.notify();
    return {};
}

Result<void> SetPointStream::update(const SetPoint &setPoint)
{
    if (!m_running)
        return fail(Fault::Unsafe, "the motor was stopped; arm again");
    if (auto checked = m_device.check(setPoint); !checked)
        return checked;
    m_setPoint = setPoint;
    renew();
    if (auto sent = m_device.command(m_setPoint); !sent) {
        finish(End::Refused, sent.error().detail);
        return sent;
    }
    m_changed.notify();
    return {};
}

void SetPointStream::renew()
{
    if (m_lease)
        m_lease->renew();
}

void SetPointStream::stop()
{
    if (m_running)
        finish(End::Stopped, "stopped");
    else
        m_device.stop();
}

bool SetPointStream::checkDevice()
{
    if (!m_running)
        return false;
    const Liveness &liveness = m_device.liveness();
    if (m_device.link().state() != LinkState::Open)
        finish(End::LinkLost, m_device.link().address().shortName() + ": " + m_device.link().reason());
    else if (liveness.foreignMaster)
        finish(End::ForeignMaster, "another master sends control frames to this device");
    else if (liveness.restarted)
        finish(End::DeviceRestarted, "the device restarted");
    else if (!liveness.heard && m_clock.now() - m_startedAt > grace)
        finish(End::DeviceSilent, "the device is not heard any more");
    return m_running;
}

void SetPointStream::tick()
{
    if (!checkDevice())
        return;
    if (auto sent = m_device.command(m_setPoint); !sent) {
        finish(End::Refused, sent.error().detail);
        return;
    }
    m_next += m_device.family().capabilities.commandPeriod;
    if (m_next <= m_clock.now()) // after a stall one frame, not a burst
        m_next = m_clock.now() + m_device.family().capabilities.commandPeriod;
    m_timer.start(m_next, [this] { tick(); });
}

void SetPointStream::finish(End end, std::string reason)
{
    m_running = false;
    m_end = end;
    m_reason = std::move(reason);
    m_timer.stop();
    m_lease.reset();
    m_linkState.reset();
    m_deviceChanged.reset();
    m_device.stop();
    m_changed.notify();
}

std::string_view toString(SetPointStream::End end)
{
    switch (end) {
    case SetPointStream::End::None: return "running";
    case SetPointStream::End::Stopped: return "stopped";
    case SetPointStream::End::LeaseExpired: return "lease expired";
    case SetPointStream::End::LinkLost: return "link lost";
    case SetPointStream::End::DeviceSilent: return "device silent";
    case SetPointStream::End::DeviceRestarted: return "device restarted";
    case SetPointStream::End::ForeignMaster: return "foreign master";
    case SetPointStream::End::Refused: return "refused";
    }
    return "";
}

} // namespace mb
