// SPDX-License-Identifier: GPL-3.0-or-later
// Session: what outlives the process.
#include "model/session.h"

#include <algorithm>

namespace mb {
namespace {

/// Simulated devices are factory-fresh in every process, and a recording has its own.
bool isKept(const Link &link)
{
    return !link.address().isSimulated() && !link.address().isRecording();
}

} // namespace

void Session::keepProfiles(std::string directory)
{
    m_profiles.emplace(std::move(directory));
}

void Session::recall(Device &device)
{
    if (!m_profiles || !isKept(device.link()))
        return;
    auto profile = m_profiles->load(device.selector());
    if (!profile)
        m_profileTrouble.notify(profile.error().text());
    else if (!profile->isEmpty())
        device.setProfile(std::move(*profile));
}

void Session::keep(const Device &device)
{
    m_changed.notify();
    if (!m_profiles || !isKept(device.link()))
        return;
    if (auto kept = m_profiles->save(device.selector(), device.profile()); !kept)
        m_profileTrouble.notify(kept.error().text());
}

void Session::keepScans(std::string directory)
{
    m_scans.emplace(std::move(directory));
}

void Session::tellMemoryTrouble(const Link &link, const Error &error)
{
    if (m_toldOfMemory.insert(link.address().text() + error.text()).second)
        m_memoryTrouble.notify(error.text());
}

std::vector<Identity> Session::rememberedOn(const Link &link, const Family &family)
{
    if (!m_scans || !family.probe || !isKept(link))
        return {};
    auto all = m_scans->load(link.address().text());
    if (!all) {
        tellMemoryTrouble(link, all.error());
        return {};
    }
    std::erase_if(*all, [&family](const Identity &identity) { return identity.family != family.key; });
    return std::move(*all);
}

/// A scan that finds nobody forgets nobody: as a rule the supply is off.
void Session::remember(const Link &link, const std::vector<Device *> &seen, bool complete)
{
    if (!m_scans || !isKept(link))
        return;
    std::vector<Identity> found;
    for (const Device *device : seen) {
        if (device->family().probe)
            found.push_back(device->identity());
    }
    if (found.empty())
        return;
    auto known = m_scans->load(link.address().text());
    std::vector<Identity> all = complete || !known ? std::vector<Identity>() : std::move(*known);
    for (Identity &identity : found) {
        std::erase_if(all, [&identity](const Identity &other) {
            return other.family == identity.family && other.address == identity.address;
        });
        all.push_back(std::move(identity));
    }
    if (auto kept = m_scans->save(link.address().text(), all); !kept)
        tellMemoryTrouble(link, kept.error());
}

} // namespace mb
