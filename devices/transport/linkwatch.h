// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"
#include "async/listeners.h"
#include "async/noncopyable.h"

#include <memory>

class QSocketNotifier;

namespace mb {

/// Tells when CAN interfaces come, go, are switched or renamed: the kernel's own notice (rtnetlink), no polling. Lives in
/// the event loop of the thread that makes it. Several notices at once are told once, 20 ms later, when the interface is
/// ready for use. Where the kernel does not give notices nothing is told: look now and then as well.
class LinkWatch : NonCopyable {
public:
    explicit LinkWatch(Clock &clock);
    ~LinkWatch();

    [[nodiscard]] Listeners<> &changed() { return m_changed; }

private:
    void read();

    int m_descriptor = -1;
    std::unique_ptr<QSocketNotifier> m_notifier;
    Timer m_settled;
    Listeners<> m_changed;
};

} // namespace mb
