// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/engine/devicepresence.h"

#include <iterator>

namespace mb {

void DevicePresence::look()
{
    for (const Device *device : m_context.session.devices()) {
        const auto [entry, isNew] = m_present.try_emplace(m_context.session.idOf(*device));
        Presence &presence = entry->second;
        presence.name = m_context.log.labelOf(*device);
        if (isNew) {
            m_trials.forgetDirection(*device); // of the unit that stood there before
            m_context.log.tell(Severity::Info, presence.name, say("found on %1", device->link().address().shortName()));
        }
        hear(*device, presence);
    }
    for (auto entry = m_present.begin(); entry != m_present.end();) {
        const bool gone = !m_context.session.find(entry->first);
        if (gone)
            m_context.log.tell(Severity::Caution, entry->second.name, say("is gone"));
        entry = gone ? m_present.erase(entry) : std::next(entry);
    }
}

void DevicePresence::hear(const Device &device, Presence &presence)
{
    if (device.liveness().heard) {
        if (presence.lost)
            m_context.log.tell(Severity::Good, presence.name, say("answers again"));
        presence.heard = true;
        presence.lost = false;
    } else if (presence.heard && device.gate().busy().empty()
        && !m_context.operations.has(m_context.session.idOf(device))) {
        m_context.log.tell(Severity::Caution, presence.name, say("does not answer any more"));
        m_trials.forgetDirection(device);
        presence.heard = false;
        presence.lost = true;
    }
}

void DevicePresence::refreshRestarted()
{
    for (Device *device : m_context.session.devices()) {
        const DeviceId id = m_context.session.idOf(*device);
        if (!device->liveness().restarted || !device->liveness().heard || m_context.operations.has(id)
            || device->link().address().isRecording())
            continue;
        m_context.log.tell(Severity::Caution, *device,
            say("the unit restarted: what is volatile was lost, its parameters are read again"));
        device->parameters().forgetAll();
        m_firstSnapshots.forget(id);
        m_context.operations.begin(
            id, {say("Look at the restarted unit"), OperationKind::Look},
            [](Device &unit, Progress &) { return unit.refresh(); },
            [this, id](const Result<void> &result) {
                if (result)
                    m_parameters.carryOut(orders::ReadParameters{id}, [](const Result<void> &) {});
            });
    }
}

} // namespace mb
