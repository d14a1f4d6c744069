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

namespace {

/// Hex digits and nothing else.
template <typename Number> bool hexInto(std::string_view digits, Number &number)
{
    const char *const end = digits.data() + digits.size();
    const auto parsed = std::from_chars(digits.data(), end, number, 16);
    return parsed.ec == std::errc{} && parsed.ptr == end;
}

/// Three or eight digits; with bit 29 an error frame.
bool readIdentifier(std::string_view digits, CanFrame &frame)
{
    if ((digits.size() != 3 && digits.size() != 8) || !hexInto(digits, frame.id))
        return false;
    frame.extended = digits.size() == 8;
    if (frame.extended && (frame.id & 0xE0000000U) == 0x20000000U) {
        frame.error = true;
        frame.extended = false;
        frame.id &= 0x1FFFFFFFU;
    }
    return frame.id <= (frame.extended || frame.error ? 0x1FFFFFFFU : 0x7FFU);
}

/// What follows the R of a request: nothing, or its length.
bool readRequest(std::string_view length, CanFrame &frame)
{
    frame.remote = true;
    if (length.empty())
        return true;
    if (length.size() != 1 || length[0] < '0' || length[0] > '8')
        return false;
    frame.size = static_cast<std::uint8_t>(length[0] - '0');
    return true;
}

bool readPayload(std::string_view digits, CanFrame &frame)
{
    if (digits.size() % 2 != 0 || digits.size() > 2 * frame.data.size())
        return false;
    frame.size = static_cast<std::uint8_t>(digits.size() / 2);
    for (std::size_t i = 0; i < frame.size; ++i) {
        if (!hexInto(digits.substr(2 * i, 2), frame.data[i]))
            return false;
    }
    return true;
}

} // namespace

std::optional<CanFrame> canFrameFromText(std::string_view text)
{
    const auto hash = text.find('#');
    CanFrame frame;
    if (hash == std::string_view::npos || !readIdentifier(text.substr(0, hash), frame))
        return std::nullopt;
    const std::string_view data = text.substr(hash + 1);
    const bool request = !data.empty() && (data.front() == 'R' || data.front() == 'r');
    if (request ? !readRequest(data.substr(1), frame) : !readPayload(data, frame))
        return std::nullopt;
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
