// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/owedstops.h"

#include "model/family.h"

#include <algorithm>
#include <string_view>
#include <utility>

namespace mb {
namespace {

constexpr Duration lookPeriod = std::chrono::seconds(1);

/// "abstractdc:3" of "socketcan:can0/abstractdc:3": the name of an interface may change, the device on the line does not.
std::string_view unitOf(std::string_view selector)
{
    return selector.substr(selector.rfind('/') + 1);
}

bool isOf(const OwedStop &owed, std::string_view line, std::string_view selector)
{
    return owed.line == line && unitOf(owed.device) == unitOf(selector);
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

bool OwedStops::isFollowed(const OwedStop &owed) const
{
    const std::vector<Device *> all = m_devices.all();
    return std::ranges::any_of(all,
        [&owed](Device *device) { return isOf(owed, device->link().line(), device->selector()) && follows(*device); });
}

void OwedStops::pay(Link &link)
{
    std::erase(m_withOthers, &link);
    const bool isOurs = !m_guard || m_guard->own(link);
    if (!isOurs)
        m_withOthers.push_back(&link);
    look();
    if (isOurs)
        sendDue(link);
}

void OwedStops::sendDue(Link &link) const
{
    for (const OwedStop &owed : m_owed) {
        if (owed.line == link.line() && m_clock.now() - owed.since < DeviceStop::debtLimit && !isFollowed(owed))
            sendScript(link, owed.script);
    }
}

/// Guardians pay where no program has the line open, and one may have been in the middle of a try when a link was opened.
void OwedStops::look()
{
    const auto theirs
        = std::partition(m_withOthers.begin(), m_withOthers.end(), [this](Link *link) { return !m_guard->own(*link); });
    const std::vector<Link *> ours(theirs, m_withOthers.end());
    m_withOthers.erase(theirs, m_withOthers.end());
    const std::vector<OwedStop> booked = m_guard ? m_guard->owed(m_clock.now()) : std::vector<OwedStop>();
    std::erase_if(m_unbooked, [&booked](const OwedStop &mine) {
        return std::ranges::any_of(booked, [&mine](const OwedStop &one) { return isOf(mine, one.line, one.device); });
    });
    const auto before = std::exchange(m_owed, m_unbooked);
    m_owed.insert(m_owed.end(), booked.begin(), booked.end());
    if (!m_owed.empty() || !m_withOthers.empty())
        m_look.startIn(lookPeriod, [this] { look(); });
    for (Link *const link : ours)
        sendDue(*link);
    if (std::ranges::equal(
            before, m_owed, [](const OwedStop &a, const OwedStop &b) { return isOf(a, b.line, b.device); }))
        return;
    for (Device *device : m_devices.all())
        passTo(*device);
    m_devices.changed().notify();
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

void OwedStops::leave(const std::string &line)
{
    std::erase_if(m_withOthers, [&line](const Link *link) { return link->line() == line; });
    if (m_guard)
        m_guard->leave(line);
}

void OwedStops::dismiss()
{
    for (const OwedStop &owed : unseen())
        settle(owed.line, owed.device);
}

} // namespace mb
