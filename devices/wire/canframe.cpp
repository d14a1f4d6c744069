// SPDX-License-Identifier: GPL-3.0-or-later
#include "wire/canframe.h"

#include <algorithm>
#include <charconv>
#include <cstdio>

namespace mb {
namespace {

constexpr int tailBits = 1 + 2 + 7 + 3; // CRC delimiter, acknowledge slot and delimiter, end of frame, intermission

/// Feeds bits to the CRC and counts the stuff bits (a bit of the other level after five equal ones).
class BitCounter {
public:
    void add(std::uint32_t value, int width)
    {
        for (int i = width - 1; i >= 0; --i)
            addBit(((value >> i) & 1U) != 0U);
    }
    void addBit(bool bit)
    {
        const bool feedback = bit != ((m_crc & 0x4000U) != 0U);
        m_crc = (m_crc << 1) & 0x7FFFU;
        if (feedback)
            m_crc ^= 0x4599U;
        count(bit);
    }
    int finish()
    {
        const std::uint32_t crc = m_crc;
        for (int i = 14; i >= 0; --i)
            count(((crc >> i) & 1U) != 0U);
        return m_bits;
    }

private:
    void count(bool bit)
    {
        ++m_bits;
        m_run = bit == m_level ? m_run + 1 : 1;
        m_level = bit;
        if (m_run == 5) {
            ++m_bits;
            m_level = !m_level;
            m_run = 1;
        }
    }
    std::uint32_t m_crc = 0;
    int m_bits = 0;
    int m_run = 0;
    bool m_level = true;
};

CanFrame frameOf(std::uint32_t id, bool extended, std::span<const std::uint8_t> bytes)
{
    CanFrame frame;
    frame.id = id;
    frame.extended = extended;
    frame.size = static_cast<std::uint8_t>(std::min<std::size_t>(bytes.size(), frame.data.size()));
    std::copy_n(bytes.begin(), frame.size, frame.data.begin());
    return frame;
}

} // namespace

CanFrame extendedFrame(std::uint32_t id, std::span<const std::uint8_t> bytes)
{
    return frameOf(id, true, bytes);
}

CanFrame extendedFrame(std::uint32_t id, std::initializer_list<std::uint8_t> bytes)
{
    return frameOf(id, true, std::span(bytes.begin(), bytes.size()));
}

CanFrame standardFrame(std::uint32_t id, std::span<const std::uint8_t> bytes)
{
    return frameOf(id, false, bytes);
}

bool sameContent(const CanFrame &a, const CanFrame &b)
{
    return a.id == b.id && a.size == b.size && a.extended == b.extended && a.remote == b.remote && a.error == b.error
        && (a.remote || std::equal(a.data.begin(), a.data.begin() + a.size, b.data.begin()));
}

std::string toText(const CanFrame &frame)
{
    std::array<char, 16> id{};
    const std::uint32_t shown = frame.error ? frame.id | 0x20000000U : frame.id;
    const bool wide = frame.extended || frame.error;
    std::snprintf(id.data(), id.size(), wide ? "%08X" : "%03X", shown);
    std::string text = std::string(id.data()) + '#';
    if (frame.remote)
        return text + 'R' + (frame.size != 0 ? std::to_string(frame.size) : std::string());
    constexpr std::string_view digits = "0123456789ABCDEF";
    for (const std::uint8_t byte : frame.bytes()) {
        text += digits[byte >> 4U];
        text += digits[byte & 15U];
    }
    return text;
}

std::optional<CanFrame> canFrameFromText(std::string_view text)
{
    const auto hash = text.find('#');
    if (hash != 3 && hash != 8)
        return std::nullopt;
    CanFrame frame;
    const auto idEnd = text.data() + hash;
    if (const auto parsed = std::from_chars(text.data(), idEnd, frame.id, 16);
        parsed.ec != std::errc{} || parsed.ptr != idEnd)
        return std::nullopt;
    frame.extended = hash == 8;
    if (frame.extended && (frame.id & 0xE0000000U) == 0x20000000U) {
        frame.error = true;
        frame.extended = false;
        frame.id &= 0x1FFFFFFFU;
    }
    if (frame.id > (frame.extended || frame.error ? 0x1FFFFFFFU : 0x7FFU))
        return std::nullopt;
    const std::string_view data = text.substr(hash + 1);
    if (!data.empty() && (data.front() == 'R' || data.front() == 'r')) {
        frame.remote = true;
        if (data.size() == 2 && data[1] >= '0' && data[1] <= '8')
            frame.size = static_cast<std::uint8_t>(data[1] - '0');
        else if (data.size() != 1)
            return std::nullopt;
        return frame;
    }
    if (data.size() % 2 != 0 || data.size() > 16)
        return std::nullopt;
    frame.size = static_cast<std::uint8_t>(data.size() / 2);
    for (std::size_t i = 0; i < frame.size; ++i) {
        const char *first = data.data() + 2 * i;
        const auto parsed = std::from_chars(first, first + 2, frame.data[i], 16);
        if (parsed.ec != std::errc{} || parsed.ptr != first + 2)
            return std::nullopt;
    }
    return frame;
}

int bitsOnWire(const CanFrame &frame)
{
    BitCounter bits;
    bits.addBit(false); // start of frame
    if (frame.extended) {
        bits.add(frame.id >> 18U, 11);
        bits.add(3, 2); // SRR, IDE recessive
        bits.add(frame.id & 0x3FFFFU, 18);
        bits.addBit(frame.remote);
        bits.add(0, 2);
    } else {
        bits.add(frame.id, 11);
        bits.addBit(frame.remote);
        bits.add(0, 2);
    }
    bits.add(frame.size, 4);
    if (!frame.remote) {
        for (const std::uint8_t byte : frame.bytes())
            bits.add(byte, 8);
    }
    return bits.finish() + tailBits;
}

} // namespace mb
