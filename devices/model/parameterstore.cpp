// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/parameterstore.h"

namespace mb {

std::string_view toString(ParameterState state)
{
    switch (state) {
    case ParameterState::Unknown: return "unknown";
    case ParameterState::Stored: return "stored";
    case ParameterState::Ram: return "ram";
    case ParameterState::Volatile: return "volatile";
    case ParameterState::Assumed: return "assumed";
    case ParameterState::Failed: return "failed";
    }
    return "";
}

ParameterStore::Entry ParameterStore::Entry::with(std::optional<std::int64_t> newer, ParameterState become) const
{
    if (become == ParameterState::Ram && state == ParameterState::Stored)
        return {newer, become, raw};
    const bool isKnown = become == ParameterState::Stored || become == ParameterState::Unknown;
    return {newer, become, isKnown ? std::nullopt : flash};
}

void ParameterStore::setRead(ParameterIndex index, std::int64_t raw)
{
    const Parameter &p = parameter(index);
    const Entry &before = entry(index);
    ParameterState state = p.persistent ? ParameterState::Stored : ParameterState::Volatile;
    if (p.persistent && before.state == ParameterState::Ram && before.raw == raw)
        state = ParameterState::Ram; // reading does not prove that flash has it
    set(index, raw, state);
}

void ParameterStore::setWritten(ParameterIndex index, std::int64_t raw, std::optional<Instant> now)
{
    const Parameter &p = parameter(index);
    const Entry before = entry(index);
    if (p.access == Access::WriteOnly || p.afterRestart)
        set(index, raw, ParameterState::Assumed);
    else if (!p.persistent)
        set(index, raw, ParameterState::Volatile);
    else
        set(index, raw, ParameterState::Ram);
    if (entry(index).state == ParameterState::Ram && (before.state != ParameterState::Ram || before.raw != raw))
        m_lastWrite = now;
}

void ParameterStore::setFailed(ParameterIndex index)
{
    set(index, entry(index).raw, ParameterState::Failed);
}

void ParameterStore::forget(ParameterIndex index, ParameterState state)
{
    set(index, std::nullopt, state);
}

void ParameterStore::setAllStored()
{
    for (Entry &e : m_entries.edit()) {
        if (e.state == ParameterState::Ram)
            e = e.with(e.raw, ParameterState::Stored);
    }
    touch();
}

void ParameterStore::forgetVolatile()
{
    for (Entry &e : m_entries.edit()) {
        if (e.state == ParameterState::Volatile)
            e = {};
    }
    touch();
}

void ParameterStore::forgetAll()
{
    m_entries.edit().assign(m_table.size(), Entry{});
    touch();
}

void ParameterStore::set(ParameterIndex index, std::optional<std::int64_t> raw, ParameterState state)
{
    Entry &entry = m_entries.edit()[index.value];
    entry = entry.with(raw, state);
    touch();
}

void ParameterStore::touch()
{
    ++m_revision;
    m_changed.notify();
}

std::vector<ParameterIndex> inRam(std::span<const ParameterStore::Entry> entries)
{
    std::vector<ParameterIndex> found;
    for (std::uint16_t i = 0; i < entries.size(); ++i) {
        if (entries[i].state == ParameterState::Ram && entries[i].raw)
            found.push_back({i});
    }
    return found;
}

} // namespace mb
