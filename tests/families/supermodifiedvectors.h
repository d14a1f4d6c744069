// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/supermodified/frame.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mb::supermodified::test {

/// An example of the datasheet as it is printed, chapters 15.2 to 15.4 (94 frames), of dialect D1.
struct Example {
    std::string_view name;
    std::string_view host;
    std::string_view node;             ///< empty: a broadcast has no answer
    std::string_view right;            ///< the checksum of the host's frame where the printed one is wrong
    std::optional<std::int64_t> value; ///< of the host's data, or of the node's where the host has none
};

// clang-format off
constexpr std::array<Example, 49> examples{{
    {"15.2.1 set PID P 2000", "55 AA 04 01 00 02 D0 07 D5", "55 AA 01 04 00 00 00", "", 2000},
    {"15.2.2 set PID I 1000", "55 AA 04 01 01 02 E8 03 E8", "55 AA 01 04 01 00 01", "", 1000},
    {"15.2.3 set PID D 10000", "55 AA 04 01 02 02 10 27 37", "55 AA 01 04 02 00 02", "", 10000},
    {"15.2.4 set profile acceleration 800", "55 AA 04 01 03 02 20 03 22", "55 AA 01 04 03 00 03", "", 800},
    {"15.2.5 set profile velocity 800", "55 AA 04 01 04 02 20 03 25", "55 AA 01 04 04 00 04", "", 800},
    {"15.2.6 set current limit 900 mA", "55 AA 04 01 05 02 84 03 80", "55 AA 01 04 05 00 05", "", 900},
    {"15.2.7 set duration 10000 ms", "55 AA 04 01 06 02 10 27 37", "55 AA 01 04 06 00 06", "33", 10000},
    {"15.2.8 velocity move 500", "55 AA 04 01 07 02 F4 01 F0", "55 AA 01 04 07 00 07", "", 500},
    {"15.2.9 absolute move 10240", "55 AA 04 01 08 04 00 28 00 00 2B", "55 AA 01 04 08 00 08", "24", 10240},
    {"15.2.10 relative move -3000", "55 AA 04 01 09 04 48 F4 FF FF BF", "55 AA 01 04 09 00 09", "B1", -3000},
    {"15.2.11 profiled velocity -500", "55 AA 04 01 0A 02 0C FE FA", "55 AA 01 04 0A 00 0A", "", -500},
    {"15.2.12 profiled absolute -3000", "55 AA 04 01 0B 04 48 F4 FF FF B3", "55 AA 01 04 0B 00 0B", "", -3000},
    {"15.2.13 profiled relative 3000", "55 AA 04 01 0C 04 B8 0B 00 00 BB", "55 AA 01 04 0C 00 0C", "", 3000},
    {"15.2.14 buffer velocity 0", "55 AA 04 01 0D 02 00 00 0F", "55 AA 01 04 0D 00 0D", "", 0},
    {"15.2.15 buffer absolute 64", "55 AA 04 01 0E 04 40 00 00 00 4A", "55 AA 01 04 0E 00 0E", "", 64},
    {"15.2.16 buffer relative 0", "55 AA 04 01 0F 04 00 00 00 00 0B", "55 AA 01 04 0F 00 0F", "", 0},
    {"15.2.17 buffer profiled velocity 783", "55 AA 04 01 10 02 0F 03 1E", "55 AA 01 04 10 00 10", "", 783},
    {"15.2.18 buffer profiled absolute 0", "55 AA 04 01 11 04 00 00 00 00 15", "55 AA 01 04 11 00 11", "", 0},
    {"15.2.19 buffer profiled relative 0", "55 AA 04 01 12 04 00 00 00 00 16", "55 AA 01 04 12 00 12", "", 0},
    {"15.2.20 DIO direction 9", "55 AA 04 01 13 01 09 1B", "55 AA 01 04 13 00 13", "", 9},
    {"15.2.21 digital outputs 8", "55 AA 04 01 14 01 08 14", "55 AA 01 04 14 00 14", "1D", 8},
    {"15.2.22 node id 5", "55 AA 04 01 15 01 05 11", "55 AA 01 04 15 00 15", "", 5},
    {"15.2.23 mask F0 of node 16", "55 AA 10 01 16 01 F0 E7", "55 AA 01 10 16 00 16", "", 240},
    {"15.2.24 UART baud 19200", "55 AA 04 01 17 04 00 4B 00 00 58", "55 AA 01 04 17 00 17", "", 19200},
    {"15.2.25 reset position", "55 AA 04 01 18 00 18", "55 AA 01 04 18 00 18", "", std::nullopt},
    {"15.2.26 start", "55 AA 04 01 19 00 19", "55 AA 01 04 19 00 19", "", std::nullopt},
    {"15.2.27 halt", "55 AA 04 01 1A 00 1A", "55 AA 01 04 1A 00 1A", "", std::nullopt},
    {"15.2.28 stop", "55 AA 04 01 1B 00 1B", "55 AA 01 04 1B 00 1B", "", std::nullopt},
    {"15.2.29 error-reporting level 1", "55 AA 04 01 1C 01 01 1C", "55 AA 01 04 1C 00 1C", "", 1},
    {"15.3.1 get PID P", "55 AA 04 01 64 00 64", "55 AA 01 04 64 02 D0 07 B1", "", 2000},
    {"15.3.2 get PID I", "55 AA 04 01 65 00 65", "55 AA 01 04 65 02 E8 03 8C", "", 1000},
    {"15.3.3 get PID D", "55 AA 04 01 66 00 66", "55 AA 01 04 66 02 10 27 53", "", 10000},
    {"15.3.4 get profile acceleration", "55 AA 04 01 67 00 67", "55 AA 01 04 67 02 20 03 46", "", 800},
    {"15.3.5 get profile velocity", "55 AA 04 01 68 00 68", "55 AA 01 04 68 02 20 03 49", "", 800},
    {"15.3.6 get current limit", "55 AA 04 01 69 00 69", "55 AA 01 04 69 02 88 13 F0", "", 5000},
    {"15.3.7 get duration", "55 AA 04 01 6A 00 6A", "55 AA 01 04 6A 02 88 13 F3", "", 5000},
    {"15.3.8 get DIO direction", "55 AA 04 01 6B 00 6B", "55 AA 01 04 6B 01 0F 65", "", 15},
    {"15.3.9 get mask", "55 AA 04 01 6C 00 6C", "55 AA 01 04 6C 01 FF 92", "", 255},
    {"15.3.10 get digital inputs", "55 AA 04 01 6D 00 6D", "55 AA 01 04 6D 01 00 6C", "", 0},
    {"15.3.11 get analog inputs", "55 AA 04 01 6E 00 6E", "55 AA 01 04 6E 08 00 02 00 02 00 02 00 02 66", "", std::nullopt},
    {"15.3.12 get position", "55 AA 04 01 6F 00 6F", "55 AA 01 04 6F 04 33 16 00 00 4E", "", 5683},
    {"15.3.13 get absolute position", "55 AA 04 01 70 00 70", "55 AA 01 04 70 02 00 02 70", "", 512},
    {"15.3.14 get velocity", "55 AA 04 01 71 00 71", "55 AA 01 04 71 02 90 01 E2", "", 400},
    {"15.3.15 get current", "55 AA 04 01 72 00 72", "55 AA 01 04 72 02 BB 00 CB", "", 187},
    {"15.3.16 get warnings", "55 AA 04 01 73 00 73", "55 AA 01 04 73 01 00 72", "", std::nullopt},
    {"15.4.1 do move", "55 AA 00 01 C8 00 C8", "", "", std::nullopt},
    {"15.4.2 global start", "55 AA 00 01 C9 00 C9", "", "", std::nullopt},
    {"15.4.3 global halt", "55 AA 00 01 CA 00 CA", "", "", std::nullopt},
    {"15.4.4 global stop", "55 AA 00 01 CB 00 CB", "", "", std::nullopt},
}};
// clang-format on

[[nodiscard]] inline std::vector<std::uint8_t> bytesOf(std::string_view hex)
{
    std::vector<std::uint8_t> bytes;
    for (std::size_t i = 0; i + 1 < hex.size(); i += 3)
        bytes.push_back(static_cast<std::uint8_t>(std::stoi(std::string(hex.substr(i, 2)), nullptr, 16)));
    return bytes;
}

/// As the datasheet meant it.
[[nodiscard]] inline std::vector<std::uint8_t> correctedBytes(const Example &example)
{
    auto bytes = bytesOf(example.host);
    if (!example.right.empty())
        bytes.back() = bytesOf(example.right).front();
    return bytes;
}

/// The frames in some bytes.
[[nodiscard]] inline std::vector<Frame> framesIn(const std::vector<std::uint8_t> &bytes)
{
    std::vector<Frame> frames;
    FrameReader reader([&frames](const Frame &frame) { frames.push_back(frame); });
    reader.feed(bytes);
    return frames;
}

} // namespace mb::supermodified::test
