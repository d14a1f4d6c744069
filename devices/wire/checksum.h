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

/// What a shift register with polynomial 0x04C11DB7 holds, bits mirrored, that began at 0, was fed each byte lowest bit first
/// and then flushed with 16 zero bits. 32 zero bits would make it Crc32 {0, 0}.
[[nodiscard]] constexpr std::uint32_t crc32HalfFlushed(std::span<const std::uint8_t> bytes)
{
    std::uint32_t crc = 0;
    const auto shiftIn = [&crc](std::uint32_t bit) {
        const bool out = (crc & 1U) != 0U;
        crc = (crc >> 1U) | (bit << 31U);
        if (out)
            crc ^= 0xEDB88320U;
    };
    for (const std::uint8_t byte : bytes) {
        for (int bit = 0; bit < 8; ++bit)
            shiftIn((byte >> bit) & 1U);
    }
    for (int bit = 0; bit < 16; ++bit)
        shiftIn(0);
    return crc;
}

} // namespace mb
