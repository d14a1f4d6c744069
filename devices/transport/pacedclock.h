// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"

namespace mb {

/// The time of a recording or of a simulated bench, driven by another clock: it stands, runs at a pace, or jumps. Work that is
/// armed on it comes in the order of its deadlines, and sees exactly its deadline as now(), whatever the pace and however late
/// the computer is: what follows is the same at every pace. Whoever was held up catches up.
class PacedClock final : public Clock {
public:
    /// Stands, at the present time of `outer`, which outlives it.
    explicit PacedClock(Clock &outer);

    [[nodiscard]] Instant now() const override;
    /// That of the outer clock when this one was made: it must not drift while a recording plays.
    [[nodiscard]] Duration unixOffset() const override { return m_offset; }

    /// `pace` 1 is real time, 0 as fast as the work can be done.
    void run(double pace);
    void pause();
    /// To any time, also back. Work that was armed keeps its deadline.
    void jump(Instant to);
    [[nodiscard]] bool isRunning() const { return m_running; }
    [[nodiscard]] double pace() const { return m_pace; }

private:
    void rescheduled() override;
    void runDue();
    [[nodiscard]] Instant timeAt(Instant outer) const;
    [[nodiscard]] Instant outerTimeOf(Instant deadline) const;

    Clock &m_outer;
    Duration m_offset;
    Instant m_now;
    bool m_running = false;
    bool m_inWork = false;
    double m_pace = 1.0;
    Instant m_anchor;      ///< our time …
    Instant m_outerAnchor; ///< … at this time of the outer clock
    Instant m_armedFor{};
    Instant m_outerArmedFor{};
    Timer m_timer;
};

} // namespace mb
