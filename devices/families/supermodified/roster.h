// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/message.h"
#include "families/supermodified/protocol.h"

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace mb::supermodified {

/// What is known of the nodes of one line, for as long as its link lives: whoever asks or writes notes what it learns, and
/// everybody acts on it at once. Chooses the host's own id, which must be in no group of nodes (README.md#masks).
class Roster {
public:
    struct Entry {
        int baudrate = 0;
        std::optional<std::uint8_t> mask;     ///< in force, once it was read
        bool hidesMask = false;               ///< it was asked for its mask in vain
        std::optional<std::uint8_t> nextMask; ///< written, and in force after a restart
        std::optional<int> nextId;            ///< the same
        std::optional<std::int64_t> gainP;    ///< this and the next two bound what may be commanded
        std::optional<std::int64_t> profileVelocity;
        std::optional<std::int64_t> profileAcceleration;
    };
    [[nodiscard]] const std::map<int, Entry> &nodes() const { return m_nodes; }
    /// Of a node that nobody has noted: as if it had just left the factory.
    [[nodiscard]] const Entry &entry(int node) const;

    /// Somebody answered under this id.
    void note(int node, int baudrate);
    void noteMask(int node, std::uint8_t inForce);
    /// It was to be read, and was not: where it never was, nobody knows whose orders the node does.
    void noteUnreadMask(int node);
    void noteNextMask(int node, std::uint8_t written);
    void noteNextId(int node, int written);
    /// P, and velocity and acceleration of a profile, once acknowledged. What other commands set is not kept.
    void noteSetting(int node, Command command, std::optional<std::int64_t> raw);
    /// It is sent and not acknowledged: of P the greater one bounds, for either may be in force, what else is kept is not known.
    void noteSent(int node, Command command, std::int64_t raw);
    /// Another node than `node` has this id, or will have it after a restart.
    [[nodiscard]] bool isClaimed(int id, int node) const;
    /// Any other node.
    [[nodiscard]] std::optional<int> neighbourOf(int node) const;
    /// It is not there.
    void forget(int node);

    /// In no group, now or after a restart of the nodes, where there is such an id.
    [[nodiscard]] int hostId() const { return m_hostId; }
    /// Other nodes that act on what is sent to `node`, or will after a restart.
    [[nodiscard]] std::vector<int> followersOf(int node) const;
    /// Why nothing may be moved on this line through `node`, with the remedy; empty when nothing stands against it.
    [[nodiscard]] Message lockOf(int node) const;

private:
    [[nodiscard]] static bool follows(int node, const Entry &known, int address);
    [[nodiscard]] bool isFree(int host) const;
    void chooseHost();

    std::map<int, Entry> m_nodes;
    int m_hostId = usualHostId;
    bool m_hostIsFree = true;
};

} // namespace mb::supermodified
