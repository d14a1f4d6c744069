// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/result.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace mb {

/// The bytes of a firmware file by their address, gaps included: what is not in the file is absent, not 0xFF.
/// Addresses are those of the file (bytes, 32 bits). A plain value: copy and share between threads as you like.
class FirmwareImage {
public:
    /// Neighbouring bytes without a gap. Both addresses belong to it, so that one can end at 0xFFFFFFFF.
    struct Segment {
        std::uint32_t first = 0;
        std::uint32_t last = 0;
        std::size_t offset = 0; ///< where its bytes begin in storage, see bytes()

        [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(last - first) + 1; }
    };

    static constexpr std::size_t maxTextSize = std::size_t{16} << 20U;

    /// Nothing in it.
    FirmwareImage() = default;

    /// Reads Intel HEX: record types 00 to 05, lines ended by LF, CRLF or CR, digits of either case; blanks at the end
    /// of a line, empty lines and a UTF-8 byte order mark are passed over. Bytes given twice must be equal. Everything
    /// else is Fault::OutOfRange with line and cause, `line 12: checksum is 0x3A, 0x3B is needed`; so is a file without
    /// data or without an end-of-file record, and a text of more than maxTextSize bytes (that one without a line).
    [[nodiscard]] static Result<FirmwareImage> fromIntelHex(std::string_view text);

    [[nodiscard]] bool has(std::uint32_t address) const { return hasAny(address, address); }
    [[nodiscard]] std::optional<std::uint8_t> at(std::uint32_t address) const;
    /// True when a byte from `first` to `last`, both included, is present.
    [[nodiscard]] bool hasAny(std::uint32_t first, std::uint32_t last) const;
    /// Writes the bytes that are present from address `from` on into `out` and leaves its others alone.
    void overlay(std::uint32_t from, std::span<std::uint8_t> out) const;

    [[nodiscard]] std::size_t byteCount() const { return m_bytes.size(); }
    /// How many bytes are present from `first` to `last`, both included.
    [[nodiscard]] std::size_t byteCount(std::uint32_t first, std::uint32_t last) const;
    /// In ascending order, never touching each other.
    [[nodiscard]] const std::vector<Segment> &segments() const { return m_segments; }
    /// The bytes of one of segments(); valid as long as the image.
    [[nodiscard]] std::span<const std::uint8_t> bytes(const Segment &segment) const
    {
        return std::span(m_bytes).subspan(segment.offset, segment.size());
    }

    /// The lines of the file as they were read, without blanks at their ends and without empty ones: for bootloaders that
    /// want the text itself.
    [[nodiscard]] const std::vector<std::string> &lines() const { return m_lines; }

private:
    friend class IntelHexReader;
    void keepLines(std::string_view text);
    [[nodiscard]] std::vector<Segment>::const_iterator firstReaching(std::uint32_t address) const;

    std::vector<Segment> m_segments;
    std::vector<std::uint8_t> m_bytes; ///< of all segments, in their order
    std::vector<std::string> m_lines;
};

} // namespace mb
