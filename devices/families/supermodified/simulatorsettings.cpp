// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/supermodified/simulatorsettings.h"

#include <algorithm>

namespace mb::supermodified::simulation {

void put(std::vector<std::uint8_t> &out, std::int64_t value, std::size_t size)
{
    for (std::size_t i = 0; i < size; ++i)
        out.push_back(static_cast<std::uint8_t>((value >> (8 * i)) & 0xFF));
}

LoopSettings Settings::loop() const
{
    return {m_ram.p, m_ram.i, m_ram.d, m_ram.acceleration, m_ram.velocity};
}

bool Settings::store(std::uint8_t command, std::uint64_t value)
{
    const auto u16 = static_cast<std::uint16_t>(value);
    const auto u32 = static_cast<std::uint32_t>(value);
    if (value == 0 && command >= 0x03 && command <= 0x05) {
        return false;
    }
    switch (command) {
    case 0x00: m_ram.p = m_eeprom.p = u16; break;
    case 0x01: m_ram.i = m_eeprom.i = u16; break;
    case 0x02: m_ram.d = m_eeprom.d = u16; break;
    case 0x03: m_ram.acceleration = m_eeprom.acceleration = u32; break;
    case 0x04: m_ram.velocity = m_eeprom.velocity = u32; break;
    case 0x05: m_ram.currentLimit = m_eeprom.currentLimit = u16; break;
    case 0x06:
        m_eeprom.duration = u16;
        (isThird() ? m_ram.duration : m_ram.currentLimit) = u16; // README.md#settings
        break;
    case 0x13: m_ram.direction = m_eeprom.direction = static_cast<std::uint8_t>(value & 0x0FU); break;
    case 0x1D: m_ram.antiWindup = m_eeprom.antiWindup = u32; break;
    default: return storeIdentity(command, value);
    }
    return true;
}

/// In force after a restart, but for the error level.
bool Settings::storeIdentity(std::uint8_t command, std::uint64_t value)
{
    const bool good = command == 0x15 ? value >= lowestNode && value <= highestNode
        : command == 0x1C             ? value <= 1
                                      : value >= 1 && value <= fastestRate;
    if (!good)
        return false;
    const auto byte = static_cast<std::uint8_t>(value & 0xFFU);
    switch (command) {
    case 0x15: m_eeprom.node = byte; break;
    case 0x16: m_eeprom.mask = byte; break;
    case 0x17: m_eeprom.baudrate = static_cast<std::uint32_t>(value); break;
    case 0x1C: m_ram.level = m_eeprom.level = byte; break;
    default: break;
    }
    return true;
}

bool Settings::storeReactions(std::span<const std::uint8_t> data)
{
    const bool good = std::ranges::none_of(data, [](std::uint8_t r) { return r > mostReaction; });
    if (good)
        std::copy(data.begin(), data.end(), m_ram.reactions.begin());
    m_eeprom.reactions = m_ram.reactions;
    return good;
}

void Settings::get(std::uint8_t command, std::vector<std::uint8_t> &reply) const
{
    const std::size_t profile = m_dialect == Dialect::D1 ? 2 : 4;
    switch (command) {
    case 0x64: put(reply, m_ram.p, 2); break;
    case 0x65: put(reply, m_ram.i, 2); break;
    case 0x66: put(reply, m_ram.d, 2); break;
    case 0x67: put(reply, m_ram.acceleration, profile); break;
    case 0x68: put(reply, m_ram.velocity, profile); break;
    case 0x69: put(reply, m_ram.currentLimit, 2); break;
    case 0x6A: put(reply, m_ram.duration, 2); break;
    case 0x6B: put(reply, m_ram.direction, 1); break;
    case 0x6C: put(reply, m_ram.mask, 1); break;
    case 0x74: put(reply, m_ram.antiWindup, 4); break;
    default: break;
    }
}

} // namespace mb::supermodified::simulation
