// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/supermodified/node.h"

#include <functional>

namespace mb::supermodified {

/// Stops one node and goes on until it has acknowledged that, because a node with an error in its queue refuses the first one
/// (README.md#refused-stop); across a lost link, too.
class MotionStop {
public:
    struct Events {
        std::function<void()> acknowledged;
        CodeSink codes; ///< error codes instead of an answer
    };

    /// Line and node outlive it.
    MotionStop(Line &line, const Node &node, Events events);

    void begin();
    /// The link is open again.
    void resume();
    [[nodiscard]] bool isPending() const { return m_pending; }
    /// When the last one was acknowledged.
    [[nodiscard]] std::optional<Instant> acknowledgedAt() const { return m_acknowledgedAt; }

private:
    void send(Duration delay);
    void answered(const Result<Frame> &reply);

    Line &m_line;
    const Node &m_node;
    Events m_events;
    bool m_pending = false;
    int m_tries = 0;
    std::optional<Instant> m_acknowledgedAt;
    Line::Ticket m_ticket;
    Timer m_timer;
};

} // namespace mb::supermodified
