// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/session.h"

#include "async/sleep.h"
#include "model/family.h"
#include "model/passivediscovery.h"

#include <algorithm>
#include <utility>

namespace mb {

Session::Session(Clock &clock, std::span<const Family *const> families, MotionGuard *guard)
    : m_clock(clock)
    , m_families(families)
    , m_memory(clock)
    , m_links(clock, families)
    , m_devices(clock, m_links, m_memory, guard)
    , m_stops(clock, m_links, m_devices, guard)
    , m_linksChanged(m_links.changed().add([this] { m_changed.notify(); }))
    , m_devicesChanged(m_devices.changed().add([this] { m_changed.notify(); }))
{
}

Session::~Session()
{
    for (const DeviceBook::Entry &entry :
        m_devices.entries()) { // a motor that another program drives is not ours to stop
        if (entry.isStreaming())
            entry.stream->stop();
    }
}

void Session::setBackground(Background *background)
{
    m_links.setBackground(background);
    m_memory.setBackground(background);
}

void Session::closeLink(Link &link)
{
    m_stops.beforeClose(link);
    m_devices.forget(link);
    m_stops.leave(link);
    m_links.close(link);
}

Result<void> Session::seek(ReplayLink &link, Duration position)
{
    m_devices.renew(link); // nobody must hear the replay jump
    auto sought = link.seek(position);
    m_changed.notify();
    return sought;
}

ScanRound::Surroundings Session::aroundScan(Link &link)
{
    return {m_families, m_clock, clockOf(link),
        [this, &link](const Family &family, const Identity &identity, const std::vector<Device *> &seen) -> Device & {
            return m_devices.adopt(link, family, identity, seen);
        },
        [this, &link](const Family &family) { return m_memory.seenOn(link, family); },
        [this, &link](const Family &family) { return m_devices.known(link, family); },
        [this, &link](const Message &what) { m_links.remark(link, what); },
        [this, &link](const std::vector<Device *> &seen, bool complete) { m_memory.remember(link, seen, complete); }};
}

Task<std::vector<Device *>> Session::scan(Link &link, ScanOptions options)
{
    if (ReplayLink *const recording = replayOf(link)) {
        co_return co_await discoverPassively(*recording);
    }
    ScanRound round(link, std::move(options), aroundScan(link));
    round.start();
    co_await round.done().wait();
    if (round.error())
        co_return fail(*round.error());
    round.setComplete();
    const auto rank = [this](const Device *device) {
        const auto family = std::ranges::find(m_families, &device->family());
        return std::pair(family - m_families.begin(), device->identity().address);
    };
    std::vector<Device *> seen = round.seen();
    std::ranges::stable_sort(seen, [&rank](const Device *a, const Device *b) { return rank(a) < rank(b); });
    co_return seen;
}

Task<std::vector<Device *>> Session::ask(Link &link, DeviceSelector selector)
{
    ScanRound round(link, {}, aroundScan(link));
    round.startFor(selector);
    co_await round.done().wait();
    if (round.error())
        co_return fail(*round.error());
    co_return round.seen();
}

namespace {

Error nobody(const DeviceSelector &selector, bool inRecording)
{
    const std::string link = selector.link.text();
    if (inRecording)
        return {Fault::Timeout, say("no %1 sends as number %2 in %3", selector.family, selector.address, link),
            say("a scan of the recording lists who does")};
    return {Fault::Timeout, say("no %1 answers as number %2 on %3", selector.family, selector.address, link)};
}

} // namespace

/// A programmer does not tell whom it hangs on, so nobody else of the family may answer. `seen` answered to the question for it. One
/// that may turn is told to stop for as long as it takes, which no bootloader is.
Task<Device *> Session::adoptSilent(Link &link, DeviceSelector selector, std::vector<Device *> seen)
{
    Error error = nobody(selector, false);
    const auto family = std::ranges::find(m_families, selector.family, [](const Family *f) { return f->key; });
    if (family == m_families.end() || (*family)->routes.empty() || selector.session
        || std::ranges::find((*family)->links, link.kind()) == (*family)->links.end())
        co_return fail(std::move(error));
    if ((*family)->probe) // nobody else was asked
        seen = co_await scan(link);
    for (Device *const device : seen) {
        const Identity &identity = device->identity();
        if (identity.family != selector.family)
            continue;
        if (identity.address == selector.address)
            co_return device;
        error.remedy = say(
            "%1 answers, and a programmer would not tell them apart: take all others off the line", device->selector());
    }
    if (!error.remedy.empty())
        co_return fail(std::move(error));
    if (m_stops.mayTurn(link, selector))
        co_return fail(Fault::Unsafe, say("the motor was not seen to stand"),
            say("cut its power and try again after 10 minutes, or look at it and say in the window that it stands"));
    Identity silent;
    silent.family = selector.family;
    silent.address = selector.address;
    silent.state = DeviceState::Bootloader;
    const std::string_view otherwise = updateWords(**family).silent;
    const Message cause = say("nothing answers: no power, wrong wiring, another rate, or no program that runs");
    silent.detail = otherwise.empty() ? say("%1; update it", cause)
                                      : say("%1; update it, or %2", cause, Message::label(otherwise));
    co_return &m_devices.adopt(link, **family, silent, {});
}

Task<Device *> Session::connect(DeviceSelector selector, bool mayBeSilent)
{
    Link *const link = co_await openLinkSoon(selector.link);
    ReplayLink *const recording = replayOf(*link);
    auto looking = recording ? discoverPassively(*recording) : ask(*link, selector);
    const std::vector<Device *> seen = co_await std::move(looking);
    std::vector<Device *> fitting;
    std::vector<const Device *> others; // of that number, of another session
    for (Device *device : seen) {
        const Identity &identity = device->identity();
        if (identity.family != selector.family || identity.address != selector.address)
            continue;
        if (!selector.session || identity.session == selector.session)
            fitting.push_back(device);
        else
            others.push_back(device);
    }
    if (fitting.empty() && !others.empty())
        co_return fail(Fault::Timeout, say("number %1 has another session", selector.address),
            others.size() == 1 ? say("it is %1", others[0]->selector())
                               : say("name one: %1 or %2", others[0]->selector(), others[1]->selector()));
    if (fitting.empty() && mayBeSilent && !recording)
        co_return co_await adoptSilent(*link, std::move(selector), seen);
    if (fitting.empty())
        co_return fail(nobody(selector, recording));
    if (fitting.size() > 1)
        co_return fail(Fault::Refused, say("%1 units answer as number %2", fitting.size(), selector.address),
            say("name one: %1 or %2", fitting[0]->selector(), fitting[1]->selector()));
    co_return fitting.front();
}

Task<std::vector<Device *>> Session::discoverPassively(ReplayLink &link)
{
    PassiveDiscovery discovery(m_families, [this, &link](const Family &family, const Identity &seen) {
        (void)m_devices.adoptRecorded(link, family, seen);
    });
    while (true) {
        const auto complete = link.survey([&](const LoggedFrame &logged) {
            CanFrame frame = logged.frame;
            frame.time = Instant(logged.time);
            discovery.take(frame, logged.direction == LogDirection::Sent);
        });
        if (!complete)
            co_return fail(complete.error());
        if (*complete)
            break;
        co_await Sleep(m_clock, Duration::zero()); // others get their turn
    }
    std::vector<Device *> found = m_devices.on(link);
    std::ranges::sort(found, [](const Device *a, const Device *b) {
        return std::pair(a->identity().family, a->identity().address)
            < std::pair(b->identity().family, b->identity().address);
    });
    co_return found;
}

} // namespace mb
