// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/stoplane.h"

#include "app/guardian/client/wirescript.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>

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
    if (const auto form = portFormOf(way.form))
        m_port = guardian::makePort(*form, m_own);
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

guardian::Port::Sent StopOutlet::send(std::span<const std::uint8_t> message)
{
    if (message.empty()) // only a pause
        return Sent::All;
    if (m_aside)
        return m_aside(message) ? Sent::All : Sent::Later;
    return m_port->send(message);
}

void StopOutlet::forget()
{
    if (m_port)
        m_port->forget();
}

void StopLane::press(StopCause cause)
{
    constexpr std::chrono::hours untilServed{24}; // a line that takes nothing is tried
    served();
    const guardian::Time begin = m_clock.now().time_since_epoch() + patience;
    for (const StopOrders &orders : m_orders) {
        m_courses.push_back({orders.outlet});
        for (const guardian::Script &script : cause == StopCause::User ? orders.scripts : orders.own)
            m_courses.back().runner.add(0, script, begin, untilServed);
    }
    m_due.startIn(patience, [this] { proceed(); });
}

void StopLane::served()
{
    m_due.stop();
    for (Course &course : m_courses)
        course.outlet->forget();
    m_courses.clear();
}

void StopLane::proceed()
{
    std::optional<guardian::Time> next;
    for (Course &course : m_courses) {
        (void)course.runner.proceed(m_clock.now().time_since_epoch());
        if (const auto due = course.runner.due(); due && (!next || *due < *next))
            next = due;
    }
    if (next)
        m_due.start(Instant(*next), [this] { proceed(); });
}

std::vector<guardian::Script> laneScripts(StopScript script, Outlet::Form form, StopCause cause)
{
    if (cause != StopCause::User)
        std::erase_if(script.steps, [](const StopStep &step) { return step.forAll; });
    guardian::Script steps = wireScript(script, form);
    if (form == Outlet::Form::Stream) {
        for (std::size_t i = 0; i < steps.size(); ++i) {
            if (script.steps[i].taken > std::chrono::milliseconds::zero())
                steps[i].wait = script.steps[i].taken;
        }
        return {std::move(steps)};
    }
    std::vector<guardian::Script> each;
    for (guardian::Step &step : steps) {
        step.reply.clear();
        each.emplace_back(1, std::move(step));
    }
    return each;
}

std::vector<StopOrders> stopOrdersOf(const Session &session, const std::vector<StopOrders> &known)
{
    std::vector<StopOrders> all;
    for (Link *link : session.links()) {
        const Outlet way = link->state() == LinkState::Open ? link->outlet() : Outlet{};
        if (!way.isInheritable() || !portFormOf(way.form))
            continue;
        StopOrders orders;
        for (Device *device : session.devices()) {
            if (&device->link() != link || !device->mayStop())
                continue;
            const StopScript script = device->stopScript();
            std::ranges::move(laneScripts(script, way.form), std::back_inserter(orders.scripts));
            if (device->stopping().hasMoved())
                std::ranges::move(laneScripts(script, way.form, StopCause::Program), std::back_inserter(orders.own));
        }
        const auto served
            = std::ranges::find_if(known, [&](const StopOrders &other) { return other.outlet->serves(*link, way); });
        orders.outlet = served != known.end() ? served->outlet : std::make_shared<StopOutlet>(*link, way);
        all.push_back(std::move(orders));
    }
    return all;
}

} // namespace mb
