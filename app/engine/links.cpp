// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/engine/links.h"

#include "model/framepermit.h"
#include "transport/canlink.h"

#include <algorithm>

namespace mb {

Links::Links(const EngineContext &context, Motion &motion, Recordings &recordings, Scans &scans, bool opensByItself)
    : m_context(context)
    , m_motion(motion)
    , m_recordings(recordings)
    , m_scans(scans)
    , m_opensByItself(opensByItself)
    , m_returned(context.clock)
{
}

Links::~Links()
{
    m_openings.clear();
}

void Links::carryOut(const orders::OpenLink &order, const Finished &finished)
{
    const std::string text = order.address.text();
    m_openings[text].finished.push_back(finished);
    open(text, expandLink(order.address, m_context.session.families()));
}

void Links::open(const std::string &name, std::vector<LinkAddress> addresses)
{
    Opening &opening = m_openings[name];
    if (opening.scope)
        return; // it is under way
    opening.scope = std::make_unique<Scope>(m_context.clock);
    opening.scope->spawn<void>(
        openAll(name, std::move(addresses)), [this, name](const Result<void> &result) { end(name, result); });
}

void Links::end(const std::string &address, const Result<void> &result)
{
    const auto opening = m_openings.extract(address); // first: who is answered may ask for it again
    if (!opening)
        return;
    for (const Finished &finished : opening.mapped().finished)
        finished(result);
}

/// Somebody may ask for it meanwhile.
Task<void> Links::openAll(std::string name, std::vector<LinkAddress> addresses)
{
    for (const LinkAddress &one : addresses) {
        const Result<Link *> link = co_await m_context.session.openLinkSoon(one).attempt();
        const bool isAsked = !m_openings[name].finished.empty();
        if (isAsked)
            m_closedByHand.erase(one.text());
        if (!link) {
            if (isAsked)
                couldNotOpen(one, link.error());
            co_return fail(link.error());
        }
        opened(**link, isAsked);
        m_scans.scan(**link);
    }
    co_return {};
}

void Links::couldNotOpen(const LinkAddress &address, const Error &error)
{
    m_context.log.tell(Severity::Danger, address.shortName(), error.message());
    m_awaited.add(address);
    m_failed[address.text()] = diagnose(error);
}

void Links::opened(Link &link, bool isAsked)
{
    const LinkAddress address = link.address();
    const bool wasMissing = m_failed.erase(address.text()) > 0;
    m_awaited.forget(address.text());
    const bool isNew = m_open.count(&link) == 0;
    follow(link);
    if (isNew || isAsked)
        m_open[&link].byItself = !isAsked && !wasMissing;
    if (wasMissing && !isAsked)
        m_context.log.tell(Severity::Good, address.shortName(), say("is there"));
}

Result<void> Links::mayClose(const Link &link) const
{
    if (m_context.operations.isLent(link))
        return fail(Fault::Unsafe, say("units are served here; the link stays open"), say("end that first"));
    if (m_context.operations.runsOn(link, OperationKind::UpdateFirmware))
        return fail(Fault::Unsafe, say("firmware is written to a unit here; the link stays open"),
            say("wait until it is done, or cancel it"));
    if (link.state() == LinkState::Open
        && m_context.operations.runsOn(link, OperationKind::Trial)) // it puts back what it changed
        return fail(Fault::Unsafe, say("an experiment on it has not ended"), say("wait until it has, or stop it"));
    return {};
}

void Links::carryOut(const orders::CloseLink &order, const Finished &finished)
{
    m_awaited.forget(order.link);
    m_failed.erase(order.link);
    end(order.link, fail(Fault::Cancelled, say("%1 was closed before it was open", order.link)));
    const auto parsed = LinkAddress::parse(order.link);
    if (Link *link = parsed ? m_context.session.linkBook().find(*parsed) : nullptr) {
        if (const Result<void> may = mayClose(*link); !may) {
            m_context.log.tell(Severity::Caution, link->address().shortName(), may.error().message());
            return finished(may);
        }
        m_closedByHand.insert(order.link);
        remove(*link);
    }
    finished({});
}

void Links::remove(Link &link)
{
    m_motion.forget(link);
    m_context.operations.forget(link);
    m_scans.forget(link); // after what ends with a scan, such as an update
    m_recordings.forget(link);
    m_open.erase(&link);
    m_context.session.closeLink(link);
}

void Links::follow(Link &link)
{
    auto [entry, isNew] = m_open.try_emplace(&link);
    if (!isNew)
        return;
    m_recordings.follow(link);
    entry->second.state = link.stateChanged().add([this, &link](LinkState state) { stateChanged(link, state); });
}

void Links::stateChanged(Link &link, LinkState state)
{
    if (state == LinkState::Lost) {
        m_open[&link].wasLost = true;
        m_context.log.tell(Severity::Danger, link.address().shortName(), link.loss().message());
    } else if (state == LinkState::Open) { // whoever opened it; first all who listen have their turn
        m_returned.startIn(Duration::zero(), [this] { welcomeReturned(); });
    }
}

void Links::look()
{
    reopenLost();
    m_awaited.look([this](const LinkAddress &address) { open(address.text(), {address}); }); // it may not be ready yet
}

void Links::reopenLost()
{
    for (Link *link : m_context.session.links()) {
        if (link->state() == LinkState::Lost && !link->address().isRecording() && !replace(*link))
            m_context.session.linkBook().reopen(*link);
    }
}

/// Its adapter has another name now, under which it is open.
bool Links::isRenamed(const Link &link) const
{
    const std::vector<Link *> all = m_context.session.links();
    return !link.line().empty() && std::ranges::any_of(all, [&link](const Link *other) {
        return other->state() == LinkState::Open && !other->address().isSimulated() && other->line() == link.line();
    });
}

/// Another adapter has its name, or its adapter has another name: who was found on it is gone, and who is there now is looked for.
bool Links::replace(Link &link)
{
    if (link.isOpening() || !mayClose(link))
        return false;
    const LinkAddress address = link.address();
    if (isRenamed(link)) {
        m_context.log.tell(Severity::Caution, address.shortName(),
            say("its adapter has another name now; what was found under this one is not in the list any more"));
        remove(link);
        return true;
    }
    if (!isReplaced(link))
        return false;
    const bool byItself = m_open[&link].byItself;
    m_context.log.tell(Severity::Caution, address.shortName(),
        say("another adapter has this name now; what was found on the one before is not in the list any more"));
    remove(link);
    if (byItself)
        openByItself();
    else
        carryOut(orders::OpenLink{address}, [](const Result<void> &) {}); // its user asked for it
    return true;
}

void Links::welcomeReturned()
{
    for (Link *link : m_context.session.links()) {
        const auto open = m_open.find(link);
        if (open == m_open.end() || !open->second.wasLost || link->state() != LinkState::Open)
            continue;
        open->second.wasLost = false;
        m_failed.erase(link->address().text()); // an attempt by hand, while it was away
        m_context.log.tell(Severity::Good, link->address().shortName(), say("is back"));
        if (!m_context.operations.hasOn(*link)) // an update that waited for it must be alone with its unit
            m_scans.scan(*link);
    }
}

void Links::takeListings(std::vector<LinkListing> listings)
{
    m_listings = std::move(listings);
    if (m_opensByItself)
        openByItself();
    reopenLost();
    dropVanished();
}

void Links::dropVanished()
{
    for (Link *link : m_context.session.links()) {
        const auto open = m_open.find(link);
        if (link->state() != LinkState::Lost || open == m_open.end() || !open->second.byItself)
            continue;
        const bool listed = std::ranges::any_of(
            m_listings, [link](const LinkListing &listing) { return listing.link == link->address(); });
        const auto devices = m_context.session.devices();
        const bool used
            = std::ranges::any_of(devices, [link](const Device *device) { return &device->link() == link; });
        if (!listed && !used && !link->isOpening() && mayClose(*link))
            remove(*link);
    }
}

void Links::openByItself()
{
    for (const LinkListing &listing : m_listings) {
        if (listing.link.scheme == "socketcan" && listing.openable && !m_context.session.linkBook().find(listing.link)
            && m_closedByHand.count(listing.link.text()) == 0)
            open(listing.link.text(), {listing.link});
    }
}

void Links::describe(Snapshot &shot) const
{
    for (Link *link : m_context.session.links()) {
        LinkView view = viewOf(*link, m_context.session.clockOf(*link));
        m_scans.describe(*link, view);
        m_recordings.describe(*link, view);
        view.diagnosis = diagnose(symptomsOf(*link, shot.time), shot.time, m_listings);
        shot.links.push_back(std::move(view));
    }
    for (const auto &[address, diagnosis] : m_failed)
        shot.failed.push_back({address, diagnosis});
}

void Links::carryOut(const orders::SendFrame &order, const Finished &finished)
{
    Session &session = m_context.session;
    for (Link *open : session.links()) {
        if (open->address().text() != order.link || open->kind() != LinkKind::Can)
            continue;
        if (m_context.operations.isLent(*open))
            return finished(fail(Fault::Unsafe, say("units are served on this link")));
        Snapshot shot;
        shot.links.push_back(viewOf(*open, session.clockOf(*open)));
        for (Device *device : session.devices())
            shot.devices.push_back(viewOf(session, *device));
        const FramePermit permit = permitFor(order.frame, order.link, shot, session.families(),
            [&order](DeviceId device) { return order.armed == device; });
        return finished(permit.refusal ? fail(*permit.refusal) : static_cast<CanLink *>(open)->send(order.frame));
    }
    finished(fail(Fault::LinkLost, say("the link is not open")));
}

} // namespace mb
