// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/dmc60c/simulatorcontrol.h"
#include "families/dmc60c/simulatormemory.h"
#include "simulation/canoutbox.h"

#include <random>

namespace mb::dmc60c::simulation {

/// Sends the status frames of a unit, each kind at the period that its parameter says.
class StatusSender {
public:
    /// `mayTell`: the application runs and has a session. All outlive it.
    StatusSender(Clock &clock, Drive &drive, const ConfigMemory &memory, CanOutbox &outbox, std::mt19937_64 &random,
        std::function<bool()> mayTell);

    /// Each begins anywhere in its period.
    void start();
    void stop();
    /// This parameter was written: its frames come at the new period from now on.
    void restart(std::uint8_t period);

private:
    void arm(std::uint8_t period, Instant due);
    void send(std::uint8_t period, Instant due);
    [[nodiscard]] Timer &timer(std::uint8_t period);
    [[nodiscard]] Duration length(std::uint8_t period) const;

    Clock &m_clock;
    Drive &m_drive;
    const ConfigMemory &m_memory;
    CanOutbox &m_outbox;
    std::mt19937_64 &m_random;
    std::function<bool()> m_mayTell;
    Timer m_general;
    Timer m_encoder;
    Timer m_analog;
};

} // namespace mb::dmc60c::simulation
