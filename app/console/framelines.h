// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/console.h"
#include "wire/candumplog.h"

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace mb::console {

/// Prints frames with what the families make of them: the lines of `decode`, and of `monitor --json`.
class FrameLines {
public:
    /// `dialect`: for families that have several, empty for their usual one. `kind` of the links, when it is known: a log does not
    /// say whether its bytes passed a serial line or SPI.
    FrameLines(Console &console, std::string dialect, std::optional<LinkKind> kind = {});
    void print(Duration time, std::string_view link, const CanFrame &frame);
    /// Of a serial or SPI link: one line for each frame that is complete, so bytes may wait for the rest of theirs, and the first
    /// ones until it shows which family speaks there.
    void print(Duration time, std::string_view link, Direction direction, std::span<const std::uint8_t> bytes);
    /// Nothing more comes: prints the bytes that still waited.
    void finish();

private:
    struct Reading {
        std::unique_ptr<ByteDecoder> decoder;
        std::vector<DecodedBytes> found; ///< not printed yet
    };
    /// What passed one link, as every family reads it that speaks in bytes. The first that finds a frame is the one that is printed.
    struct Stream {
        std::vector<Reading> readings;
        std::optional<std::size_t> chosen;
        std::size_t undecided = 0; ///< bytes
    };
    [[nodiscard]] Stream &streamOf(std::string_view link);
    void flush(std::string_view link, Stream &stream, bool now);
    void print(std::string_view link, const DecodedBytes &bytes);
    [[nodiscard]] std::optional<DecodedFrame> decode(std::string_view link, const CanFrame &frame);
    [[nodiscard]] std::vector<CanDecoder> decoders() const;
    void printJson(
        Duration time, std::string_view link, const CanFrame &frame, const std::optional<DecodedFrame> &decoded);
    void printText(
        Duration time, std::string_view link, const CanFrame &frame, const std::optional<DecodedFrame> &decoded);

    Console &m_console;
    std::string m_dialect;
    std::optional<LinkKind> m_kind;
    std::map<std::string, Stream, std::less<>> m_streams;
    std::map<std::string, std::vector<CanDecoder>, std::less<>> m_buses;
};

/// Help of --dialect: the families that have any, with theirs.
[[nodiscard]] std::string dialectHelp();
/// Of --dialect: empty, or one that some family speaks.
[[nodiscard]] Result<void> checkDialect(const Console &console, const std::string &dialect);

} // namespace mb::console
