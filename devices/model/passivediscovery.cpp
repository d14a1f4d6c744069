// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/passivediscovery.h"

#include <algorithm>

namespace mb {

namespace {

void takeDescriptors(Identity &known, const Identity &seen)
{
    for (const auto &[key, text] : seen.descriptors) {
        const auto same
            = std::ranges::find_if(known.descriptors, [&name = key](const auto &entry) { return entry.first == name; });
        if (same == known.descriptors.end())
            known.descriptors.emplace_back(key, text);
        else
            same->second = text;
    }
}

} // namespace

PassiveDiscovery::PassiveDiscovery(std::span<const Family *const> families, Found found)
    : m_found(std::move(found))
{
    for (const Family *family : families) {
        if (family->recogniser)
            m_recognisers.emplace_back(family, family->recogniser());
    }
}

void PassiveDiscovery::take(const CanFrame &frame, bool bySelf)
{
    if (frame.error)
        return;
    for (auto &[family, recognise] : m_recognisers) {
        auto seen = recognise(frame);
        if (!seen || bySelf)
            continue;
        const bool says
            = seen->session || !seen->firmware.empty() || !seen->bootloader.empty() || !seen->dialect.empty();
        const auto [entry, isNew] = m_sightings.try_emplace({family, seen->address});
        Sighting &sighting = entry->second;
        if (!isNew && !says)
            return; // most frames
        Identity identity = isNew ? std::move(*seen) : merged(sighting, std::move(*seen));
        if (!isNew && identity == sighting.identity)
            return;
        sighting.identity = std::move(identity);
        m_found(*family, sighting.identity);
        return;
    }
}

/// One frame has a part of what is known only. Another session under one address is the unit after a power cycle; one
/// that comes back after another is a second unit.
Identity PassiveDiscovery::merged(Sighting &sighting, Identity seen)
{
    const Identity &known = sighting.identity;
    Identity out = known;
    if (seen.session && seen.session != known.session) {
        if (sighting.sessions.contains(*seen.session)) {
            out.state = DeviceState::Duplicate;
            out.detail = say("several units answer under this number in the recording");
            return out;
        }
        if (known.session)
            sighting.sessions.insert(*known.session);
        out.session = seen.session;
    }
    const bool tellsVersion = !seen.firmware.empty() || !seen.bootloader.empty();
    if (tellsVersion) {
        out.firmware = seen.firmware;
        out.bootloader = seen.bootloader;
    }
    if (!seen.dialect.empty())
        out.dialect = seen.dialect;
    if ((tellsVersion || !seen.dialect.empty()) && known.state != DeviceState::Duplicate) {
        out.state = seen.state;
        out.detail = seen.detail;
    }
    takeDescriptors(out, seen);
    return out;
}

} // namespace mb
