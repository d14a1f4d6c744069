// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/session.h"

#include "async/event.h"
#include "transport/linkcatalog.h"
#include "transport/seriallink.h"

#include <algorithm>

namespace mb {
namespace {

/// A scan reports a unit before it has read its texts: those of the same session are still true.
Identity merged(const Identity &known, Identity seen)
{
    if (seen.session != known.session)
        return seen;
    seen.name = seen.name.empty() ? known.name : seen.name;
    seen.serial = seen.serial.empty() ? known.serial : seen.serial; // descriptors come one after the other
    if (seen.descriptors.empty())
        seen.descriptors = known.descriptors;
    return seen;
}

constexpr Duration commitPeriod = std::chrono::milliseconds(10);

} // namespace

/// Gathers what the families of one scan find.
class Session::ScanRound {
public:
    struct Sink final : ScanSink {
        Sink(ScanRound &scanRound, const Family &scanned)
            : round(scanRound)
            , family(scanned)
        {
        }
        void found(const Identity &identity) override
        {
            round.m_session.adopt(round.m_link, family, identity, round.seen);
        }
        void progress(const Message &what, int passed, int total) override
        {
            if (round.m_options.progress)
                round.m_options.progress(what, passed, total);
        }
        [[nodiscard]] std::vector<Identity> remembered() const override
        {
            return round.m_session.rememberedOn(round.m_link, family);
        }
        [[nodiscard]] std::vector<Identity> known() const override
        {
            return round.m_session.knownOn(round.m_link, family);
        }
        [[nodiscard]] ScanExtent extent() const override { return round.m_options.extent; }
        ScanRound &round;
        const Family &family;
    };

    ScanRound(Session &session, Link &link, ScanOptions options)
        : m_session(session)
        , m_link(link)
        , m_options(std::move(options))
        , m_scope(session.m_clock)
    {
    }
    ScanRound(const ScanRound &) = delete;
    ScanRound &operator=(const ScanRound &) = delete;
    /// What was found is remembered, although the round was cut.
    ~ScanRound() { m_session.remember(m_link, seen, m_complete); }
    /// Nobody else answers.
    void setComplete() { m_complete = true; }
    void start()
    {
        for (const Family *family : m_session.m_families) {
            if (family->scan && speaks(*family))
                spawn(family->scan(m_link, m_session.clockOf(m_link), sinkOf(*family)));
        }
        if (m_running == 0)
            done.set();
    }
    /// Only this one, where its family can ask for one.
    void startFor(const DeviceSelector &selector)
    {
        const auto family = std::find_if(m_session.m_families.begin(), m_session.m_families.end(),
            [&selector](const Family *f) { return f->key == selector.family; });
        if (family != m_session.m_families.end() && (*family)->probe && speaks(**family))
            spawn((*family)->probe(m_link, m_session.clockOf(m_link), selector.address, sinkOf(**family)));
        else
            start();
    }

    std::vector<Device *> seen;
    std::optional<Error> error;
    Event done;

private:
    [[nodiscard]] bool speaks(const Family &family) const
    {
        return std::find(family.links.begin(), family.links.end(), m_link.kind()) != family.links.end();
    }
    [[nodiscard]] Sink &sinkOf(const Family &family)
    {
        m_sinks.push_back(std::make_unique<Sink>(*this, family));
        return *m_sinks.back();
    }
    void spawn(Task<void> task)
    {
        ++m_running;
        m_scope.spawn<void>(std::move(task), [this](Result<void> result) {
            if (!result)
                error = result.error();
            if (--m_running == 0)
                done.set();
        });
    }

