// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "transport/priority.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>
#include <vector>

namespace mb {

/// Pieces that wait for a serial line, as SerialLink::send() promises.
class SerialQueue {
public:
    using Piece = std::vector<std::uint8_t>;

    /// Yields how many bytes of normal pieces were dropped for an urgent one.
    std::size_t push(std::span<const std::uint8_t> bytes, Priority priority)
    {
        const bool urgent = priority == Priority::Urgent;
        const std::size_t before = size();
        if (urgent)
            keepUrgent();
        const std::size_t dropped = before - size();
        m_waiting.push_back({{bytes.begin(), bytes.end()}, urgent});
        return dropped;
    }
    /// Not of an empty queue.
    [[nodiscard]] Piece pop()
    {
        Piece piece = std::move(m_waiting.front().bytes);
        m_waiting.pop_front();
        return piece;
    }
    void keepUrgent()
    {
        std::erase_if(m_waiting, [](const Waiting &waiting) { return !waiting.urgent; });
    }
    void clear() { m_waiting.clear(); }
    [[nodiscard]] bool isEmpty() const { return m_waiting.empty(); }
    /// In bytes.
    [[nodiscard]] std::size_t size() const
    {
        std::size_t bytes = 0;
        for (const Waiting &waiting : m_waiting)
            bytes += waiting.bytes.size();
        return bytes;
    }

private:
    struct Waiting {
        Piece bytes;
        bool urgent = false;
    };
    std::deque<Waiting> m_waiting;
};

} // namespace mb
