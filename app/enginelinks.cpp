// SPDX-License-Identifier: GPL-3.0-or-later
// Links: opened and closed, and those that come and go by themselves.
#include "app/enginecore.h"

#include <algorithm>

namespace mb {

void EngineCore::setBackground(Background *background)
{
    m_background = background;
    m_session.setBackground(background);
}

void EngineCore::openLink(const LinkAddress &address, const Finished &finished)
{
    const std::string text = address.text();
    const bool underWay = m_openings.count(text) > 0;
    if (finished)
        m_openings[text].finished.push_back(finished);
    if (!underWay)
        beginOpening(text, openAll(expandLink(address, m_session.families())));
}

void EngineCore::beginOpening(const std::string &address, Task<void> task)
{
    Opening &opening = m_openings[address];
    opening.scope = std::make_unique<Scope>(m_clock);
    opening.scope->spawn<void>(
        std::move(task), [this, address](const Result<void> &result) { endOpening(address, result); });
}

void EngineCore::endOpening(const std::string &address, const Result<void> &result)
{
    const auto opening = m_openings.extract(address); // first: who is answered may ask for it again
    if (!opening)
        return;
    for (const Finished &finished : opening.mapped().finished)
        finished(result);
}

Task<void> EngineCore::openAll(std::vector<LinkAddress> addresses)
{
    for (const LinkAddress &one : addresses) {
        m_closedByHand.erase(one.text());
        auto opening = m_session.openLinkSoon(one);
        const Result<Link *> link = co_await std::move(opening).attempt();
        if (!link) {
            couldNotOpen(one, link.error());
            co_return fail(link.error());
        }
        opened(**link);
        m_watched[*link].byItself = false;
        scan(**link);
    }
    co_return {};
}

void EngineCore::couldNotOpen(const LinkAddress &address, const Error &error)
{
    notice(Severity::Danger, address.shortName(), error.message());
    m_awaited.add(address);
    m_failed[address.text()] = diagnose(error);
    touch();
}

void EngineCore::opened(Link &link)
{
    m_failed.erase(link.address().text());
    m_awaited.forget(link.address().text());
    watch(link);
}

void EngineCore::openAwaited(const LinkAddress &address)
{
    if (m_openings.count(address.text()) == 0)
        beginOpening(address.text(), openReturned(address)); // it may not be ready yet
}

Task<void> EngineCore::openReturned(LinkAddress address)
{
    auto opening = m_session.openLinkSoon(address);
    Link *const link = co_await std::move(opening);
    opened(*link);
    notice(Severity::Good, address.shortName(), say("is there"));
    scan(*link);
    co_return {};
}

void EngineCore::closeLink(const std::string &address)
{
    m_awaited.forget(address);
    m_failed.erase(address);
    endOpening(address, fail(Fault::Cancelled, say("%1 was closed before it was open", address)));
    const auto parsed = LinkAddress::parse(address);
    Link *link = parsed ? m_session.findLink(*parsed) : nullptr;
    if (!link)
        return;
    m_closedByHand.insert(address);
    removeLink(*link);
}

void EngineCore::reopenLost()
{
    for (Link *link : m_session.links()) {
        if (link->state() == LinkState::Lost && !link->address().isRecording())
            m_session.reopen(*link);
    }
}

void EngineCore::welcomeReturned()
{
    for (Link *link : m_session.links()) {
        Watched &watched = m_watched[link];
        if (!watched.wasLost || link->state() != LinkState::Open)
            continue;
        watched.wasLost = false;
        notice(Severity::Good, link->address().shortName(), say("is back"));
        if (!hasOperationOn(*link)) // an update that waited for it must be alone with its unit
            scan(*link);
    }
}

bool EngineCore::hasOperationOn(const Link &link) const
{
    const auto devices = m_session.devices();
    return std::any_of(devices.begin(), devices.end(),
        [&](const Device *device) { return &device->link() == &link && hasOperation(m_session.idOf(*device)); });
}

void EngineCore::takeListings(std::vector<LinkListing> listings)
{
    m_listings = std::move(listings);
    if (m_opensByItself)
        openByItself();
    reopenLost();
    dropVanished();
    touch();
}

void EngineCore::dropVanished()
{
    for (Link *link : m_session.links()) {
        const auto watched = m_watched.find(link);
        if (link->state() != LinkState::Lost || watched == m_watched.end() || !watched->second.byItself)
            continue;
        const bool listed = std::any_of(m_listings.begin(), m_listings.end(),
            [link](const LinkListing &listing) { return listing.link == link->address(); });
        const auto devices = m_session.devices();
        const bool used = std::any_of(
            devices.begin(), devices.end(), [link](const Device *device) { return &device->link() == link; });
        if (!listed && !used)
            removeLink(*link);
    }
}

void EngineCore::openByItself()
{
    for (const LinkListing &listing : m_listings) {
        if (listing.link.scheme != "socketcan" || !listing.openable || m_session.findLink(listing.link)
            || m_closedByHand.count(listing.link.text()) > 0)
            continue;
        if (auto link = m_session.openLink(listing.link)) {
            m_failed.erase(listing.link.text());
            watch(**link);
            m_watched[*link].byItself = true;
            scan(**link);
        }
    }
}

} // namespace mb
