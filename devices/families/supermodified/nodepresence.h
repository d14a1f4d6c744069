// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/supermodified/node.h"

#include <cstdint>
#include <functional>
#include <optional>

namespace mb::supermodified {

/// Whether a node is there, whether it has lost its supply meanwhile, and whether somebody else commands it: follows from its
/// answers, and from those that do not come. Engine thread.
class NodePresence {
public:
    struct Owner {
        std::function<void()> commanded; ///< somebody else has sent it a command, or stopped it while it is driven
        std::function<void()> changed;   ///< hasForeignMaster() is another
    };

    /// Line and node outlive it.
    NodePresence(Line &line, const Node &node, Owner owner);

    [[nodiscard]] bool isHeard() const { return m_heard; }
    /// True when it was heard before.
    bool setHeard(bool heard);
    /// It did not answer; true once it has been silent for long enough.
    [[nodiscard]] bool missed() { return ++m_misses >= missesOfSilence; }
    /// It answered; true when answers before that were missed.
    [[nodiscard]] bool answered();
    /// The position that it told. Counts that are gone after a silence are those of a node that has lost its supply, or of one that was
    /// told to go there: where `isAsked`, its answer to a move tells which.
    void located(std::int64_t raw, bool isAsked);
    /// It counts from 0 anew, for all that this position tells: it is nearer to 0 than to the one before, and farther from that than a motor gets
    /// from one answer to the next. A restart between two questions shows by nothing else.
    [[nodiscard]] bool hasJumped(std::int64_t raw) const;
    /// It says that its motor is not started.
    void notStarted();
    /// It took a move.
    void moved();
    /// It counts from 0 by our order.
    void zeroed() { m_position = m_step = 0; }
    [[nodiscard]] bool hasRestarted() const { return m_supply == Supply::Lost; }
    /// What a restart took was read again.
    void refreshed() { m_supply = Supply::Kept; }
    [[nodiscard]] bool hasForeignMaster() const { return m_foreign.isActive(); }

private:
    static constexpr int missesOfSilence = 3;
    enum class Supply { Kept, Doubted, Lost };

    void observe(const Frame &frame);

    Line &m_line;
    const Node &m_node;
    Owner m_owner;
    bool m_heard = false;
    Supply m_supply = Supply::Kept;
    int m_misses = 0;
    bool m_missed = false;                  ///< the answer before the last one did not come
    std::optional<std::int64_t> m_position; ///< of the node
    std::int64_t m_step = 0;                ///< from the position before that
    Timer m_foreign;
    Subscription m_unsolicited;
};

} // namespace mb::supermodified
