// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/engine/recordings.h"
#include "widgets/orders/linkorders.h"

#include <functional>
#include <map>
#include <memory>

namespace mb {

/// Looking for devices on links: when somebody asks for it, and again and again on CAN while nothing else goes on. Engine thread.
class Scans {
public:
    Scans(const EngineContext &context, Recordings &recordings);
    /// Ends all scans; what they have found stays.
    ~Scans();

    /// Nothing where firmware is written to a unit, or units are served.
    void scan(Link &link, ScanExtent extent = ScanExtent::Quick);
    /// Once a second: every open CAN link, and others whose look was cut or where one is heard that was taken for mute, when the last
    /// look is some time ago and nothing runs or moves.
    void look();
    /// Something else needs the link for itself; a search that somebody asked for is said to be over.
    void giveWay(const Link &link);
    /// A link is about to go.
    void forget(const Link &link) { m_rounds.erase(&link); }
    /// Its part of what is shown of a link.
    void describe(const Link &link, LinkView &view) const;

    void carryOut(const orders::ScanLinks &order, const Finished &finished);
    void carryOut(const orders::ScanEverything &order, const Finished &finished);
    void carryOut(const orders::CancelScan &order, const Finished &finished);
    void carryOut(const orders::FindMute &order, const std::function<void(Result<DeviceId>)> &finished);

private:
    struct Round {
        bool running = false;
        bool isAsked = false; ///< by somebody, who waits for what it finds
        bool isDue = false;   ///< a look, where none is made without a reason: one was ended for what somebody asked
        Message step;
        int done = 0;
        int total = 0;
        std::unique_ptr<Scope> task; ///< last: uses everything above
    };

    void ended(Link &link, const Result<std::vector<Device *>> &devices);
    static void end(Round &round);
    void probeSilent(Link &link);
    [[nodiscard]] bool isQuiet() const;
    [[nodiscard]] bool isTaken(const Link &link) const;
    [[nodiscard]] Link *linkUnder(const std::string &address) const;
    [[nodiscard]] Result<Link *> freeLink(const std::string &address) const;

    EngineContext m_context;
    Recordings &m_recordings;
    Instant m_last{};
    std::map<const Link *, Round> m_rounds;
};

} // namespace mb
