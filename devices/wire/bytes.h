// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace mb {

/// Reads and writes of fixed-width integers in byte buffers. The caller has checked the length.
[[nodiscard]] constexpr std::uint16_t readU16le(std::span<const std::uint8_t> b, std::size_t at)
{
    return static_cast<std::uint16_t>(b[at] | (b[at + 1] << 8));
}
[[nodiscard]] constexpr std::uint16_t readU16be(std::span<const std::uint8_t> b, std::size_t at)
{
    return static_cast<std::uint16_t>((b[at] << 8) | b[at + 1]);
}
[[nodiscard]] constexpr std::uint32_t readU32le(std::span<const std::uint8_t> b, std::size_t at)
{
    return static_cast<std::uint32_t>(readU16le(b, at)) | (static_cast<std::uint32_t>(readU16le(b, at + 2)) << 16U);
}
constexpr void writeU16le(std::span<std::uint8_t> b, std::size_t at, std::uint16_t value)
{
    b[at] = static_cast<std::uint8_t>(value & 0xFFU);
    b[at + 1] = static_cast<std::uint8_t>(value >> 8U);
}
constexpr void writeU16be(std::span<std::uint8_t> b, std::size_t at, std::uint16_t value)
{
    b[at] = static_cast<std::uint8_t>(value >> 8U);
    b[at + 1] = static_cast<std::uint8_t>(value & 0xFFU);
}
constexpr void writeU32le(std::span<std::uint8_t> b, std::size_t at, std::uint32_t value)
{
    writeU16le(b, at, static_cast<std::uint16_t>(value & 0xFFFFU));
    writeU16le(b, at + 2, static_cast<std::uint16_t>(value >> 16U));
}
/// The low `bits` of `value` as a two's complement number.
[[nodiscard]] constexpr std::int32_t signExtend(std::uint32_t value, int bits)
{
    const std::uint32_t sign = 1U << (bits - 1);
    const std::uint32_t kept = bits == 32 ? value : value & ((1U << bits) - 1U);
    return static_cast<std::int32_t>((kept ^ sign) - sign);
}

} // namespace mb
