// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/setpointstream.h"

#include "model/family.h"

#include <algorithm>

namespace mb {
namespace {

/// A device that was just woken may need this long before its telemetry comes.
constexpr Duration grace = std::chrono::milliseconds(500);
/// A guardian that is not there by then does not come.
constexpr Duration guardLimit = std::chrono::seconds(2);
/// Of a comparison of two clocks. Nobody wakes a computer sooner.
constexpr Duration sleepTolerance = std::chrono::milliseconds(20);

Message nobodyRenewed()
{
    return say("nobody renewed the motion lease");
}

/// A link that is gone is noticed by whatever is sent first: that is no refusal.
SetPointStream::End endBy(const Error &error)
{
    return error.fault == Fault::LinkLost ? SetPointStream::End::LinkLost : SetPointStream::End::Refused;
}

} // namespace

SetPointStream::SetPointStream(Device &device, Clock &clock)
    : m_device(device)
    , m_clock(clock)
    , m_timer(clock)
    , m_lease(clock, [this] { finish(End::LeaseExpired, nobodyRenewed()); })
{
}

SetPointStream::~SetPointStream()
{
    if (m_running)
        m_device.stop();
    m_device.guard().leave();
}

Result<void> SetPointStream::start(const SetPoint &setPoint, Duration lease, const Glide &glide, Since since)
{
    if (m_running)
        return update(setPoint, glide);
    if (since == Since::Start)
        m_lease.renew();
    m_end = m_lease.isOver(lease) ? End::LeaseExpired : End::None;
    m_reason = m_end == End::None ? Message() : nobodyRenewed();
    if (m_end != End::None)
        return fail(Fault::Unsafe, m_reason);
    if (setPoint.mode != Mode::Off) {
        if (m_calledOff && *m_calledOff)
            return fail(Fault::Cancelled, say("the user stopped it"));
        MB_TRY_VOID(m_device.mayMove());
        MB_TRY_VOID(m_device.check(setPoint));
    }
    m_setPoints.clear();
    m_glides.clear();
    remember(glided(setPoint, glide));
    if (auto sent = sendOrWait(); !sent) {
        m_device.guard().dismiss();
        return sent;
    }
    m_running = true;
    m_lease.hold(lease);
    watch();
    begin();
    m_changed.notify();
    return {};
}

SetPoint SetPointStream::glided(SetPoint setPoint, const Glide &glide)
{
    const auto told = std::ranges::find_if(m_setPoints,
        [&setPoint](const SetPoint &known) { return known.axis == setPoint.axis && known.mode == setPoint.mode; });
    const auto isPlace = [](const SetPoint &known) { return !known.relative && !known.buffered; };
    const bool isTold = told != m_setPoints.end() && isPlace(*told);
    const std::optional<double> from = isTold ? told->target : glide.from;
    const bool jumps = !from || !isPlace(setPoint) || *from == setPoint.target || (isTold && glide.rate <= 0.0);
    if (jumps || !isTold)
        m_glides.erase(setPoint.axis);
    if (jumps)
        return setPoint;
    const auto [at, isNew] = m_glides.try_emplace(setPoint.axis);
    SetPointSlew &slew = at->second;
    if (isNew)
        slew.start(*from, m_clock.now());
    else if (m_waiting)
        slew.resume(m_clock.now());
    slew.setRate(glide.rate);
    slew.setTarget(setPoint.target);
    setPoint.target = isNew ? *from : slew.advance(m_clock.now());
    return setPoint;
}

void SetPointStream::advanceGlides()
{
    if (m_glides.empty())
        return;
    for (SetPoint &setPoint : m_setPoints) {
        const auto glide = m_glides.find(setPoint.axis);
        if (glide == m_glides.end())
            continue;
        setPoint.target = glide->second.advance(m_clock.now());
        if (m_setPoint.axis == setPoint.axis)
            m_setPoint = setPoint;
    }
    std::erase_if(m_glides, [](const auto &glide) { return glide.second.isThere(); });
}

void SetPointStream::remember(const SetPoint &setPoint)
{
    m_setPoint = setPoint;
    std::erase_if(m_setPoints, [&setPoint](const SetPoint &known) { return known.axis == setPoint.axis; });
    if (setPoint.mode != Mode::Off || m_device.family().capabilities.axes == 1)
        m_setPoints.push_back(setPoint);
}

Result<void> SetPointStream::sendAll()
{
    sent(); // first: what a command changes may ask at once how late this is
    for (const SetPoint &setPoint : m_setPoints) {
        MB_TRY_VOID(m_device.command(setPoint));
    }
    return {};
}

void SetPointStream::sent()
{
    m_sentAt = m_clock.now();
    m_sleptThen = m_clock.slept();
}

Result<void> SetPointStream::sendOrWait()
{
    DeviceGuard &guard = m_device.guard();
    if (m_setPoint.mode != Mode::Off) {
        MB_TRY_VOID(guard.call());
    }
    m_waiting = m_setPoint.mode != Mode::Off && !guard.stands();
    if (m_waiting)
        return {};
    sent();
    return m_device.command(m_setPoint);
}

void SetPointStream::begin()
{
    m_startedAt = m_clock.now();
    if (m_waiting)
        m_timer.startIn(guardLimit, [this] { finish(End::Unguarded, say("no guardian came within two seconds")); });
    else
        scheduleNext(m_startedAt);
}

void SetPointStream::watch()
{
    m_linkState = m_device.link().stateChanged().add([this](LinkState) { (void)checkDevice(); });
    m_deviceChanged = m_device.changed().add([this] { (void)checkDevice(); });
    m_guardChanged = m_device.guard().changed().add([this] { guardChanged(); });
}

void SetPointStream::guardChanged()
{
    if (!checkDevice() || !m_waiting || !m_device.guard().stands())
        return;
    m_waiting = false;
    for (auto &[axis, glide] : m_glides)
        glide.resume(m_clock.now()); // it was not on its way while it waited
    if (auto sent = sendAll(); !sent)
        finish(endBy(sent.error()), sent.error().message());
    else
        begin();
}

Result<void> SetPointStream::update(const SetPoint &setPoint, const Glide &glide)
{
    auto followed = followOne(setPoint, glide);
    if (followed)
        renew();
    return followed;
}

Result<void> SetPointStream::follow(const SetPoint &setPoint)
{
    auto followed = followOne(setPoint, {});
    if (!followed && m_running)
        finish(endBy(followed.error()), followed.error().message());
    return followed;
}

Result<void> SetPointStream::followOne(const SetPoint &setPoint, const Glide &glide)
{
    if (!checkDevice())
        return fail(Fault::Unsafe, say("the motor was stopped"), say("arm again"));
    MB_TRY_VOID(m_device.check(setPoint));
    remember(glided(setPoint, glide));
    const bool waited = m_waiting;
    if (auto sent = sendOrWait(); !sent) {
        finish(endBy(sent.error()), sent.error().message());
        return sent;
    }
    if (waited != m_waiting)
        begin();
    m_changed.notify();
    return {};
}

void SetPointStream::renew()
{
    (void)checkDevice();
    m_lease.renew();
}

void SetPointStream::stop()
{
    if (m_running)
        return finish(End::Stopped, say("stopped"));
    m_device.stop();
    m_device.guard().dismiss();
}

/// Whoever was held up does not know what the motor did meanwhile: its device may have stopped it, and the next frame would
/// start it again.
bool SetPointStream::isLate() const
{
    return !m_waiting && m_clock.now() - m_sentAt > m_device.family().capabilities.commandLimit;
}

bool SetPointStream::hasSlept() const
{
    return !m_waiting && m_clock.slept() - m_sleptThen > sleepTolerance;
}

bool SetPointStream::checkDevice()
{
    if (!m_running)
        return false;
    const Liveness &liveness = m_device.liveness();
    if (m_device.gate().isStopPressed())
        finish(End::Stopped, say("stopped"));
    else if (m_device.link().state() != LinkState::Open)
        finish(End::LinkLost, say("%1: %2", m_device.link().address().shortName(), m_device.link().loss().message()));
    else if (m_device.guard().hasFailed())
        finish(End::Unguarded, m_device.guard().reason());
    else if (hasSlept())
        finish(End::Slept, say("the computer slept"));
    else if (isLate())
        finish(End::Late,
            say("this program was held up for %1 ms, longer than the motor goes without a set-point",
                (m_clock.now() - m_sentAt) / std::chrono::milliseconds(1)));
    else if (liveness.foreignMaster)
        finish(End::ForeignMaster, say("another master sends control frames to this device"));
    else if (liveness.restarted)
        finish(End::DeviceRestarted, say("the device restarted"));
    else if (!liveness.heard && m_clock.now() - m_startedAt > grace)
        finish(End::DeviceSilent, say("the device is not heard any more"));
    return m_running;
}

void SetPointStream::tick()
{
    if (!checkDevice())
        return;
    const bool glides = isGliding();
    advanceGlides();
    if (auto sent = sendAll(); !sent) {
        finish(endBy(sent.error()), sent.error().message());
        return;
    }
    scheduleNext(m_next);
    if (glides)
        m_changed.notify();
}

void SetPointStream::scheduleNext(Instant last)
{
    const Duration period = m_device.family().capabilities.commandPeriod;
    m_next = last + period;
    if (m_next <= m_clock.now()) // after a stall one frame, not a burst
        m_next = m_clock.now() + period;
    m_timer.start(m_next, [this] { tick(); });
}

void SetPointStream::finish(End end, Message reason)
{
    m_running = false;
    m_end = end;
    m_reason = std::move(reason);
    m_timer.stop();
    m_glides.clear();
    m_lease.release();
    m_device.stop();
    m_device.guard().dismiss();
    m_changed.notify();
}

std::string_view toString(SetPointStream::End end)
{
    switch (end) {
    case SetPointStream::End::None: return "running";
    case SetPointStream::End::Stopped: return "stopped";
    case SetPointStream::End::LeaseExpired: return "lease expired";
    case SetPointStream::End::Late: return "late";
    case SetPointStream::End::Slept: return "slept";
    case SetPointStream::End::LinkLost: return "link lost";
    case SetPointStream::End::DeviceSilent: return "device silent";
    case SetPointStream::End::DeviceRestarted: return "device restarted";
    case SetPointStream::End::ForeignMaster: return "foreign master";
    case SetPointStream::End::Unguarded: return "unguarded";
    case SetPointStream::End::Refused: return "refused";
    }
    return "";
}

} // namespace mb
