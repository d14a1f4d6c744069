// SPDX-License-Identifier: GPL-3.0-or-later
#include "traffic/trafficline.h"

#include "wire/candumplog.h"

#include <algorithm>

namespace mb {

std::string hexText(std::span<const std::uint8_t> bytes)
{
    std::string text;
    text.reserve(bytes.size() * 2);
    for (const std::uint8_t byte : bytes) {
        text += "0123456789ABCDEF"[byte >> 4U];
        text += "0123456789ABCDEF"[byte & 0xFU];
    }
    return text;
}

std::string bytesLine(Duration time, std::string_view link, Direction direction, std::span<const std::uint8_t> bytes)
{
    std::string line = toCandumpLine(std::max(time, Duration::zero()), link, CanFrame{});
    line.erase(line.rfind(' '));
    return line + (direction == Direction::Sent ? " tx " : " rx ") + hexText(bytes);
}

} // namespace mb
