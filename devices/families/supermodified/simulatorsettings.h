// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/supermodified/protocol.h"
#include "families/supermodified/simulatorprofile.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace mb::supermodified::simulation {

/// What survives a power cycle; factory values of README.md#settings.
struct Eeprom {
    std::uint16_t p = 4000;
    std::uint16_t i = 100;
    std::uint16_t d = 1000;
    std::uint32_t acceleration = 800;
    std::uint32_t velocity = 800;
    std::uint16_t currentLimit = 5000;
    std::uint16_t duration = 5000;
    std::uint8_t direction = 0;
    std::uint8_t node = factoryNode;
    std::uint8_t mask = exactMask;
    std::uint32_t baudrate = 115200;
    std::uint8_t level = 0;
    std::array<std::uint8_t, reactionCount> reactions{};
    std::uint32_t antiWindup = 0;
};

/// Appends the low bytes of an answer, the lowest first.
void put(std::vector<std::uint8_t> &out, std::int64_t value, std::size_t size);

/// The settings of the firmware: what is stored, what is in force, and which of the two a command changes.
class Settings {
public:
    Settings(Dialect dialect, const Eeprom &eeprom)
        : m_dialect(dialect)
        , m_eeprom(eeprom)
    {
    }

    /// What is stored is in force.
    void restart() { m_ram = m_eeprom; }
    [[nodiscard]] const Eeprom &inForce() const { return m_ram; }
    [[nodiscard]] LoopSettings loop() const;

    /// A command that sets a number; false: invalid argument.
    [[nodiscard]] bool store(std::uint8_t command, std::uint64_t value);
    /// What D3 does on each of its errors; false: invalid argument.
    [[nodiscard]] bool storeReactions(std::span<const std::uint8_t> data);
    /// Appends the answer to a question for a setting; nothing for others.
    void get(std::uint8_t command, std::vector<std::uint8_t> &reply) const;

private:
    [[nodiscard]] bool storeIdentity(std::uint8_t command, std::uint64_t value);
    [[nodiscard]] bool isThird() const { return m_dialect == Dialect::D3; }

    Dialect m_dialect;
    Eeprom m_eeprom;
    Eeprom m_ram;
};

} // namespace mb::supermodified::simulation
