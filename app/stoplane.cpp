// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/stoplane.h"

#include "app/guardian/client/wirescript.h"

#include <algorithm>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

namespace mb {

StopLane::StopLane()
    : m_thread([this] { run(); })
{
}

StopLane::~StopLane()
{
    {
        const std::lock_guard lock(m_mutex);
        m_ending = true;
    }
    m_wake.notify_one();
    m_thread.join();
    for (const Outlet &outlet : m_outlets)
        ::close(outlet.own);
}

void StopLane::press()
{
    {
        const std::lock_guard lock(m_mutex);
        m_pressed = true;
        m_sent = false;
        m_pressedAt = std::chrono::steady_clock::now();
    }
    m_wake.notify_one();
}

void StopLane::served()
{
    const std::lock_guard lock(m_mutex);
    m_pressed = false;
}

void StopLane::run()
{
    std::unique_lock lock(m_mutex);
    while (true) {
        m_wake.wait(lock, [this] { return m_ending || (m_pressed && !m_sent); });
        if (m_ending)
            return;
        const auto due = m_pressedAt + patience;
        if (m_wake.wait_until(lock, due, [this] { return m_ending; }))
            return;
        if (m_pressed)
            send();
        m_sent = true;
    }
}

/// Nothing here waits for a line: a port takes what it can (guardian/port.h).
void StopLane::send()
{
    for (const Outlet &outlet : m_outlets) {
        for (const guardian::Bytes &message : outlet.messages)
            (void)outlet.port->send(message);
    }
}

std::vector<StopLane::Outlet> StopLane::outletsOf(const Session &session)
{
    std::vector<Outlet> found;
    for (Link *link : session.links()) {
        const mb::Outlet way = link->state() == LinkState::Open ? link->outlet() : mb::Outlet{};
        if (!way.isInheritable() || way.form == mb::Outlet::Form::SpiSocket || !wordOf(way.form))
            continue;
        Outlet outlet;
        outlet.link = link;
        outlet.descriptor = way.descriptor;
        outlet.form = wordOf(way.form);
        for (const Device *device : session.devices()) {
            if (&device->link() != link || !device->mayStop())
                continue;
            for (guardian::Step &step : wireScript(device->stopScript(), way.form))
                outlet.messages.push_back(std::move(step.bytes));
        }
        found.push_back(std::move(outlet));
    }
    return found;
}

void StopLane::follow(const Session &session)
{
    std::vector<Outlet> found = outletsOf(session);
    const auto same = [](const Outlet &a, const Outlet &b) { return a.link == b.link && a.descriptor == b.descriptor; };
    const std::lock_guard lock(m_mutex);
    for (Outlet &outlet : found) {
        const auto known = std::find_if(
            m_outlets.begin(), m_outlets.end(), [&](const Outlet &other) { return same(outlet, other); });
        if (known != m_outlets.end()) {
            outlet.own = std::exchange(known->own, -1);
            outlet.port = std::move(known->port);
        } else {
            outlet.own = ::fcntl(outlet.descriptor, F_DUPFD_CLOEXEC, 0);
            outlet.port = guardian::makePort(outlet.form, outlet.own);
        }
    }
    for (const Outlet &gone : m_outlets) {
        if (gone.own >= 0)
            ::close(gone.own);
    }
    m_outlets = std::move(found);
}

} // namespace mb