    Session &m_session;
    Link &m_link;
    ScanOptions m_options;
    std::vector<std::unique_ptr<Sink>> m_sinks;
    int m_running = 0;
    bool m_complete = false;
    Scope m_scope;
};

Session::Session(Clock &clock, std::span<const Family *const> families, MotionGuard *guard)
    : m_clock(clock)
    , m_families(families)
    , m_guard(guard)
    , m_retry(clock)
    , m_commit(clock)
{
}

Session::~Session()
{
    for (Entry &entry : m_devices) { // a motor that another program drives is not ours to stop
        if (entry.stream && entry.stream->isRunning())
            entry.stream->stop();
    }
}

Result<Session::OpenLink> Session::makeLink(const LinkAddress &address)
{
    OpenLink made;
    if (address.isSimulated()) {
        auto bench = Bench::create(address, m_clock, m_families);
        if (!bench)
            return fail(bench.error());
        made.bench = std::move(*bench);
        made.link = made.bench->hostLink();
        return made;
    }
    auto link = createLink(address, m_clock);
    if (!link)
        return fail(link.error());
    made.link = std::move(*link);
    made.link->setBackground(m_background);
    return made;
}

Result<Link *> Session::openLink(const LinkAddress &address)
{
    if (Link *known = findLink(address)) {
        const bool wasOpen = known->state() == LinkState::Open;
        if (auto opened = known->open(); !opened)
            return fail(opened.error());
        if (!wasOpen)
            remark(*known);
        return known;
    }
    auto made = makeLink(address);
    if (!made)
        return fail(made.error());
    if (auto opened = made->link->open(); !opened)
        return fail(opened.error());
    return &enlist(std::move(*made));
}

Task<Link *> Session::openLinkSoon(LinkAddress address)
{
    if (Link *const known = findLink(address)) {
        const bool wasOpen = known->state() == LinkState::Open;
        auto opening = known->openSoon();
        co_await std::move(opening);
        if (!wasOpen)
            remark(*known);
        co_return known;
    }
    auto made = makeLink(address);
    if (!made)
        co_return fail(made.error());
    auto opening = made->link->openSoon();
    co_await std::move(opening);
    co_return &enlist(std::move(*made));
}

void Session::reopen(Link &link)
{
    for (OpenLink &open : m_links) {
        if (open.link.get() != &link || link.isOpening())
            continue;
        if (!open.opening)
            open.opening = std::make_unique<Scope>(m_clock);
        open.opening->spawn<void>(link.openSoon());
    }
}

/// Of an open link.
Link &Session::enlist(OpenLink made)
{
    m_links.push_back(std::move(made));
    OpenLink &open = m_links.back();
    Link &link = *open.link;
    payStops(open); // nothing was sent there yet
    open.state = link.stateChanged().add([this, &open](LinkState state) { linkChanged(open, state); });
    open.batch = link.batchEnded().add([this] { scheduleCommit(); });
    m_changed.notify();
    remark(link);
    return link;
}

void Session::remark(const Link &link)
{
    if (link.kind() != LinkKind::Serial)
        return;
    if (const Message &text = static_cast<const SerialLink &>(link).remark(); !text.empty())
        m_remarked.notify(link, text);
}

void Session::closeLink(Link &link)
{
    for (Entry &entry : m_devices) {
        if (&entry.device->link() != &link)
            continue;
        if (entry.stream)
            entry.stream->stop();
        passOnStop(entry);
    }
    std::erase_if(m_devices, [&link](const Entry &entry) { return &entry.device->link() == &link; });
    if (const OpenLink *open = openLinkOf(link); open && m_guard)
        m_guard->leave(open->line);
    std::erase_if(m_links, [&link](const OpenLink &open) { return open.link.get() == &link; });
    m_changed.notify();
}

std::vector<Link *> Session::links() const
{
    std::vector<Link *> all;
    for (const OpenLink &open : m_links)
        all.push_back(open.link.get());
    return all;
}

Link *Session::findLink(const LinkAddress &address) const
{
    const auto open
        = std::find_if(m_links.begin(), m_links.end(), [&](const OpenLink &o) { return o.link->address() == address; });
    return open == m_links.end() ? nullptr : open->link.get();
}

Bench *Session::bench(const Link &link) const
{
    const auto open
        = std::find_if(m_links.begin(), m_links.end(), [&](const OpenLink &o) { return o.link.get() == &link; });
    return open == m_links.end() ? nullptr : open->bench.get();
}

Task<std::vector<Device *>> Session::scan(Link &link, ScanOptions options)
{
    if (ReplayLink *const recording = replayOf(link)) {
        auto overhearing = overhear(*recording);
        co_return co_await std::move(overhearing);
    }
    ScanRound round(*this, link, std::move(options));
    round.start();
    co_await round.done.wait();
    if (round.error)
        co_return fail(*round.error);
    round.setComplete();
    const auto rank = [this](const Device *device) {
        const auto family = std::find(m_families.begin(), m_families.end(), &device->family());
        return std::pair(family - m_families.begin(), device->identity().address);
    };
    std::stable_sort(
        round.seen.begin(), round.seen.end(), [&rank](const Device *a, const Device *b) { return rank(a) < rank(b); });
    co_return round.seen;
}

Session::Entry &Session::addEntry(Link &link, const Family &family, const Identity &identity)
{
    Entry &entry = m_devices.emplace_back();
    entry.id = DeviceId{++m_lastId};
    openDevice(entry, link, family, identity);
    inheritStop(entry);
    m_changed.notify();
    return entry;
}

void Session::openDevice(Entry &entry, Link &link, const Family &family, const Identity &identity)
{
    entry.device = family.open(link, clockOf(link), identity);
    entry.device->guard().setSource(m_guard);
    entry.device->setStopGate(m_stopGate);
    if (m_store)
        entry.device->telemetry()->keepIn(m_store);
    recall(*entry.device);
    entry.changed = entry.device->changed().add([this] { m_changed.notify(); });
    entry.profileChanged = entry.device->profileChanged().add([this, device = entry.device.get()] { keep(*device); });
    entry.stopChanged = entry.device->stopping().changed().add([this, &entry] { followStop(entry); });
}

Device &Session::adopt(Link &link, const Family &family, const Identity &identity, std::vector<Device *> &seen)
{
    Entry *match = nullptr;
    for (Entry &entry : m_devices) {
        Device &device = *entry.device;
        if (&device.link() != &link || device.family().key != family.key
            || device.identity().address != identity.address)
            continue;
        if (device.identity().session == identity.session) {
            match = &entry;
            break;
        }
        // Another session under the same number is the same unit after a power cycle, unless both answered in this scan.
        if (!match && std::find(seen.begin(), seen.end(), &device) == seen.end())
            match = &entry;
    }
    if (!match) {
        match = &addEntry(link, family, identity);
    } else {
        match->device->setIdentity(merged(match->device->identity(), identity));
    }
    if (std::find(seen.begin(), seen.end(), match->device.get()) == seen.end())
        seen.push_back(match->device.get());
    return *match->device;
}

Task<std::vector<Device *>> Session::ask(Link &link, DeviceSelector selector)
{
    ScanRound round(*this, link, {});
    round.startFor(selector);
    co_await round.done.wait();
    if (round.error)
        co_return fail(*round.error);
    co_return round.seen;
}

Task<Device *> Session::connect(DeviceSelector selector)
{
    auto opening = openLinkSoon(selector.link);
    Link *const link = co_await std::move(opening);
    ReplayLink *const recording = replayOf(*link);
    auto looking = recording ? overhear(*recording) : ask(*link, selector);
    const std::vector<Device *> seen = co_await std::move(looking);
    std::vector<Device *> fitting;
    for (Device *device : seen) {
        const Identity &identity = device->identity();
        if (identity.family == selector.family && identity.address == selector.address
            && (!selector.session || identity.session == selector.session))
            fitting.push_back(device);
    }
    if (fitting.empty())
        co_return fail(Fault::Timeout,
            recording
                ? say("no %1 sends as number %2 in %3", selector.family, selector.address, selector.link.text())
                : say("no %1 answers as number %2 on %3", selector.family, selector.address, selector.link.text()),
            recording ? say("a scan of the recording lists who does") : Message());
    if (fitting.size() > 1)
        co_return fail(Fault::Refused, say("%1 units answer as number %2", fitting.size(), selector.address),
            say("name one: %1 or %2", fitting[0]->selector(), fitting[1]->selector()));
    co_return fitting.front();
}

std::vector<Device *> Session::devices() const
{
    std::vector<Device *> all;
    for (const Entry &entry : m_devices)
        all.push_back(entry.device.get());
    return all;
}

std::vector<Identity> Session::knownOn(const Link &link, const Family &family) const
{
    std::vector<Identity> known;
    for (const Entry &entry : m_devices) {
        if (&entry.device->link() == &link && &entry.device->family() == &family)
            known.push_back(entry.device->identity());
    }
    return known;
}

Device *Session::find(DeviceId id) const
{
    const auto entry = std::find_if(m_devices.begin(), m_devices.end(), [id](const Entry &e) { return e.id == id; });
    return entry == m_devices.end() ? nullptr : entry->device.get();
}

DeviceId Session::idOf(const Device &device) const
{
    const auto entry
        = std::find_if(m_devices.begin(), m_devices.end(), [&](const Entry &e) { return e.device.get() == &device; });
    return entry == m_devices.end() ? DeviceId{} : entry->id;
}

SetPointStream &Session::stream(Device &device)
{
    const auto entry
        = std::find_if(m_devices.begin(), m_devices.end(), [&](const Entry &e) { return e.device.get() == &device; });
    if (!entry->stream)
        entry->stream = std::make_unique<SetPointStream>(device, clockOf(device.link()));
    return *entry->stream;
}

void Session::scheduleCommit()
{
    if (m_commit.isActive())
        return;
    m_commit.startIn(commitPeriod, [this] {
        for (Entry &entry : m_devices)
            entry.device->telemetry()->commit();
    });
}

} // namespace mb
