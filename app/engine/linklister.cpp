// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/engine/linklister.h"

#include "app/engine/links.h"

namespace mb {
namespace {

constexpr Duration listingPeriod = std::chrono::seconds(1);

} // namespace

LinkLister::LinkLister(Clock &clock, Background &background, Links &links)
    : m_background(background)
    , m_links(links)
    , m_watch(clock)
    , m_next(clock)
    , m_plugged(m_watch.changed().add([this] { look(); }))
{
}

void LinkLister::look()
{
    m_next.startIn(listingPeriod, [this] { look(); });
    m_looked.notify();
    if (std::exchange(m_isListing, true))
        return;
    const auto found = std::make_shared<std::vector<LinkListing>>();
    m_background.run(
        "links", [found] { *found = listLinks(); },
        [this, found] {
            m_isListing = false;
            m_links.takeListings(std::move(*found));
        });
}

} // namespace mb
