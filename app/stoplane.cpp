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

bool StopOutlet::send(const guardian::Bytes &message)
{
    return m_aside ? m_aside(message) : m_port->send(message) != guardian::Port::Sent::Later;
}

void StopLane::press(StopCause cause)
{
    m_courses.clear();
    for (const StopOrders &orders : m_orders)
        m_courses.push_back({orders.outlet, cause == StopCause::User ? orders.steps : orders.own});
    m_due.startIn(patience, [this] { proceed(); });
}

void StopLane::served()
{
    m_due.stop();
    m_courses.clear();
}

void StopLane::proceed()
{
    for (Course &course : m_courses) {
        if (course.notBefore <= m_clock.now())
            proceed(course);
    }
    std::erase_if(m_courses, [](const Course &course) { return course.next == course.steps.size(); });
    const auto next = std::ranges::min_element(
        m_courses, [](const Course &a, const Course &b) { return a.notBefore < b.notBefore; });
    if (next != m_courses.end())
        m_due.start(next->notBefore, [this] { proceed(); });
}

/// As far as the line takes it. Its end is where no step wants another round.
void StopLane::proceed(Course &course)
{
    const guardian::Script &steps = course.steps;
    std::chrono::milliseconds rest{0};
    for (; course.next < steps.size(); ++course.next) {
        const guardian::Step &step = steps[course.next];
        if (step.attempts <= course.round || step.bytes.empty())
            continue;
        if (!course.outlet->send(step.bytes)) {
            course.notBefore = m_clock.now() + std::chrono::milliseconds(1);
            return;
        }
    }
    ++course.round;
    for (const guardian::Step &step : steps) {
        if (step.attempts > course.round && !step.bytes.empty())
            rest = std::max(rest, step.wait);
    }
    if (rest.count() == 0)
        return;
    course.next = 0;
    course.notBefore = m_clock.now() + rest;
}

std::vector<StopOrders> stopOrdersOf(const Session &session, const std::vector<StopOrders> &known)
{
    std::vector<StopOrders> all;
    for (Link *link : session.links()) {
        const Outlet way = link->state() == LinkState::Open ? link->outlet() : Outlet{};
        if (!way.isInheritable() || !wordOf(way.form))
            continue;
        StopOrders orders;
        for (Device *device : session.devices()) {
            if (&device->link() != link || !device->mayStop())
                continue;
            for (guardian::Step &step : wireScript(device->stopScript(), way.form)) {
                if (device->stopping().hasMoved())
                    orders.own.push_back(step);
                orders.steps.push_back(std::move(step));
            }
        }
        const auto served
            = std::ranges::find_if(known, [&](const StopOrders &other) { return other.outlet->serves(*link, way); });
        orders.outlet = served != known.end() ? served->outlet : std::make_shared<StopOutlet>(*link, way);
        all.push_back(std::move(orders));
    }
    return all;
}

} // namespace mb
