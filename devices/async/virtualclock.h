// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"

namespace mb {

/// Jumps from deadline to deadline: hours of protocol run in milliseconds, the same way every time.
class VirtualClock final : public Clock {
public:
    [[nodiscard]] Instant now() const override { return m_now; }
    [[nodiscard]] Duration unixOffset() const override { return Duration::zero(); }

    /// Runs the next work; false when nothing is armed.
    bool step();
    /// Runs all that falls due within `time` and ends exactly there.
    void advance(Duration time);
    /// Steps until `done()`; false when the queue ran dry or `limit` of virtual time passed first.
    bool runUntil(const std::function<bool()> &done, Duration limit = std::chrono::hours(1));
    /// The machine stands still: time passes, and what falls due meanwhile runs late.
    void stall(Duration time) { m_now += time; }

private:
    Instant m_now{};
};

} // namespace mb
