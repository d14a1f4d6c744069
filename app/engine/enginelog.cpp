// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/engine/enginelog.h"

#include <algorithm>

namespace mb {

EngineLog::EngineLog(Session &session)
    : m_session(session)
    , m_remarked(session.linkBook().remarked().add(
          [this](const Link &link, const Message &text) { tell(Severity::Caution, link.address().shortName(), text); }))
    , m_profileTrouble(session.memory().profileTrouble().add(
          [this](const Message &text) { tell(Severity::Danger, std::string(), text); }))
    , m_memoryTrouble(session.memory().scanTrouble().add(
          [this](const Message &text) { tell(Severity::Caution, std::string(), text); }))
{
}

void EngineLog::tell(Severity severity, DeviceId device, const Message &text) const
{
    if (const Device *found = m_session.find(device))
        tell(severity, *found, text);
}

std::string EngineLog::labelOf(const Device &device) const
{
    const std::string label = std::string(device.family().title) + " #" + std::to_string(device.identity().address);
    const auto all = m_session.devices();
    const bool isTwofold = std::ranges::any_of(all, [&device](const Device *other) {
        return &other->family() == &device.family() && other->identity().address == device.identity().address
            && &other->link() != &device.link();
    });
    return isTwofold ? label + " on " + device.link().address().shortName() : label;
}

} // namespace mb
