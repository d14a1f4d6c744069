// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/session.h"

#include <string>

namespace mb {

/// Lines for people about links and devices, in English, and what devices are called in them. Tells by itself what the session
/// has to say. Engine thread.
class EngineLog {
public:
    explicit EngineLog(Session &session);

    /// Severity, device (or link, or nobody), text.
    [[nodiscard]] Listeners<Severity, const std::string &, const Message &> &noticed() { return m_noticed; }
    void tell(Severity severity, const std::string &device, const Message &text) const
    {
        m_noticed.notify(severity, device, text);
    }
    void tell(Severity severity, const Device &device, const Message &text) const
    {
        m_noticed.notify(severity, labelOf(device), text);
    }
    /// The same about a device that may be gone; then nothing.
    void tell(Severity severity, DeviceId device, const Message &text) const;
    /// "DMC60C #5", with the link where another one has such a device, too.
    [[nodiscard]] std::string labelOf(const Device &device) const;

private:
    Session &m_session;
    Listeners<Severity, const std::string &, const Message &> m_noticed;
    Subscription m_remarked;
    Subscription m_profileTrouble;
    Subscription m_memoryTrouble;
};

} // namespace mb
