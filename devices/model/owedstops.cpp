// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/owedstops.h"

#include "model/family.h"
#include "model/identity.h"

#include <algorithm>
#include <string_view>
#include <utility>

namespace mb {
namespace {

constexpr Duration lookPeriod = std::chrono::seconds(1);

/// The name of an interface may change, the device on the line does not.
bool isOf(const OwedStop &owed, std::string_view line, std::string_view selector)
{
    return owed.line == line && partsOf(owed.device).device == partsOf(selector).device;
}

/// The device itself shows what became of its motor, and tells it to stop.
bool follows(Device &device)
{
    return device.stopping().hasMoved() || device.stopping().isForMotion();
}

} // namespace

OwedStops::OwedStops(Clock &clock, DeviceBook &devices, MotionGuard *guard)
    : m_clock(clock)
    , m_devices(devices)
    , m_guard(guard)
    , m_look(clock)
{
}

std::vector<OwedStop> OwedStops::unseen() const
{
    std::vector<OwedStop> unseen = m_owed;
    std::erase_if(unseen, [this](const OwedStop &owed) { return isFollowed(owed); });
    return unseen;
}

bool OwedStops::isOwed(std::string_view line, std::string_view selector) const
{
    return std::ranges::any_of(m_owed, [&](const OwedStop &one) {
        return isOf(one, line, selector) && DeviceStop::isStillOwed(one.since, m_clock.now());
    });
}

bool OwedStops::isFollowed(const OwedStop &owed, const Link *on) const
{
    const std::vector<Device *> all = m_devices.all();
    return std::ranges::any_of(all, [&owed, on](Device *device) {
        return (!on || on == &device->link()) && isOf(owed, device->link().line(), device->selector())
            && follows(*device);
    });
}

void OwedStops::pay(Link &link)
{
    std::erase_if(m_lines, [&link](const Line &line) { return line.link == &link; });
    m_lines.push_back({&link});
    look();
}

/// Once a second: a guardian may have been in the middle of a try when a link was opened, and what it writes down later it leaves to
/// whoever has the line.
void OwedStops::look()
{
    for (Line &line : m_lines)
        line.isOurs = line.isOurs || !m_guard || m_guard->own(*line.link);
    const std::vector<OwedStop> before = m_owed;
    read();
    if (!m_owed.empty() || !m_lines.empty())
        m_look.startIn(lookPeriod, [this] { look(); });
    sendDue();
    for (Device *device : m_devices.all())
        passTo(*device);
    if (!std::ranges::equal(
            before, m_owed, [](const OwedStop &a, const OwedStop &b) { return isOf(a, b.line, b.device); }))
        m_devices.changed().notify();
}

void OwedStops::read()
{
    const std::vector<OwedStop> booked = m_guard ? m_guard->owed(m_clock.now()) : std::vector<OwedStop>();
    std::erase_if(m_unbooked, [&booked](const OwedStop &mine) {
        return std::ranges::any_of(booked, [&mine](const OwedStop &one) { return isOf(mine, one.line, one.device); });
    });
    m_owed = m_unbooked;
    m_owed.insert(m_owed.end(), booked.begin(), booked.end());
}

/// Once an opening; again only what was told anew.
void OwedStops::sendDue()
{
    std::vector<std::pair<Link *, StopScript>> due; // sending may lose a link, which leaves its line
    for (const OwedStop &owed : m_owed) {
        const auto line = std::ranges::find_if(
            m_lines, [&owed](const Line &one) { return one.isOurs && one.link->line() == owed.line; });
        if (line == m_lines.end() || !DeviceStop::isStillOwed(owed.since, m_clock.now())
            || isFollowed(owed, line->link) // one on a name that the line has lost can follow nothing
            || std::ranges::any_of(line->sent, [&owed](const OwedStop &one) {
                   return isOf(one, owed.line, owed.device) && owed.since - one.since < lookPeriod;
               }))
            continue;
        line->sent.push_back(owed);
        due.emplace_back(line->link, owed.script);
    }
    for (const auto &[link, script] : due)
        sendScript(*link, script);
}

void OwedStops::add(Device &device)
{
    const DeviceStop &stop = device.stopping();
    const StopScript script = device.stopScript();
    if (!(stop.isDue() || stop.mayTurn()) || !stop.isForMotion() || device.link().address().isSimulated()
        || device.family().capabilities.watchdog || script.isEmpty())
        return;
    const OwedStop owed{device.link().line(), device.selector(), script, stop.toldAt()};
    if (!m_guard || !m_guard->owe(owed, m_clock.now())) {
        std::erase_if(m_unbooked, [&owed](const OwedStop &other) { return isOf(other, owed.line, owed.device); });
        m_unbooked.push_back(owed);
    }
    look();
}

void OwedStops::passTo(Device &device)
{
    const auto owed = std::ranges::find_if(
        m_owed, [&device](const OwedStop &one) { return isOf(one, device.link().line(), device.selector()); });
    if (owed != m_owed.end() && !follows(device) && device.mayStop())
        device.stopping().inherit(owed->since);
}

void OwedStops::settle(const std::string &line, const std::string &device)
{
    const auto isMeant = [&](const OwedStop &owed) { return isOf(owed, line, device); };
    std::erase_if(m_unbooked, isMeant);
    std::erase_if(m_owed, isMeant);
    if (m_guard)
        m_guard->settle(line, device);
}

void OwedStops::leave(const Link &link)
{
    std::erase_if(m_lines, [&link](const Line &one) { return one.link == &link; });
    const bool isOpenElsewhere = std::ranges::any_of(
        m_lines, [&link](const Line &one) { return one.link->line() == link.line(); }); // under another name
    if (m_guard && !isOpenElsewhere)
        m_guard->leave(link.line());
}

void OwedStops::dismiss()
{
    for (const OwedStop &owed : unseen())
        settle(owed.line, owed.device);
}

} // namespace mb
