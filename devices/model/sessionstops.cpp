// SPDX-License-Identifier: GPL-3.0-or-later
// Session: STOP, and the stops that are owed.
#include "model/session.h"
#include "transport/linkidentity.h"

#include <algorithm>

namespace mb {
namespace {

using namespace std::chrono_literals;

constexpr Duration owingRetry = 50ms; // a stop that is owed leaves within 100 ms after its link can be opened

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

void Session::stopAll(StopCause cause)
{
    for (Entry &entry : m_devices) {
        Device &device = *entry.device;
        if (entry.stream && entry.stream->isRunning())
            entry.stream->stop();
        else if (cause == StopCause::User ? device.mayStop().has_value() : device.stopping().hasMoved())
            device.stop();
    }
}

void Session::dismissStops()
{
    for (const OwedStop &owed : m_owed) {
        if (m_guard)
            m_guard->settle(owed.line, owed.device);
    }
    m_owed.clear();
    for (Entry &entry : m_devices) {
        if (entry.device->stopping().mayTurn())
            entry.device->stopping().dismiss();
    }
    m_changed.notify();
}

Result<void> Session::releaseMoves(Device &lead)
{
    for (Entry &entry : m_devices) {
        Device &device = *entry.device;
        if (&device.link() != &lead.link() || !device.keepsMove())
            continue;
        if (!entry.stream || !entry.stream->isRunning())
            return fail(Fault::Unsafe,
                say("number %1 still keeps a move that was stopped before it began, and would begin it too",
                    device.identity().address),
                say("give it a new one, or switch it off and on"));
        if (!device.guard().stands())
            return fail(Fault::Unsafe, device.guard().reason());
    }
    auto released = lead.releaseMoves();
    if (!released)
        return released;
    for (Entry &entry : m_devices) {
        if (&entry.device->link() == &lead.link())
            entry.device->moveReleased();
    }
    return released;
}

const Session::OpenLink *Session::openLinkOf(const Link &link) const
{
    const auto open
        = std::find_if(m_links.begin(), m_links.end(), [&](const OpenLink &o) { return o.link.get() == &link; });
    return open == m_links.end() ? nullptr : &*open;
}

/// Before all who listen on the link for themselves: they begin to ask at once.
void Session::linkChanged(OpenLink &open, LinkState state)
{
    if (state == LinkState::Open)
        payStops(open);
    else if (state == LinkState::Lost)
        retryOwing();
    m_changed.notify();
}

void Session::payStops(OpenLink &open)
{
    Link &link = *open.link;
    const std::string line = linkIdentity(link.address());
    const bool same = open.line.empty() || open.line == line;
    open.line = line;
    if (m_guard) {
        for (OwedStop &owed : m_guard->takeOver(link, m_clock.now())) {
            const bool known = std::any_of(m_owed.begin(), m_owed.end(),
                [&owed](const OwedStop &other) { return isSameUnit(other, owed.line, owed.device); });
            if (!known)
                m_owed.push_back(std::move(owed));
        }
    }
    std::erase_if(m_owed, [this](const OwedStop &owed) { return m_clock.now() - owed.since >= DeviceStop::debtLimit; });
    for (const OwedStop &owed : m_owed) {
        if (owed.line == line)
            sendScript(link, owed.script);
    }
    for (Entry &entry : m_devices) {
        if (&entry.device->link() != &link)
            continue;
        entry.device->stopping().linkIsBack(same);
        inheritStop(entry);
    }
}

/// The link is closed while nobody has seen the motor stand.
void Session::passOnStop(Entry &entry)
{
    const Device &device = *entry.device;
    const OpenLink *const open = openLinkOf(device.link());
    const DeviceStop &stop = device.stopping();
    if (!open || !stop.isDue() || !stop.isForMotion() || device.link().address().isSimulated())
        return;
    if (const StopScript script = device.stopScript(); !script.isEmpty() && !device.family().capabilities.watchdog)
        m_owed.push_back({open->line, device.selector(), script, m_clock.now()});
}

void Session::inheritStop(Entry &entry)
{
    Device &device = *entry.device;
    const OpenLink *const open = openLinkOf(device.link());
    if (!open || !device.mayStop())
        return;
    const auto owed = std::find_if(m_owed.begin(), m_owed.end(),
        [&](const OwedStop &known) { return isSameUnit(known, open->line, device.selector()); });
    if (owed == m_owed.end())
        return;
    m_owed.erase(owed);
    device.stopping().inherit();
}

void Session::followStop(Entry &entry)
{
    const DeviceStop &stop = entry.device->stopping();
    const OpenLink *const open = openLinkOf(entry.device->link());
    if (stop.state() == StopState::Seen && m_guard && open)
        m_guard->settle(open->line, entry.device->selector());
    if (stop.state() == StopState::Owed)
        retryOwing();
    m_stopChanged.notify(*entry.device);
    m_changed.notify();
}

bool Session::isOwing(const Link &link) const
{
    return link.state() == LinkState::Lost && !link.address().isRecording()
        && std::any_of(m_devices.begin(), m_devices.end(), [&link](const Entry &entry) {
               return &entry.device->link() == &link && entry.device->stopping().state() == StopState::Owed;
           });
}

void Session::retryOwing()
{
    if (m_retry.isActive()
        || std::none_of(m_links.begin(), m_links.end(), [this](const OpenLink &open) { return isOwing(*open.link); }))
        return;
    m_retry.startIn(owingRetry, [this] {
        for (OpenLink &open : m_links) {
            if (isOwing(*open.link))
                reopen(*open.link);
        }
        retryOwing();
    });
}

} // namespace mb
