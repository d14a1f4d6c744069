// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"
#include "families/quadquad2drv/packetport.h"

#include <cstdint>
#include <optional>

namespace mb::quadquad2drv {

/// How many samples of a board did not come: packets of its stream, and polls without an answer.
class MissedSamples {
public:
    /// A stream packet came at `time`, `elapsed` being what the board says it skipped before it: how many more are missing there.
    [[nodiscard]] std::uint64_t before(
        std::optional<std::uint8_t> elapsed, Instant time, Duration period, PacketPort::Damage damage);
    /// A poll was due while the one before was waited for.
    void pollHeldUp() { ++m_heldUp; }
    /// A poll ended: how many samples are missing.
    [[nodiscard]] std::uint64_t polled(bool answered);
    /// Nobody knows what was until now.
    void interrupt() { m_period = {}; }
    /// Of the latest stream packet.
    [[nodiscard]] std::optional<Instant> streamAt() const { return m_streamAt; }

private:
    std::optional<Instant> m_streamAt;
    Duration m_period{}; ///< in which it came; 0: the next one begins anew
    std::uint64_t m_heldUp = 0;
};

} // namespace mb::quadquad2drv
