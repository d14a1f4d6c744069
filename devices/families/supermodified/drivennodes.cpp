// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/supermodified/drivennodes.h"

#include "families/supermodified/roster.h"

namespace mb::supermodified {

void DrivenNodes::set(int node, bool driven)
{
    if (driven)
        m_driven.insert(node);
    else
        m_driven.erase(node);
}

void DrivenNodes::leaderStopped(int node)
{
    for (const int follower : m_roster.followersOf(node))
        m_followerStops.insert(follower);
    if (!m_followerStops.empty())
        m_followersTold.notify();
}

} // namespace mb::supermodified
