// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "families/supermodified/protocol.h"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace mb::supermodified {

/// One 01Mech frame without header and checksum (README.md#frames).
struct Frame {
    std::uint8_t to = 0;   ///< AndID
    std::uint8_t from = 0; ///< OndID
    std::uint8_t command = 0;
    std::uint8_t size = 0;
    std::array<std::uint8_t, mostData> data{};

    [[nodiscard]] std::span<const std::uint8_t> payload() const { return std::span(data).first(size); }
    [[nodiscard]] bool is(Command wanted) const { return command == static_cast<std::uint8_t>(wanted); }
    friend bool operator==(const Frame &a, const Frame &b)
    {
        return a.to == b.to && a.from == b.from && a.command == b.command && a.size == b.size
            && std::equal(a.payload().begin(), a.payload().end(), b.payload().begin());
    }
};

/// XOR of command, count and data. Header and node ids are not covered.
[[nodiscard]] std::uint8_t lrcOf(const Frame &frame);

/// UART, RS-485, RS-232: 55 AA AndID OndID cID bCnt data LRC.
[[nodiscard]] std::vector<std::uint8_t> uartBytes(const Frame &frame);

/// I2C (README.md#frames): AndID OndID cID bCnt data LRC, written to the slave address AndID. The datasheet's "without AndID" is wrong.
[[nodiscard]] std::vector<std::uint8_t> i2cBytes(const Frame &frame);
/// Nothing unless this is exactly one frame with the right checksum.
[[nodiscard]] std::optional<Frame> fromI2c(std::span<const std::uint8_t> bytes);

/// What some bytes begin with.
enum class Shape { Incomplete, Frame, Garbage };
[[nodiscard]] Shape shapeOf(std::span<const std::uint8_t> bytes);
/// The frame that some bytes begin with; only where shapeOf() says so.
[[nodiscard]] Frame frameIn(std::span<const std::uint8_t> bytes);

/// Finds frames in a stream of bytes, whatever precedes them: a candidate that turns out to be none costs its first byte
/// only, so a good frame inside or behind garbage is still found. Incomplete frames wait for more; forget() ends that when
/// the line fell silent.
class FrameReader {
public:
    using Sink = std::function<void(const Frame &)>;

    explicit FrameReader(Sink sink)
        : m_sink(std::move(sink))
    {
    }
    void feed(std::span<const std::uint8_t> bytes);
    void forget();
    [[nodiscard]] bool isEmpty() const { return m_size == 0; }
    /// Bytes that belonged to no frame.
    [[nodiscard]] std::uint64_t discarded() const { return m_discarded; }

private:
    void drop(std::size_t count);

    Sink m_sink;
    std::array<std::uint8_t, mostData + frameOverhead> m_buffer{};
    std::size_t m_size = 0;
    std::uint64_t m_discarded = 0;
};

} // namespace mb::supermodified
