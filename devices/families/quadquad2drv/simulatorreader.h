// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"

#include <cstdint>
#include <deque>
#include <functional>
#include <vector>

namespace mb::quadquad2drv::simulation {

/// Finds requests in the bytes that a simulated board hears; each is carried out a while after it has come.
class RequestReader {
public:
    using Packet = std::vector<std::uint8_t>;

    RequestReader(Clock &clock, std::function<void(const Packet &)> execute);

    void take(std::uint8_t byte);
    /// The board is reset.
    void clear();

private:
    void understand();
    void answer();

    std::function<void(const Packet &)> m_execute;
    Packet m_in;
    std::deque<Packet> m_pending; ///< requests understood, being worked on
    Timer m_answer;
};

/// All bytes of a packet add up to 0 (README.md#checksum).
[[nodiscard]] std::uint8_t sumOf(const std::vector<std::uint8_t> &bytes);

} // namespace mb::quadquad2drv::simulation
