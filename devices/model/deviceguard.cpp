// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/deviceguard.h"

#include "model/stoppable.h"

namespace mb {
namespace {

using namespace std::chrono_literals;

constexpr Duration renewEvery = 100ms;
constexpr Duration lapse = 400ms; // below the 500 ms of the guardian
constexpr Duration lookEvery = 10ms;

} // namespace

DeviceGuard::DeviceGuard(Stoppable &device)
    : m_device(device)
    , m_renewal(device.clock())
    , m_look(device.clock())
{
}

DeviceGuard::~DeviceGuard() = default;

bool DeviceGuard::isNeeded() const
{
    return !m_device.hasWatchdog() && m_device.link().outlet().form != Outlet::Form::InProcess;
}

Result<void> DeviceGuard::possible() const
{
    if (!isNeeded())
        return {};
    if (!m_source)
        return fail(
            Fault::Unsafe, say("this device has no watchdog, and nothing here would stop it if the program died"));
    const Link &link = m_device.link();
    if (link.state() == LinkState::Open && !link.outlet().isInheritable())
        return fail(Fault::Unsafe,
            say("this device has no watchdog, and on %1 nothing could stop it if the program died",
                link.address().shortName()),
            say("use an interface of the kernel"));
    return {};
}

Result<void> DeviceGuard::call()
{
    MB_TRY_VOID(possible());
    m_look.stop();
    if (!isNeeded() || (m_watch && !hasFailed()))
        return {};
    const StopScript script = m_device.stopScript();
    if (script.isEmpty())
        return fail(Fault::Unsupported, say("it is not known how to stop this device from outside"));
    drop(); // the old one first: two would send on one line
    MB_TRY(auto watch, m_source->watch(m_device.link(), script, m_device.selector()));
    m_watch = std::move(watch);
    m_lapsed = false;
    m_renewedAt = m_device.clock().now();
    m_watchChanged = m_watch->changed().add([this] { m_changed.notify(); });
    m_linkChanged = m_device.link().stateChanged().add([this](LinkState state) {
        if (state != LinkState::Open)
            drop(); // the guardian does what it can, and knows no other opening than this one
    });
    renew();
    return {};
}

void DeviceGuard::renew()
{
    m_lapsed = m_lapsed || hasLapsed();
    m_renewedAt = m_device.clock().now();
    m_watch->renew();
    m_renewal.startIn(renewEvery, [this] { renew(); });
}

bool DeviceGuard::hasLapsed() const
{
    return m_watch && m_device.clock().now() - m_renewedAt >= lapse;
}

bool DeviceGuard::stands() const
{
    if (!isNeeded())
        return true;
    return m_watch && m_watch->state() == GuardWatch::State::Standing && !m_lapsed && !hasLapsed();
}

bool DeviceGuard::hasFailed() const
{
    if (!m_watch)
        return false;
    const GuardWatch::State state = m_watch->state();
    return state == GuardWatch::State::Acted || state == GuardWatch::State::Gone || m_lapsed || hasLapsed();
}

Message DeviceGuard::reason() const
{
    if (m_watch && !m_watch->reason().empty())
        return m_watch->reason();
    if (hasFailed())
        return say("this program was held up for so long that the guardian may have stopped the motor");
    return say("the guardian does not stand by yet");
}

void DeviceGuard::dismiss()
{
    if (m_watch)
        look();
}

void DeviceGuard::look()
{
    if (m_device.isSeenStopped())
        release();
    else
        m_look.startIn(lookEvery, [this] { look(); });
}

void DeviceGuard::leave()
{
    if (m_watch && m_device.isSeenStopped())
        release();
}

void DeviceGuard::release()
{
    m_watch->release();
    drop();
}

void DeviceGuard::drop()
{
    m_look.stop();
    m_renewal.stop();
    m_watchChanged.reset();
    m_linkChanged.reset();
    m_watch.reset();
}

} // namespace mb
