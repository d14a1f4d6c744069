// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/console.h"
#include "wire/candumplog.h"

#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace mb::console {

/// Prints frames with what the families make of them: the lines of `decode`, and of `monitor --json`.
class FrameLines {
public:
    /// `dialect`: for families that have several, empty for their usual one.
    FrameLines(Console &console, std::string dialect);
    void print(Duration time, std::string_view link, const CanFrame &frame);
    /// Of a serial or SPI link: one line for each frame that is complete, so bytes may wait for the rest of theirs.
    void print(Duration time, std::string_view link, Direction direction, std::span<const std::uint8_t> bytes);
    /// Nothing more comes: prints the bytes that still waited.
    void finish();

private:
    /// What passed one link, read by every family that speaks in bytes. A frame is printed whoever finds it; what is none
    /// only once, as the family sees it that found something last.
    struct Stream {
        std::vector<std::unique_ptr<ByteDecoder>> decoders;
        std::size_t leading = 0;
    };
    [[nodiscard]] Stream &streamOf(std::string_view link);
    void print(std::string_view link, Stream &stream, std::size_t decoder, const std::vector<DecodedBytes> &found);
    void print(std::string_view link, const DecodedBytes &bytes);
    [[nodiscard]] std::optional<DecodedFrame> decode(const CanFrame &frame) const;
    void printJson(
        Duration time, std::string_view link, const CanFrame &frame, const std::optional<DecodedFrame> &decoded);
    void printText(
        Duration time, std::string_view link, const CanFrame &frame, const std::optional<DecodedFrame> &decoded);

    Console &m_console;
    std::string m_dialect;
    std::map<std::string, Stream, std::less<>> m_streams;
};

/// Of --dialect: empty, or one that some family speaks.
[[nodiscard]] Result<void> checkDialect(const Console &console, const std::string &dialect);

} // namespace mb::console
