// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/dmc60c/simulatorparameters.h"
#include "families/dmc60c/simulatorrig.h"
#include "families/dmc60c/simulatorstatus.h"

#include <vector>

namespace mb::dmc60c::simulation {

enum class VelocityWindow { Rolling, Block };

/// What the application measures of its motor in each pass: position, velocity and current.
class Sensing {
public:
    /// Both outlive it.
    Sensing(Rig &rig, const ParameterBank &bank, VelocityWindow window);

    /// The application starts: position 0.
    void start();
    /// One pass. `reversed`: the sensor counts the other way round; a limit that is hit may clear the position.
    void pass(bool reversed, bool forwardHit, bool reverseHit);
    [[nodiscard]] std::int32_t position() const { return static_cast<std::int32_t>(m_position); }
    void setPosition(std::int32_t counts) { m_position = static_cast<std::uint32_t>(counts); }
    /// Counts per 100 ms.
    [[nodiscard]] std::int32_t velocity() const { return m_velocity; }
    /// 16.16 A
    [[nodiscard]] std::int64_t current() const { return m_current; }
    [[nodiscard]] EncoderState encoder() const;

private:
    void clearOnIndex(bool reversed, std::int64_t before, std::int64_t after);
    [[nodiscard]] std::int64_t velocityNow();

    Rig &m_rig;
    const ParameterBank &m_bank;
    VelocityWindow m_window;
    std::int64_t m_lastCounts = 0;
    std::uint32_t m_position = 0;
    std::int64_t m_counter = 0;          ///< like the position, but never written
    std::vector<std::int64_t> m_history; ///< of m_counter, 100 ms
    std::size_t m_historyAt = 0;
    std::int32_t m_velocity = 0;
    std::int64_t m_current = 0;
};

} // namespace mb::dmc60c::simulation
