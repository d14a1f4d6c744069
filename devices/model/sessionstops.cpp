// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/sessionstops.h"

#include <algorithm>

namespace mb {
namespace {

constexpr Duration owingRetry
    = std::chrono::milliseconds(50); // a stop that is owed leaves within 100 ms after its link can be opened

} // namespace

SessionStops::SessionStops(Clock &clock, LinkBook &links, DeviceBook &devices, MotionGuard *guard)
    : m_links(links)
    , m_devices(devices)
    , m_owed(clock, devices, guard)
    , m_retry(clock)
    , m_opened(links.opened().add([this](Link &link) { linkOpened(link); }))
    , m_lost(links.lost().add([this](Link &link) { linkLost(link); }))
    , m_added(devices.added().add([this](Device &device) { m_owed.passTo(device); }))
    , m_stopChanged(devices.stopChanged().add([this](Device &device) { stopChanged(device); }))
{
}

void SessionStops::stopAll(StopCause cause)
{
    for (const DeviceBook::Entry &entry : m_devices.entries()) {
        Device &device = *entry.device;
        if (entry.isStreaming())
            entry.stream->stop();
        else if (cause == StopCause::User ? device.mayStop().has_value() : device.stopping().hasMoved())
            device.stop();
    }
}

void SessionStops::beforeClose(const Link &link)
{
    for (const DeviceBook::Entry &entry : m_devices.entries()) {
        if (&entry.device->link() != &link)
            continue;
        if (entry.isStreaming())
            entry.stream->stop();
        m_owed.add(*entry.device);
    }
}

bool SessionStops::mayTurn(const Link &link, const DeviceSelector &selector) const
{
    const std::vector<Device *> found = m_devices.on(link);
    return m_owed.isOwed(link.line(), selector.text()) || std::ranges::any_of(found, [&selector](Device *device) {
        return device->family().key == selector.family && device->identity().address == selector.address
            && device->stopping().mayStillTurn();
    });
}

void SessionStops::dismiss()
{
    m_owed.dismiss();
    for (Device *device : m_devices.all()) {
        if (!device->stopping().mayTurn())
            continue;
        device->stopping().dismiss();
        m_owed.settle(*device); // the book of its guardian may owe it, too
    }
    m_devices.changed().notify();
}

Result<void> SessionStops::releaseMoves(Device &lead)
{
    for (Device *device : m_devices.on(lead.link())) {
        if (device->gate().keepsMove() && !device->guard().stands())
            return fail(Fault::Unsafe, device->guard().reason());
    }
    return lead.releaseMoves();
}

void SessionStops::linkOpened(Link &link)
{
    m_owed.pay(link);
    for (Device *device : m_devices.on(link)) {
        device->stopping().linkIsBack();
        m_owed.passTo(*device);
    }
}

/// Its line may be back under a name that is no link of ours, while another one has this name: the guardians look for it everywhere.
void SessionStops::linkLost(const Link &link)
{
    m_owed.leave(link);
    retryOwing();
}

void SessionStops::stopChanged(Device &device)
{
    if (device.stopping().state() == StopState::Seen)
        m_owed.settle(device);
    if (device.stopping().state() == StopState::Owed)
        retryOwing();
}

bool SessionStops::isOwing(const Link &link) const
{
    const std::vector<Device *> there = m_devices.on(link);
    return link.state() == LinkState::Lost && !link.address().isRecording()
        && std::ranges::any_of(there, [](Device *device) { return device->stopping().state() == StopState::Owed; });
}

void SessionStops::retryOwing()
{
    const std::vector<Link *> links = m_links.all();
    if (m_retry.isActive() || std::ranges::none_of(links, [this](const Link *link) { return isOwing(*link); }))
        return;
    m_retry.startIn(owingRetry, [this] {
        for (Link *link : m_links.all()) {
            if (isOwing(*link))
                m_links.reopen(*link);
        }
        retryOwing();
    });
}

} // namespace mb
