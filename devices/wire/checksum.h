// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>

namespace mb {

/// A CRC-32 with polynomial 0x04C11DB7, reflected in and out.
/// zlib's is {0xFFFFFFFF, 0xFFFFFFFF}.
struct Crc32 {
    std::uint32_t init = 0xFFFFFFFFU;
    std::uint32_t xorOut = 0xFFFFFFFFU;

    [[nodiscard]] constexpr std::uint32_t of(std::span<const std::uint8_t> bytes) const
    {
        std::uint32_t crc = init;
        for (const std::uint8_t byte : bytes) {
            crc ^= byte;
            for (int bit = 0; bit < 8; ++bit)
                crc = (crc >> 1U) ^ ((crc & 1U) != 0U ? 0xEDB88320U : 0U);
        }
        return crc ^ xorOut;
    }
};

} // namespace mb
