// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/dmc60c/simulatorcontrol.h"
#include "families/dmc60c/simulatorprocessor.h"

namespace mb::dmc60c::simulation {

/// Halts the drive when no control frame has come for too long; a processor that writes flash notices it afterwards.
class Heartbeat {
public:
    /// All outlive it.
    Heartbeat(Clock &clock, Processor &processor, Drive &drive)
        : m_clock(clock)
        , m_processor(processor)
        , m_drive(drive)
        , m_timer(clock)
    {
    }

    /// A control frame that came then: of the device's own timer, however late this process runs.
    void beat(Instant time)
    {
        m_missed = false;
        const Instant end = time + heartbeat;
        m_timer.start(end, [this, end] {
            if (m_processor.isBusy())
                m_missed = true;
            else
                m_drive.halt(end, false);
        });
    }
    /// The processor has time again.
    void freed()
    {
        if (std::exchange(m_missed, false))
            m_drive.halt(m_clock.now(), false);
    }
    void stop() { m_timer.stop(); }
    /// A reset.
    void clear()
    {
        stop();
        m_missed = false;
    }

private:
    Clock &m_clock;
    Processor &m_processor;
    Drive &m_drive;
    bool m_missed = false;
    Timer m_timer;
};

} // namespace mb::dmc60c::simulation
