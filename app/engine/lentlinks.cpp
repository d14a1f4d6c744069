// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/engine/lentlinks.h"

#include <algorithm>
#include <utility>

namespace mb {

void LentLinks::forget()
{
    giveBack();
    m_addresses.clear();
    m_links.clear();
}

Result<void> LentLinks::take(const std::vector<std::string> &addresses)
{
    if (addresses.empty())
        return fail(Fault::Refused, say("no link is open on which such units may be"), say("open it first"));
    std::vector<Link *> lent;
    for (const std::string &address : addresses) {
        Link *const link = linkAt(address);
        if (lend(link)) {
            lent.push_back(link);
            continue;
        }
        for (const Link *const other : lent)
            m_context.operations.takeBack(*other);
        if (link)
            MB_TRY_VOID(link->address().takesOrders());
        return fail(Fault::Timeout, say("%1 is not open, or something runs there", address),
            say("open it, or end what runs there first"));
    }
    m_addresses = addresses;
    m_links = std::move(lent);
    m_lost = 0;
    return {};
}

void LentLinks::giveBack()
{
    for (const std::string &address : m_addresses) {
        if (const Link *const link = linkAt(address))
            m_context.operations.takeBack(*link);
    }
}

bool LentLinks::areThere() const
{
    const auto links = m_context.session.links();
    return std::ranges::all_of(
        m_links, [&links](const Link *link) { return std::ranges::find(links, link) != links.end(); });
}

bool LentLinks::isOneMoreLost()
{
    const auto lost = std::ranges::count_if(m_links, [](const Link *link) { return link->state() == LinkState::Lost; });
    return std::exchange(m_lost, lost) < lost;
}

Link *LentLinks::linkAt(const std::string &address) const
{
    const auto links = m_context.session.links();
    const auto found
        = std::ranges::find_if(links, [&address](const Link *link) { return link->address().text() == address; });
    return found == links.end() ? nullptr : *found;
}

/// By hand: a self-test would go on with that motion, or the queue turn it off without a word.
bool LentLinks::isDriven(const Link &link) const
{
    const auto devices = m_context.session.devices();
    return std::ranges::any_of(devices,
        [&](Device *device) { return &device->link() == &link && m_context.session.stream(*device).isRunning(); });
}

bool LentLinks::lend(Link *link)
{
    if (!link || link->state() != LinkState::Open || !link->address().takesOrders() || isDriven(*link)
        || !m_context.operations.lend(*link))
        return false;
    m_scans.giveWay(*link);
    return true;
}

} // namespace mb
