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

bool isSameUnit(const OwedStop &owed, std::string_view line, std::string_view selector)
{
    return owed.line == line && unitOf(owed.device) == unitOf(selector);
}

} // namespace

OwedStops::OwedStops(Clock &clock, MotionGuard *guard)
    : m_clock(clock)
    , m_guard(guard)
    , m_look(clock)
{
}

bool OwedStops::isDue(const OwedStop &owed) const
{
    return m_clock.now() - owed.since < DeviceStop::debtLimit;
}

void OwedStops::pay(Link &link)
{
    (void)takeOver(link);
    sendDue(link);
    lookAtBooks();
}

bool OwedStops::takeOver(Link &link)
{
    if (!m_guard)
        return false;
    auto taken = m_guard->takeOver(link, m_clock.now());
    std::erase(m_withOthers, &link);
    if (!taken) {
        m_withOthers.push_back(&link);
        return false;
    }
    for (OwedStop &owed : *taken) {
        const bool known = std::any_of(m_owed.begin(), m_owed.end(),
            [&owed](const OwedStop &other) { return isSameUnit(other, owed.line, owed.device); });
        if (!known)
            m_owed.push_back(std::move(owed));
    }
    return true;
}

void OwedStops::sendDue(Link &link) const
{
    for (const OwedStop &owed : m_owed) {
        if (owed.line == link.line() && isDue(owed))
            sendScript(link, owed.script);
    }
}

/// Guardians pay where no program has the line open.
void OwedStops::lookAtBooks()
{
    if (!m_guard || (m_owed.empty() && m_withOthers.empty()))
        return;
    const std::size_t before = m_owed.size();
    std::erase_if(m_owed, [this](OwedStop &owed) {
        const bool isThere = m_guard->isOwed(owed.line, owed.device);
        return std::exchange(owed.isWithGuardians, isThere) && !isThere;
    });
    m_look.startIn(lookPeriod, [this] { lookAgain(); });
    if (m_owed.size() != before)
        m_changed.notify();
}

/// A guardian may have been in the middle of a try when the link was opened.
void OwedStops::lookAgain()
{
    bool isMore = false;
    for (Link *const link : std::vector(m_withOthers)) {
        if (!takeOver(*link))
            continue;
        sendDue(*link);
        isMore = true;
    }
    lookAtBooks();
    if (isMore)
        m_changed.notify();
}

void OwedStops::add(Device &device)
{
    const DeviceStop &stop = device.stopping();
    if (!(stop.isDue() || stop.mayTurn()) || !stop.isForMotion() || device.link().address().isSimulated())
        return;
    if (const StopScript script = device.stopScript(); !script.isEmpty() && !device.family().capabilities.watchdog)
        m_owed.push_back({device.link().line(), device.selector(), script, stop.toldAt()});
    lookAtBooks();
}

void OwedStops::passTo(Device &device)
{
    if (!device.mayStop())
        return;
    const auto owed = std::find_if(m_owed.begin(), m_owed.end(),
        [&](const OwedStop &known) { return isSameUnit(known, device.link().line(), device.selector()); });
    if (owed == m_owed.end())
        return;
    const bool due = isDue(*owed);
    m_owed.erase(owed);
    if (due)
        device.stopping().inherit();
}

void OwedStops::settle(const Device &device)
{
    if (m_guard)
        m_guard->settle(device.link().line(), device.selector());
}

void OwedStops::leave(const std::string &line)
{
    std::erase_if(m_withOthers, [&line](const Link *link) { return link->line() == line; });
    if (m_guard)
        m_guard->leave(line);
}

void OwedStops::dismiss()
{
    for (const OwedStop &owed : m_owed) {
        if (m_guard)
            m_guard->settle(owed.line, owed.device);
    }
    m_owed.clear();
}

} // namespace mb
