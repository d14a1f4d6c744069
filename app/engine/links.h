// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/engine/awaitedports.h"
#include "app/engine/scans.h"
#include "transport/linkcatalog.h"

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace mb {

/// Links: opened and closed, and those that come and go by themselves. Engine thread.
class Links {
public:
    /// `opensByItself`: also opens CAN interfaces that are up, as they come (docs/names.md#links).
    Links(const EngineContext &context, Motion &motion, Recordings &recordings, Scans &scans, bool opensByItself);
    /// Whoever waits for a link is answered.
    ~Links();

    /// What is there to be opened, whenever it may have changed: interfaces that are up are opened if that is wanted, lost
    /// links whose interface is back too; one that opened by itself, and found nobody, goes with its interface.
    void takeListings(std::vector<LinkListing> listings);
    [[nodiscard]] const std::vector<LinkListing> &listings() const { return m_listings; }
    /// Once a second: lost links and ports that were asked for are opened when they are there.
    void look();
    /// All that are open, with what is shown of each, and those that could not be opened.
    void describe(Snapshot &shot) const;

    void carryOut(const orders::OpenLink &order, const Finished &finished);
    void carryOut(const orders::CloseLink &order, const Finished &finished);
    void carryOut(const orders::SendFrame &order, const Finished &finished);

private:
    /// A link that is being opened, and who waits for it; nobody where it opens by itself.
    struct Opening {
        std::vector<Finished> finished;
        std::unique_ptr<Scope> scope;
    };
    struct Open {
        bool byItself = false; ///< nobody asked for it
        bool wasLost = false;  ///< and its return was not told yet
        Subscription state;
    };

    void open(const std::string &name, std::vector<LinkAddress> addresses);
    void end(const std::string &address, const Result<void> &result);
    [[nodiscard]] Task<void> openAll(std::string name, std::vector<LinkAddress> addresses);
    [[nodiscard]] Result<void> mayClose(const Link &link) const;
    void couldNotOpen(const LinkAddress &address, const Error &error);
    void opened(Link &link, bool isAsked);
    void openByItself();
    void follow(Link &link);
    void stateChanged(Link &link, LinkState state);
    void reopenLost();
    [[nodiscard]] bool isRenamed(const Link &link) const;
    [[nodiscard]] bool replace(Link &link);
    void welcomeReturned();
    void dropVanished();
    void remove(Link &link);

    EngineContext m_context;
    Motion &m_motion;
    Recordings &m_recordings;
    Scans &m_scans;
    bool m_opensByItself;
    std::vector<LinkListing> m_listings;
    std::map<const Link *, Open> m_open;
    std::map<std::string, Diagnosis> m_failed; ///< by address, until it opens or is closed
    std::set<std::string> m_closedByHand;      ///< not opened again by themselves
    AwaitedPorts m_awaited;
    Timer m_returned;
    std::map<std::string, Opening> m_openings; ///< by address; last: their tasks use everything above
};

} // namespace mb
