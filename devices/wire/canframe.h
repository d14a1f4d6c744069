// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"

#include <array>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace mb {

/// A classic CAN frame. `id` has 11 or 29 bits and no flags in it. An error frame (`error`) carries the kernel's error
/// class in `id` and its detail in `data`, as in linux/can/error.h.
struct CanFrame {
    std::uint32_t id = 0;
    std::uint8_t size = 0; ///< 0…8 bytes of `data`
    bool extended = false;
    bool remote = false;
    bool error = false;
    std::array<std::uint8_t, 8> data{};
    Instant time{}; ///< when it was on the wire, as exactly as the link knows

    [[nodiscard]] std::span<const std::uint8_t> bytes() const { return {data.data(), size}; }
};

[[nodiscard]] CanFrame extendedFrame(std::uint32_t id, std::span<const std::uint8_t> bytes);
[[nodiscard]] CanFrame extendedFrame(std::uint32_t id, std::initializer_list<std::uint8_t> bytes);
[[nodiscard]] CanFrame standardFrame(std::uint32_t id, std::span<const std::uint8_t> bytes);

/// Identifier, format and data are equal; time is not looked at.
[[nodiscard]] bool sameContent(const CanFrame &a, const CanFrame &b);

/// `02061405#0040110000000000` (8 digits: 29 bits, 3 digits: 11 bits, `R` and the length after # for remote), the text of
/// candump -L.
[[nodiscard]] std::string toText(const CanFrame &frame);
/// Reads toText(); nothing when it is not such a text.
[[nodiscard]] std::optional<CanFrame> canFrameFromText(std::string_view text);

/// Length of the frame on the wire in bit times, stuff bits counted exactly, with end of frame and intermission.
[[nodiscard]] int bitsOnWire(const CanFrame &frame);

} // namespace mb
