// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/listeners.h"
#include "async/result.h"

#include <set>

namespace mb::supermodified {

class Roster;

/// The nodes of one line whose motors are driven, and those that follow one that was told to stop: they may turn as well, and
/// hear of the stop to its address only if nothing is lost, so that each is told by its own, now or when it is found.
class DrivenNodes {
public:
    /// The roster outlives it.
    explicit DrivenNodes(const Roster &roster)
        : m_roster(roster)
    {
    }

    void set(int node, bool driven);
    [[nodiscard]] bool any() const { return !m_driven.empty(); }
    [[nodiscard]] bool has(int node) const { return m_driven.contains(node); }

    /// A node that was driven is told to stop.
    void leaderStopped(int node);
    /// Tells nodes that they are to be stopped for that reason.
    [[nodiscard]] Listeners<> &followersTold() { return m_followersTold; }
    /// Whether that holds for this node; once.
    [[nodiscard]] bool takeFollowerStop(int node) { return m_followerStops.erase(node) > 0; }

    /// The buffered moves of all nodes of a line begin with one command, so each node is asked before it and told once it was sent.
    struct Release {
        bool isBegun = false;
        Result<void> allowed{}; ///< whoever keeps one replaces a success by why it may not begin
    };
    [[nodiscard]] Listeners<Release &> &releasing() { return m_releasing; }
    [[nodiscard]] Result<void> mayRelease()
    {
        Release asked;
        m_releasing.notify(asked);
        return asked.allowed;
    }
    void released()
    {
        Release told{true};
        m_releasing.notify(told);
    }

private:
    const Roster &m_roster;
    std::set<int> m_driven;
    std::set<int> m_followerStops; ///< nodes that have not taken theirs
    Listeners<> m_followersTold;
    Listeners<Release &> m_releasing;
};

} // namespace mb::supermodified
