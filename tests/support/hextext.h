// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <initializer_list>
#include <span>
#include <string>
#include <vector>

namespace mb::test {

/// One line of Intel HEX with the right count and checksum.
[[nodiscard]] inline std::string hexRecord(int type, std::uint32_t address, std::span<const std::uint8_t> data)
{
    std::vector<std::uint32_t> bytes{static_cast<std::uint32_t>(data.size()), (address >> 8U) & 0xFFU, address & 0xFFU,
        static_cast<std::uint32_t>(type)};
    bytes.insert(bytes.end(), data.begin(), data.end());
    std::uint32_t sum = 0;
    for (const std::uint32_t byte : bytes)
        sum += byte;
    bytes.push_back((0U - sum) & 0xFFU);
    std::string line = ":";
    for (const std::uint32_t byte : bytes) {
        std::array<char, 16> text{};
        std::snprintf(text.data(), text.size(), "%02X", byte);
        line += text.data();
    }
    return line + '\n';
}

/// Builds the text of a small Intel HEX file.
class HexText {
public:
    HexText &add(std::uint32_t address, std::span<const std::uint8_t> data)
    {
        while (!data.empty()) {
            const std::uint32_t upper = address >> 16U;
            const std::array base{static_cast<std::uint8_t>(upper >> 8U), static_cast<std::uint8_t>(upper & 0xFFU)};
            m_text += hexRecord(4, 0, base);
            const std::size_t size
                = std::min({data.size(), std::size_t{16}, std::size_t{0x10000U - (address & 0xFFFFU)}});
            m_text += hexRecord(0, address & 0xFFFFU, data.first(size));
            data = data.subspan(size);
            address += static_cast<std::uint32_t>(size);
        }
        return *this;
    }
    HexText &add(std::uint32_t address, std::initializer_list<std::uint8_t> data)
    {
        return add(address, std::span(data.begin(), data.size()));
    }
    /// The text with its end-of-file record.
    [[nodiscard]] std::string text() const { return m_text + ":00000001FF\n"; }

private:
    std::string m_text;
};

/// The smallest file that a DMC60C update accepts: pages 0 and 30.
[[nodiscard]] inline HexText smallApplication(std::uint16_t version = 0x0117)
{
    HexText hex;
    hex.add(0x0, {0x00, 0x02, 0x04, 0x00, 0x00, 0x00, 0x00, 0x00}).add(0x400, {0x00, 0x00, 0xFA, 0x00});
    hex.add(
        0x1EFFC, {static_cast<std::uint8_t>(version & 0xFFU), static_cast<std::uint8_t>(version >> 8U), 0x00, 0x00});
    return hex;
}

} // namespace mb::test
