// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/ramledger.h"

namespace mb {

void RamLedger::observe(const Snapshot &snapshot, Instant now)
{
    for (const DeviceView &device : snapshot.devices) {
        Page &page = m_pages[device.id];
        if (page.revision != device.parameterRevision || page.entries.size() != device.parameters->size())
            follow(page, device, now);
    }
}

void RamLedger::follow(Page &page, const DeviceView &device, Instant now)
{
    page.entries.resize(device.parameters->size());
    for (std::uint16_t i = 0; i < device.parameters->size(); ++i) {
        const ParameterIndex index{i};
        const auto &before = page.entries[i];
        const auto &after = (*device.parameters)[i];
        if (after.state == ParameterState::Stored || after.state == ParameterState::Unknown)
            page.flash.erase(index);
        if (after.state != ParameterState::Ram)
            continue;
        if (before.state != ParameterState::Ram || before.raw != after.raw)
            page.lastWrite = now;
        if (!page.flash.contains(index))
            page.flash[index] = before.state == ParameterState::Stored ? before.raw : std::nullopt;
    }
    page.entries = device.parameters;
    page.revision = device.parameterRevision;
}

std::vector<RamLedger::Row> RamLedger::rows(DeviceId device) const
{
    std::vector<Row> rows;
    const auto page = m_pages.find(device);
    if (page == m_pages.end())
        return rows;
    for (std::uint16_t i = 0; i < page->second.entries.size(); ++i) {
        const auto &entry = page->second.entries[i];
        if (entry.state != ParameterState::Ram || !entry.raw)
            continue;
        const auto flash = page->second.flash.find({i});
        rows.push_back({{i}, flash == page->second.flash.end() ? std::nullopt : flash->second, *entry.raw});
    }
    return rows;
}

std::optional<Instant> RamLedger::lastWrite(DeviceId device) const
{
    const auto page = m_pages.find(device);
    return page == m_pages.end() || rows(device).empty() ? std::nullopt : page->second.lastWrite;
}

} // namespace mb
