// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/supermodified/node.h"

#include <functional>

namespace mb::supermodified {

/// Stops a node that does what was sent to another one, when that is told to stop; also one that was found only afterwards.
class FollowerStop {
public:
    /// `stop` is called as often as that happens, first from the clock. Line and node outlive it.
    FollowerStop(Line &line, const Node &node, std::function<void()> stop)
        : m_line(line)
        , m_node(node)
        , m_stop(std::move(stop))
        , m_first(line.clock())
        , m_told(line.driven().followersTold().add([this] { look(); }))
    {
        m_first.startIn(Duration::zero(), [this] { look(); }); // once somebody follows its stops up
    }

private:
    void look()
    {
        if (m_line.driven().takeFollowerStop(m_node.id))
            m_stop();
    }

    Line &m_line;
    const Node &m_node;
    std::function<void()> m_stop;
    Timer m_first;
    Subscription m_told;
};

} // namespace mb::supermodified
