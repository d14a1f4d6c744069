// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"
#include "async/noncopyable.h"

#include <functional>

namespace mb {

/// Renews the leases of motions (docs/architecture.md#motion-lease) ten times a second, by the loop that serves its
/// clock: one that hangs renews nothing, and its motors stop. Thread of the clock.
class LeaseRenewal : NonCopyable {
public:
    static constexpr std::chrono::milliseconds term{500};   ///< a motion lives so long without renewal
    static constexpr std::chrono::milliseconds period{100}; ///< between two renewals

    /// `renew` is called at once and then every period, until stop(), which it may call itself, or destruction.
    LeaseRenewal(Clock &clock, std::function<void()> renew);

    void stop() { m_timer.stop(); }

private:
    void next();

    std::function<void()> m_renew;
    Timer m_timer;
};

} // namespace mb
