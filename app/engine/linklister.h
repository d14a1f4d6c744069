// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/background.h"
#include "transport/linkwatch.h"

namespace mb {

class Links;

/// Looks once a second, and when an interface comes or goes, which links the computer has, and tells `links`. Engine thread.
class LinkLister {
public:
    LinkLister(Clock &clock, Background &background, Links &links);

    /// Now, and from then on by itself.
    void look();
    [[nodiscard]] Listeners<> &looked() { return m_looked; }

private:
    Background &m_background;
    Links &m_links;
    LinkWatch m_watch;
    Timer m_next;
    bool m_isListing = false;
    Listeners<> m_looked;
    Subscription m_plugged;
};

} // namespace mb
