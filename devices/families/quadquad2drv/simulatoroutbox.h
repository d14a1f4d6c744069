// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

namespace mb::quadquad2drv::simulation {

/// The packets that wait in a simulated board until somebody clocks them out.
class Outbox {
public:
    /// Dropped when too many wait.
    void push(std::vector<std::uint8_t> packet);
    /// The next byte; 0 when nothing waits.
    [[nodiscard]] std::uint8_t next();
    void clear();
    [[nodiscard]] bool isEmpty() const { return m_packets.empty(); }
    /// A stream packet waits, or was not clocked out to its end.
    [[nodiscard]] bool hasStream() const { return m_streamWaits; }

private:
    std::deque<std::vector<std::uint8_t>> m_packets;
    std::size_t m_at = 0; ///< of the packet that is being clocked out
    bool m_streamWaits = false;
};

} // namespace mb::quadquad2drv::simulation
