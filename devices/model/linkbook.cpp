// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/linkbook.h"

#include "transport/linkcatalog.h"
#include "transport/seriallink.h"

#include <algorithm>
#include <utility>

namespace mb {

LinkBook::LinkBook(Clock &clock, std::span<const Family *const> families)
    : m_clock(clock)
    , m_families(families)
{
}

Result<LinkBook::Entry> LinkBook::make(const LinkAddress &address)
{
    Entry made;
    if (address.isSimulated()) {
        MB_TRY(auto bench, Bench::create(address, m_clock, m_families));
        made.bench = std::move(bench);
        made.link = made.bench->hostLink();
        return made;
    }
    MB_TRY(auto link, createLink(address, m_clock));
    made.link = std::move(link);
    made.link->settings().background = m_background;
    if (m_identify)
        made.link->settings().identify = m_identify;
    return made;
}

Result<Link *> LinkBook::open(const LinkAddress &address)
{
    if (Link *known = find(address)) {
        const bool wasOpen = known->state() == LinkState::Open;
        MB_TRY_VOID(known->open());
        if (!wasOpen)
            remark(*known);
        return known;
    }
    MB_TRY(auto made, make(address));
    MB_TRY_VOID(made.link->open());
    return &enlist(std::move(made));
}

Task<Link *> LinkBook::openSoon(LinkAddress address)
{
    const Turns::Turn turn = co_await m_turns.try_emplace(address.text(), m_clock).first->second.take();
    if (Link *const known = find(address)) {
        const bool wasOpen = known->state() == LinkState::Open;
        co_await known->openSoon();
        if (!wasOpen)
            remark(*known);
        co_return known;
    }
    auto made = co_await make(address);
    co_await made.link->openSoon();
    if (Link *const known = find(address)) // somebody else has opened it meanwhile
        co_return known;
    co_return &enlist(std::move(made));
}

void LinkBook::reopen(Link &link)
{
    for (Entry &open : m_links) {
        if (open.link.get() != &link || link.isOpening())
            continue;
        if (!open.opening)
            open.opening = std::make_unique<Scope>(m_clock);
        open.opening->spawn<void>(link.openSoon());
    }
}

/// Of an open link. Who follows its state here hears of a change before all who listen for themselves: they begin to ask at once.
Link &LinkBook::enlist(Entry made)
{
    m_links.push_back(std::move(made));
    Entry &entry = m_links.back();
    Link &link = *entry.link;
    m_opened.notify(link);
    entry.state = link.stateChanged().add([this, &entry](LinkState state) {
        if (state == LinkState::Open)
            m_opened.notify(*entry.link);
        else if (state == LinkState::Lost)
            m_lost.notify(*entry.link);
        m_changed.notify();
    });
    entry.batch = link.batchEnded().add([this] { m_batchEnded.notify(); });
    m_changed.notify();
    remark(link);
    return link;
}

void LinkBook::remark(const Link &link)
{
    if (link.kind() != LinkKind::Serial)
        return;
    if (const Message &text = static_cast<const SerialLink &>(link).remark(); !text.empty())
        m_remarked.notify(link, text);
}

void LinkBook::remark(const Link &link, const Message &text)
{
    const auto entry = std::ranges::find(m_links, &link, [](const Entry &each) { return each.link.get(); });
    if (entry != m_links.end() && std::exchange(entry->remark, text) != text)
        m_remarked.notify(link, text);
}

void LinkBook::close(Link &link)
{
    link.close(); // whoever knows it by its place in memory hears that it has gone
    std::erase_if(m_links, [&link](const Entry &entry) { return entry.link.get() == &link; });
    m_changed.notify();
}

std::vector<Link *> LinkBook::all() const
{
    std::vector<Link *> all;
    for (const Entry &open : m_links)
        all.push_back(open.link.get());
    return all;
}

Link *LinkBook::find(const LinkAddress &address) const
{
    const auto open = std::ranges::find_if(m_links, [&](const Entry &o) { return o.link->address() == address; });
    return open == m_links.end() ? nullptr : open->link.get();
}

Bench *LinkBook::bench(const Link &link) const
{
    const Entry *const entry = entryOf(link);
    return entry ? entry->bench.get() : nullptr;
}

Clock &LinkBook::clockOf(Link &link) const
{
    if (ReplayLink *const recording = replayOf(link))
        return recording->timeLine();
    Bench *const simulated = bench(link);
    return simulated ? simulated->clock() : m_clock;
}

const LinkBook::Entry *LinkBook::entryOf(const Link &link) const
{
    const auto entry = std::ranges::find_if(m_links, [&](const Entry &e) { return e.link.get() == &link; });
    return entry == m_links.end() ? nullptr : &*entry;
}

ReplayLink *replayOf(Link &link)
{
    return link.address().isRecording() ? dynamic_cast<ReplayLink *>(&link) : nullptr;
}

} // namespace mb
