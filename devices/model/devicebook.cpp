// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/devicebook.h"

#include <algorithm>

namespace mb {
namespace {

/// A scan reports a unit before it has read its texts: those of the same session are still true.
Identity merged(const Identity &known, Identity seen)
{
    if (seen.session != known.session)
        return seen;
    seen.name = seen.name.empty() ? known.name : seen.name;
    seen.serial = seen.serial.empty() ? known.serial : seen.serial; // descriptors come one after the other
    if (seen.descriptors.empty())
        seen.descriptors = known.descriptors;
    return seen;
}

constexpr Duration commitPeriod = std::chrono::milliseconds(10);

template <class Entries> auto entryOf(Entries &entries, const Device &device)
{
    return std::ranges::find_if(entries, [&device](const auto &entry) { return entry.device.get() == &device; });
}

} // namespace

DeviceBook::DeviceBook(Clock &clock, LinkBook &links, SessionMemory &memory, MotionGuard *guard)
    : m_links(links)
    , m_memory(memory)
    , m_guard(guard)
    , m_commit(clock)
    , m_batchEnded(links.batchEnded().add([this] { scheduleCommit(); }))
{
}

Device &DeviceBook::adopt(Link &link, const Family &family, const Identity &identity, const std::vector<Device *> &seen)
{
    Device *match = nullptr;
    for (const Entry &entry : m_entries) {
        Device &device = *entry.device;
        if (&device.link() != &link || device.family().key != family.key
            || device.identity().address != identity.address)
            continue;
        if (device.identity().session == identity.session) {
            match = &device;
            break;
        }
        if (!match && std::ranges::find(seen, &device) == seen.end())
            match = &device;
    }
    if (!match)
        return add(link, family, identity);
    match->setIdentity(merged(match->identity(), identity));
    return *match;
}

Device &DeviceBook::adoptRecorded(Link &link, const Family &family, const Identity &identity)
{
    const auto known = std::ranges::find_if(m_entries, [&](const Entry &entry) {
        return &entry.device->link() == &link && &entry.device->family() == &family
            && entry.device->identity().address == identity.address;
    });
    if (known == m_entries.end())
        return add(link, family, identity);
    known->device->setIdentity(identity);
    return *known->device;
}

Device &DeviceBook::add(Link &link, const Family &family, const Identity &identity)
{
    Entry &entry = m_entries.emplace_back();
    entry.id = DeviceId{++m_lastId};
    open(entry, link, family, identity);
    recognise(entry);
    m_added.notify(*entry.device);
    m_changed.notify();
    return *entry.device;
}

void DeviceBook::open(Entry &entry, Link &link, const Family &family, const Identity &identity)
{
    entry.device = family.open(link, m_links.clockOf(link), identity);
    Device &device = *entry.device;
    device.guard().setSource(m_guard);
    device.gate().setStopGate(m_stopGate);
    if (m_store)
        device.telemetry()->keepIn(*m_store);
    m_memory.recall(device);
    device.knowledge().setKeeper([this, &device] { return m_memory.kept(device); });
    entry.changed = device.changed().add([this, &entry] {
        recognise(entry);
        m_changed.notify();
    });
    entry.profileChanged = device.knowledge().changed().add([this, &device] {
        m_changed.notify();
        m_memory.keep(device);
    });
    entry.stopChanged = device.stopping().changed().add([this, &device] {
        m_stopChanged.notify(device);
        m_changed.notify();
    });
}

/// Nothing that was meant for the unit before, or is known of it, is taken for that of this one. Who sends in a recording is not asked.
void DeviceBook::recognise(Entry &entry)
{
    Device &device = *entry.device;
    const std::string &serial = device.identity().serial;
    if (serial.empty() || device.link().address().isRecording())
        return;
    if (entry.units.empty())
        entry.units.emplace(serial, entry.id);
    const auto [unit, isNew] = entry.units.try_emplace(serial);
    if (isNew)
        unit->second = DeviceId{++m_lastId};
    if (unit->second == entry.id)
        return;
    entry.id = unit->second;
    if (entry.isStreaming())
        entry.stream->stop();
    device.parameters().forgetAll();
    device.telemetry()->clear();
}

void DeviceBook::renew(Link &link)
{
    for (Entry &entry : m_entries) {
        if (&entry.device->link() != &link)
            continue;
        const Family &family = entry.device->family();
        const Identity identity = entry.device->identity();
        entry.stream.reset();
        entry.changed = {};
        entry.device.reset();
        open(entry, link, family, identity);
    }
}

void DeviceBook::forget(const Link &link)
{
    std::erase_if(m_entries, [&link](const Entry &entry) { return &entry.device->link() == &link; });
}

std::vector<Device *> DeviceBook::all() const
{
    std::vector<Device *> all;
    for (const Entry &entry : m_entries)
        all.push_back(entry.device.get());
    return all;
}

std::vector<Device *> DeviceBook::on(const Link &link) const
{
    std::vector<Device *> there = all();
    std::erase_if(there, [&link](const Device *device) { return &device->link() != &link; });
    return there;
}

std::vector<Identity> DeviceBook::known(const Link &link, const Family &family) const
{
    std::vector<Identity> known;
    for (const Device *device : on(link)) {
        if (&device->family() == &family)
            known.push_back(device->identity());
    }
    return known;
}

Device *DeviceBook::find(DeviceId id) const
{
    const auto entry = std::ranges::find(m_entries, id, &Entry::id);
    return entry == m_entries.end() ? nullptr : entry->device.get();
}

DeviceId DeviceBook::idOf(const Device &device) const
{
    const auto entry = entryOf(m_entries, device);
    return entry == m_entries.end() ? DeviceId{} : entry->id;
}

bool DeviceBook::isRecognised(const Device &device) const
{
    return entryOf(m_entries, device)->units.empty()
        || (!device.liveness().restarted && !device.identity().serial.empty());
}

SetPointStream &DeviceBook::stream(const Device &device)
{
    const auto entry = entryOf(m_entries, device);
    if (!entry->stream)
        entry->stream = std::make_unique<SetPointStream>(*entry->device, m_links.clockOf(entry->device->link()));
    return *entry->stream;
}

void DeviceBook::scheduleCommit()
{
    if (m_commit.isActive())
        return;
    m_commit.startIn(commitPeriod, [this] {
        for (const Entry &entry : m_entries)
            entry.device->telemetry()->commit();
    });
}

} // namespace mb
