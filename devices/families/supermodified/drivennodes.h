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

    /// A node that was driven is told to stop.
    void leaderStopped(int node);
    /// Tells nodes that they are to be stopped for that reason.
    [[nodiscard]] Listeners<> &followersTold() { return m_followersTold; }
    /// Whether that holds for this node; once.
    [[nodiscard]] bool takeFollowerStop(int node) { return m_followerStops.erase(node) > 0; }

    /// Whether the buffered moves of all nodes may begin together.
    [[nodiscard]] Result<void> mayRelease()
    {
        Result<void> allowed;
        m_releasing.notify(allowed);
        return allowed;
    }
    /// Whoever keeps one replaces a success by why it may not begin.
    [[nodiscard]] Listeners<Result<void> &> &releasing() { return m_releasing; }
    /// They have begun.
    [[nodiscard]] Listeners<> &released() { return m_released; }

private:
    const Roster &m_roster;
    std::set<int> m_driven;
    std::set<int> m_followerStops; ///< nodes that have not taken theirs
    Listeners<> m_followersTold;
    Listeners<Result<void> &> m_releasing;
    Listeners<> m_released;
};

} // namespace mb::supermodified
