// SPDX-License-Identifier: GPL-3.0-or-later
// Links that come and go by themselves.
#include "app/enginecore.h"

#include <algorithm>

namespace mb {

void EngineCore::reopenLost()
{
    for (Link *link : m_session.links()) {
        if (link->state() == LinkState::Lost && !link->address().isRecording())
            (void)link->open();
    }
}

void EngineCore::welcomeReturned()
{
    for (Link *link : m_session.links()) {
        Watched &watched = m_watched[link];
        if (!watched.wasLost || link->state() != LinkState::Open)
            continue;
        watched.wasLost = false;
        notice(Severity::Good, link->address().shortName(), "is back");
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
