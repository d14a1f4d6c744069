// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/supermodified/simulatorprofile.h"

#include <utility>

namespace mb::supermodified::simulation {

/// The integer PID of the firmware, one step a loop, and its detection of a stall (README.md#settings).
class Control {
public:
    /// The settings outlive it.
    Control(Dialect dialect, const LoopSettings &settings)
        : m_dialect(dialect)
        , m_settings(settings)
    {
    }

    /// The bound of the integral follows from the P of now.
    void restart() { m_windup = m_settings.p > 0 ? 65535 / m_settings.p * 255 : 0; }
    /// The bridge goes on or off.
    void clear();
    /// The set-point is held anew: what was stuck before does not count.
    void hold();
    /// The duty, -1 … 1.
    [[nodiscard]] double step(std::int64_t error);
    /// The last step has found the motor stalled for 2 s; once.
    [[nodiscard]] bool takeStall() { return std::exchange(m_stalled, false); }

private:
    void watchStall(std::int64_t error);

    Dialect m_dialect;
    const LoopSettings &m_settings;
    std::int64_t m_lastError = 0;
    std::int64_t m_sum = 0;
    std::int64_t m_windup = 0;
    std::int64_t m_leastError = 0;
    int m_stuckLoops = 0;
    bool m_stalled = false;
};

} // namespace mb::supermodified::simulation
