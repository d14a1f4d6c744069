// SPDX-License-Identifier: GPL-3.0-or-later
// Session: recordings as links.
#include "async/sleep.h"
#include "model/passivediscovery.h"
#include "model/session.h"

#include <algorithm>

namespace mb {

ReplayLink *Session::replayOf(Link &link)
{
    return link.address().isRecording() ? dynamic_cast<ReplayLink *>(&link) : nullptr;
}

Clock &Session::clockOf(Link &link) const
{
    if (ReplayLink *const recording = replayOf(link))
        return recording->timeLine();
    Bench *const simulated = bench(link);
    return simulated ? simulated->clock() : m_clock;
}

Task<std::vector<Device *>> Session::overhear(ReplayLink &link)
{
    PassiveDiscovery discovery(
        m_families, [this, &link](const Family &family, const Identity &seen) { overheard(link, family, seen); });
    while (true) {
        const auto complete = link.survey([&](const LoggedFrame &logged) {
            CanFrame frame = logged.frame;
            frame.time = Instant(logged.time);
            discovery.take(frame, logged.direction == LogDirection::Sent);
        });
        if (!complete)
            co_return fail(complete.error());
        if (*complete)
            break;
        co_await Sleep(m_clock, Duration::zero()); // others get their turn
    }
    std::vector<Device *> found = devices();
    std::erase_if(found, [&link](const Device *device) { return &device->link() != &link; });
    std::sort(found.begin(), found.end(), [](const Device *a, const Device *b) {
        return std::pair(a->identity().family, a->identity().address)
            < std::pair(b->identity().family, b->identity().address);
    });
    co_return found;
}

void Session::overheard(Link &link, const Family &family, const Identity &identity)
{
    const auto known = std::find_if(m_devices.begin(), m_devices.end(), [&](const Entry &entry) {
        return &entry.device->link() == &link && &entry.device->family() == &family
            && entry.device->identity().address == identity.address;
    });
    if (known == m_devices.end())
        addEntry(link, family, identity);
    else
        known->device->setIdentity(identity);
}

Result<void> Session::seek(ReplayLink &link, Duration position)
{
    for (Entry &entry : m_devices) {
        if (&entry.device->link() != &link)
            continue;
        const Family &family = entry.device->family();
        const Identity identity = entry.device->identity();
        entry.stream.reset();
        entry.changed = {};
        entry.device.reset(); // it must not hear the replay jump
        openDevice(entry, link, family, identity);
    }
    auto sought = link.seek(position);
    m_changed.notify();
    return sought;
}

} // namespace mb
