// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace mb {

/// One byte as a UART takes it from the line.
struct UartByte {
    std::uint8_t value = 0;    ///< 0 after a framing error, as Linux hands it out
    bool framingError = false; ///< its stop bit was not there

    friend bool operator==(const UartByte &, const UartByte &) = default;
};

/// What a receiver makes of bytes that were sent without gaps at another rate: start bit, 8 data bits, one stop bit,
/// each sampled once in its middle. `ratio` is the sender's rate divided by the receiver's, > 0. Up to some four
/// percent of difference nothing changes; beyond that it is the garbage that a real UART reads.
[[nodiscard]] std::vector<UartByte> sampledAt(std::span<const std::uint8_t> bytes, double ratio);

} // namespace mb
