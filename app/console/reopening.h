// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/console.h"
#include "async/scope.h"
#include "transport/linkwatch.h"

namespace mb::console {

/// Keeps a verb going over the loss of its interface: says so, opens the link again as soon as the interface is back and up,
/// and looks for the devices on it. A link that is lost for another reason (bus-off, an adapter's failure) is left alone.
class Reopening {
public:
    /// `again` is run after each return; it may be empty.
    Reopening(Console &console, Link &link, std::function<Task<void>()> again);

    /// Whether this link, lost as it is, may come back by itself.
    [[nodiscard]] static bool mayReturn(const Link &link);

private:
    void follow(LinkState state);
    void attempt();
    [[nodiscard]] Task<void> resume();

    Console &m_console;
    Link &m_link;
    std::function<Task<void>()> m_again;
    LinkWatch m_watch;
    Timer m_retry;
    Subscription m_plugged;
    Subscription m_state;
    Scope m_scope;
};

} // namespace mb::console
