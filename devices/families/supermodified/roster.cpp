// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/supermodified/roster.h"

#include <algorithm>

namespace mb::supermodified {
namespace {

std::string listOf(const std::vector<int> &nodes)
{
    std::string text;
    for (const int node : nodes)
        text += (text.empty() ? "" : ", ") + std::to_string(node);
    return text;
}

} // namespace

const Roster::Entry &Roster::entry(int node) const
{
    static const Entry unknown;
    const auto found = m_nodes.find(node);
    return found == m_nodes.end() ? unknown : found->second;
}

void Roster::note(int node, int baudrate)
{
    m_nodes[node].baudrate = baudrate;
    chooseHost();
}

void Roster::noteMask(int node, std::uint8_t inForce)
{
    Entry &known = m_nodes[node];
    known.mask = inForce;
    known.hidesMask = false;
    if (known.nextMask == inForce)
        known.nextMask.reset();
    chooseHost();
}

void Roster::noteUnreadMask(int node)
{
    Entry &known = m_nodes[node];
    known.hidesMask = !known.mask;
}

void Roster::noteNextMask(int node, std::uint8_t written)
{
    Entry &known = m_nodes[node];
    known.nextMask = written == known.mask ? std::nullopt : std::optional(written);
    chooseHost();
}

void Roster::noteNextId(int node, int written)
{
    m_nodes[node].nextId = written == node ? std::nullopt : std::optional(written);
    chooseHost();
}

void Roster::noteSetting(int node, Command command, std::optional<std::int64_t> raw)
{
    switch (command) {
    case Command::P: m_nodes[node].gainP = raw; break;
    case Command::ProfileVelocity: m_nodes[node].profileVelocity = raw; break;
    case Command::ProfileAcceleration: m_nodes[node].profileAcceleration = raw; break;
    default: break;
    }
}

void Roster::noteSent(int node, Command command, std::int64_t raw)
{
    const auto &gain = m_nodes[node].gainP;
    noteSetting(node, command, command == Command::P && gain ? std::optional(std::max(*gain, raw)) : std::nullopt);
}

bool Roster::isClaimed(int id, int node) const
{
    return std::ranges::any_of(m_nodes, [id, node](const auto &known) {
        return known.first != node && (known.first == id || known.second.nextId == id);
    });
}

std::optional<int> Roster::neighbourOf(int node) const
{
    const auto other = std::ranges::find_if(m_nodes, [node](const auto &known) { return known.first != node; });
    return other == m_nodes.end() ? std::nullopt : std::optional(other->first);
}

void Roster::forget(int node)
{
    m_nodes.erase(node);
    chooseHost();
}

/// Whether a node does what is sent to `address`, with any id and mask that it has or will have.
bool Roster::follows(int node, const Entry &known, int address)
{
    const auto fits = [address](int id, std::uint8_t mask) { return (address & mask) == (id & mask); };
    const std::uint8_t mask = known.mask.value_or(exactMask);
    for (const int id : {node, known.nextId.value_or(node)}) {
        if (fits(id, mask) || fits(id, known.nextMask.value_or(mask)))
            return true;
    }
    return false;
}

bool Roster::isFree(int host) const
{
    return std::ranges::none_of(
        m_nodes, [host](const auto &node) { return node.first == host || follows(node.first, node.second, host); });
}

void Roster::chooseHost()
{
    m_hostIsFree = true;
    if (isFree(m_hostId = usualHostId))
        return;
    for (m_hostId = highestNode; m_hostId >= lowestNode; --m_hostId) {
        if (isFree(m_hostId))
            return;
    }
    m_hostId = usualHostId;
    m_hostIsFree = false;
}

std::vector<int> Roster::followersOf(int node) const
{
    std::vector<int> followers;
    for (const auto &[other, known] : m_nodes) {
        if (other != node && follows(other, known, node))
            followers.push_back(other);
    }
    return followers;
}

Message Roster::lockOf(int node) const
{
    if (const auto followers = followersOf(node); !followers.empty())
        return say("what is sent to node %1 is also done by node %2, now or after a restart, because of an acceptance "
                   "mask; set its node.mask to 255 and restart it",
            node, listOf(followers));
    for (const auto &[other, known] : m_nodes) {
        if (other != node && known.hidesMask && known.baudrate == entry(node).baudrate) // else it hears no frame
            return say(
                "the acceptance mask of node %1 is not known, so it may do what is sent to node %2, too; set its "
                "error.level to 0 where it is 1, then scan again",
                other, node);
    }
    if (!m_hostIsFree)
        return say("every id that this program could use on the line belongs to the group of a node, so answers would "
                   "be taken for commands; set node.mask to 255 and restart the nodes");
    return {};
}

} // namespace mb::supermodified
