// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"

namespace mb::console {

/// The time of a simulated bench that is worked on at its own pace: as fast as the clock below, from 0 on, but exact. All that
/// runs on it sees its own deadline as now, so that the same seed gives the same samples on any machine, however busy.
class SimulationClock final : public Clock {
public:
    explicit SimulationClock(Clock &base);

    [[nodiscard]] Instant now() const override { return m_now; }
    [[nodiscard]] Duration unixOffset() const override { return Duration::zero(); }

private:
    void rescheduled() override;
    void runDue();

    Clock &m_base;
    const Instant m_origin;
    Instant m_now{};
    bool m_running = false;
    Timer m_timer;
};

} // namespace mb::console
