// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/dmc60c/simulatorsender.h"

#include <span>

namespace mb::dmc60c::simulation {

/// What a unit does with requests for its parameters.
class ParameterPort {
public:
    /// `reply` sends the bytes of a response. All outlive it.
    ParameterPort(Clock &clock, Drive &drive, ConfigMemory &memory, StatusSender &status,
        std::function<void(std::span<const std::uint8_t>)> reply);

    void read(std::uint8_t id);
    void write(std::uint8_t id, std::uint32_t raw);

private:
    void answer(std::uint8_t id, std::uint32_t raw, ParameterStatus status);
    [[nodiscard]] bool isAcceptable(const Row &row, std::uint32_t raw) const;

    Clock &m_clock;
    Drive &m_drive;
    ConfigMemory &m_memory;
    StatusSender &m_status;
    std::function<void(std::span<const std::uint8_t>)> m_reply;
};

} // namespace mb::dmc60c::simulation
