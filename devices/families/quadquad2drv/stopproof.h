// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/scope.h"
#include "families/quadquad2drv/packetport.h"

#include <functional>

namespace mb::quadquad2drv {

/// Stops all axes and asks until the board has confirmed it. Where it goes on not answering, its reset line is the last resort
/// (README.md#stopping). Engine thread.
class StopProof {
public:
    /// The port outlives it; `reset` pulls the line where there is one and the board may be reset now, `ended` is told when it is confirmed
    /// and when nobody is asked any more.
    StopProof(Clock &clock, PacketPort &port, std::function<void()> reset, std::function<void()> ended);

    void begin();
    /// Since begin().
    [[nodiscard]] bool isConfirmed() const { return m_confirmed; }

private:
    [[nodiscard]] Task<void> confirm();

    Clock &m_clock;
    PacketPort &m_port;
    std::function<void()> m_reset;
    std::function<void()> m_ended;
    int m_unanswered = 0; ///< in a row, since one was confirmed
    bool m_resetTried = false;
    bool m_confirmed = false;
    std::uint64_t m_stops = 0;
    Scope m_scope; ///< last: its tasks use everything above
};

} // namespace mb::quadquad2drv
