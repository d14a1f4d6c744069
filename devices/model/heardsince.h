// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"
#include "async/listeners.h"
#include "async/noncopyable.h"
#include "model/device.h"

#include <optional>

namespace mb {

/// Of a unit that was silent so long nobody knows whether it was exchanged for another.
inline constexpr Duration exchangeTime = std::chrono::seconds(2);

/// That the unit in a place is still the one which stood there when this was made: until it restarts, or is silent for exchangeTime,
/// or the computer has slept for so long. Engine thread.
class HeardSince : NonCopyable {
public:
    explicit HeardSince(Device &device)
        : m_slept(device.clock().slept())
        , m_hadRestarted(device.liveness().restarted)
        , m_hearing(device.changed().add([this, &device] { look(device); }))
    {
        look(device);
    }
    /// Of the same device.
    [[nodiscard]] bool holds(const Device &device)
    {
        look(device);
        return m_holds;
    }

private:
    void look(const Device &device)
    {
        const Instant now = device.clock().now();
        const Liveness &seen = device.liveness();
        const bool restarts = seen.restarted && !m_hadRestarted;
        m_holds = m_holds && !restarts && device.clock().slept() - m_slept < exchangeTime
            && (!m_silentSince || now - *m_silentSince < exchangeTime);
        m_hadRestarted = seen.restarted;
        if (seen.heard)
            m_silentSince.reset();
        else if (!m_silentSince)
            m_silentSince = now;
    }

    Duration m_slept; ///< Clock::slept() when this was made
    bool m_holds = true;
    bool m_hadRestarted;
    std::optional<Instant> m_silentSince;
    Subscription m_hearing;
};

} // namespace mb
