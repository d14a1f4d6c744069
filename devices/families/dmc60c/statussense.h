// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/dmc60c/codec.h"
#include "families/dmc60c/statusstream.h"
#include "model/livestate.h"

namespace mb::dmc60c {

/// What the three periodic frames of one unit say: samples for its telemetry, the states of its pins and limits, whether it turns.
class StatusSense {
public:
    explicit StatusSense(const std::shared_ptr<Telemetry> &telemetry);

    /// `stoppedAt`: of the last stop.
    void take(const StatusGeneral &status, Instant time, Instant stoppedAt);
    /// `heard`: its general frames come.
    void take(const StatusEncoder &status, Instant time, bool heard);
    void take(const StatusAnalog &status, Instant time);
    /// It has been told to stop: frames without output count from now on.
    void stopped() { m_idleFrames = 0; }
    /// It is not heard any more.
    void interrupt();
    /// It began anew.
    void restart();

    /// Of the frame whose period this parameter is; nullptr for others.
    [[nodiscard]] StatusStream *streamOf(std::uint8_t periodParameter);
    [[nodiscard]] Duration generalPeriod() const { return m_general.period(); }
    [[nodiscard]] const StatusGeneral &general() const { return m_lastGeneral; }
    [[nodiscard]] const LiveStates &states() const { return m_told; }
    [[nodiscard]] Instant statesAt() const { return m_toldAt; }
    /// Its shaft turned a moment ago.
    [[nodiscard]] bool isTurning(Instant now) const;
    /// Its output is off: it says so, or several frames in a row do.
    [[nodiscard]] bool isIdle() const;

private:
    StatusStream m_general;
    StatusStream m_encoder;
    StatusStream m_analog;
    StatusGeneral m_lastGeneral;
    int m_idleFrames = 0; ///< general frames in a row with no output, since the last stop
    bool m_turning = false;
    Instant m_turningAt{};
    LiveStates m_told; ///< by the frames of the device
    Instant m_toldAt{};
};

} // namespace mb::dmc60c
