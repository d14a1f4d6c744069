// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/stoplane.h"

#include "app/guardian/client/wirescript.h"

#include <algorithm>

#include <fcntl.h>
#include <unistd.h>

namespace mb {

StopOutlet::StopOutlet(const Link &link, const Outlet &way)
    : m_link(&link)
    , m_descriptor(way.descriptor)
    , m_aside(way.aside)
{
    if (m_aside)
        return;
    m_own = ::fcntl(way.descriptor, F_DUPFD_CLOEXEC, 0);
    m_port = guardian::makePort(wordOf(way.form), m_own);
}

StopOutlet::~StopOutlet()
{
    if (m_own >= 0)
        ::close(m_own);
}

bool StopOutlet::serves(const Link &link, const Outlet &way) const
{
    return m_link == &link && m_descriptor == way.descriptor;
}

void StopOutlet::send(const guardian::Bytes &message)
{
    if (m_aside)
        (void)m_aside(message);
    else
        (void)m_port->send(message);
}

void StopLane::press()
{
    m_due.startIn(patience, [this] { send(); });
}

void StopLane::served()
{
    m_due.stop();
}

void StopLane::send()
{
    for (const StopOrders &orders : m_orders) {
        for (const guardian::Bytes &message : orders.messages)
            orders.outlet->send(message);
    }
}

std::vector<StopOrders> stopOrdersOf(const Session &session, const std::vector<StopOrders> &known)
{
    std::vector<StopOrders> all;
    for (Link *link : session.links()) {
        const Outlet way = link->state() == LinkState::Open ? link->outlet() : Outlet{};
        if (!way.isInheritable() || !wordOf(way.form))
            continue;
        StopOrders orders;
        for (const Device *device : session.devices()) {
            if (&device->link() != link || !device->mayStop())
                continue;
            for (guardian::Step &step : wireScript(device->stopScript(), way.form))
                orders.messages.push_back(std::move(step.bytes));
        }
        const auto served = std::find_if(
            known.begin(), known.end(), [&](const StopOrders &other) { return other.outlet->serves(*link, way); });
        orders.outlet = served != known.end() ? served->outlet : std::make_shared<StopOutlet>(*link, way);
        all.push_back(std::move(orders));
    }
    return all;
}

} // namespace mb
