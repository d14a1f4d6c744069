// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"
#include "wire/canframe.h"

#include <deque>
#include <functional>

namespace mb::dmc60c::simulation {

/// The processor of a unit: while it writes flash it does nothing else, and frames wait in the receive FIFO.
class Processor {
public:
    struct Owner {
        std::function<void(const CanFrame &)> handle;
        std::function<void()> freed; ///< before the frames that waited are handled
    };
    Processor(Clock &clock, Owner owner);

    /// Handles the frame, now or later; lost when too many wait.
    void take(const CanFrame &frame);
    /// Does nothing for `time`, then `then`.
    void stall(Duration time, std::function<void()> then);
    [[nodiscard]] bool isBusy() const { return !m_stalls.empty(); }
    /// A reset.
    void clear();

private:
    struct Stall {
        Duration time;
        std::function<void()> then;
    };
    void begin();
    void end();

    Owner m_owner;
    std::deque<Stall> m_stalls;
    std::deque<CanFrame> m_fifo;
    Timer m_timer;
};

} // namespace mb::dmc60c::simulation
