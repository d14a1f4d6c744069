// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/listeners.h"
#include "async/noncopyable.h"
#include "async/scope.h"
#include "async/turns.h"
#include "model/bench.h"
#include "model/family.h"
#include "transport/backends/replay.h"
#include "transport/link.h"

#include <list>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace mb {

/// The links of a session, with the benches behind simulated ones. Thread of the session.
class LinkBook : NonCopyable {
public:
    LinkBook(Clock &clock, std::span<const Family *const> families);

    /// What may block is done there, of links made from now on. Outlives this.
    void setBackground(Background *background) { m_background = background; }
    using Identify = decltype(LinkSettings::identify);
    /// Of links made from now on; for tests.
    void setIdentify(Identify identify) { m_identify = std::move(identify); }
    /// Opens a link, or yields the one that is open under this address.
    [[nodiscard]] Result<Link *> open(const LinkAddress &address);
    /// open() for a thread that must not wait for a driver (Link::openSoon). Who asks for one that is being opened waits for what comes of it.
    [[nodiscard]] Task<Link *> openSoon(LinkAddress address);
    /// The same for a lost link that may be back; its state tells what comes of it.
    void reopen(Link &link);
    void close(Link &link);

    [[nodiscard]] std::vector<Link *> all() const;
    [[nodiscard]] Link *find(const LinkAddress &address) const;
    /// The bench behind a simulated link; nullptr for others.
    [[nodiscard]] Bench *bench(const Link &link) const;
    /// The time that devices of a link live on: the session's, but for a recording and for a simulated bench its own.
    [[nodiscard]] Clock &clockOf(Link &link) const;

    /// A link is open, for the first time or again, and nothing was sent there yet.
    [[nodiscard]] Listeners<Link &> &opened() { return m_opened; }
    /// A link is lost.
    [[nodiscard]] Listeners<Link &> &lost() { return m_lost; }
    /// A batch of what a link has received was handed out.
    [[nodiscard]] Listeners<> &batchEnded() { return m_batchEnded; }
    /// Its user should know something about a link, told in one clause.
    void remark(const Link &link, const Message &text);
    /// A link was opened, or scanned, and its user should know something about it; the same is not told twice on end.
    [[nodiscard]] Listeners<const Link &, const Message &> &remarked() { return m_remarked; }
    /// Links came, went or changed.
    [[nodiscard]] Listeners<> &changed() { return m_changed; }

private:
    struct Entry {
        std::unique_ptr<Bench> bench;
        std::unique_ptr<Link> link;
        Subscription state;
        Subscription batch;
        std::unique_ptr<Scope> opening; ///< again
        Message remark;                 ///< the last
    };
    [[nodiscard]] Result<Entry> make(const LinkAddress &address);
    Link &enlist(Entry made);
    void remark(const Link &link);
    [[nodiscard]] const Entry *entryOf(const Link &link) const;

    Clock &m_clock;
    std::span<const Family *const> m_families;
    Background *m_background = nullptr;
    Identify m_identify;
    std::map<std::string, Turns> m_turns; ///< of opening, by address: a port that is open is in use
    Listeners<Link &> m_opened;
    Listeners<Link &> m_lost;
    Listeners<> m_batchEnded;
    Listeners<const Link &, const Message &> m_remarked;
    Listeners<> m_changed;
    std::list<Entry> m_links; // an element is destroyed whole, in the reverse order of its members
};

/// The replay behind a `replay:` link; nullptr for others.
[[nodiscard]] ReplayLink *replayOf(Link &link);

} // namespace mb
