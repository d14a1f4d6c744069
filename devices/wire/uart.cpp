// SPDX-License-Identifier: GPL-3.0-or-later
#include "wire/uart.h"

#include <cmath>
#include <cstddef>

namespace mb {
namespace {

/// The level of the line over time, counted in bits of the sender; high before and after.
class Waveform {
public:
    explicit Waveform(std::span<const std::uint8_t> bytes)
        : m_bytes(bytes)
    {
    }
    [[nodiscard]] double end() const { return static_cast<double>(m_bytes.size() * 10); }
    [[nodiscard]] bool isHigh(double time) const
    {
        if (time < 0.0 || time >= end())
            return true;
        const auto bit = static_cast<std::size_t>(time);
        const std::size_t place = bit % 10;
        if (place == 0 || place == 9)
            return place == 9;
        return ((m_bytes[bit / 10] >> (place - 1)) & 1U) != 0;
    }
    /// The start of the first low bit from `time` on that a high one precedes; not before end() when there is none.
    [[nodiscard]] double fallingEdge(double time) const
    {
        double bit = std::floor(time);
        if (bit == time && !isHigh(bit) && isHigh(bit - 1.0))
            return bit;
        do
            bit += 1.0;
        while (bit < end() && (isHigh(bit) || !isHigh(bit - 1.0)));
        return bit;
    }

private:
    std::span<const std::uint8_t> m_bytes;
};

} // namespace

std::vector<UartByte> sampledAt(std::span<const std::uint8_t> bytes, double ratio)
{
    const Waveform line(bytes);
    std::vector<UartByte> heard;
    for (double edge = line.fallingEdge(0.0); edge < line.end();) {
        const auto middleOf = [&](int bit) { return edge + (bit + 0.5) * ratio; };
        if (line.isHigh(middleOf(0))) { // a spike, no start bit
            edge = line.fallingEdge(middleOf(0));
            continue;
        }
        UartByte byte;
        for (int bit = 0; bit < 8; ++bit)
            byte.value = static_cast<std::uint8_t>(byte.value | (line.isHigh(middleOf(bit + 1)) ? 1U << bit : 0U));
        if (!line.isHigh(middleOf(9)))
            byte = {0, true};
        heard.push_back(byte);
        edge = line.fallingEdge(middleOf(9));
    }
    return heard;
}

} // namespace mb
