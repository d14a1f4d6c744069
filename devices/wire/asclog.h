// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/result.h"
#include "wire/loggedframe.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mb {

/// Reads Vector's ASC text line by line: header (`date`, `base hex|dec`, `timestamps absolute|relative`), classic CAN
/// frames (`0.0010 1 2061405x Rx d 8 00 …`, remote ones with `r`), error frames. What else a bus log has (start of
/// measurement, statistics, other buses, environment variables) is passed over.
///
/// Times are those of the frames since 1970 when the `date` line is one that we can read, taken as UTC (the format has
/// no time zone), else since the start of the measurement. Channel N is the link `chN`, unless the log is ours: AscWriter
/// leaves comments with the exact start, the names and what else the format has no place for.
class AscParser {
public:
    /// Whether a log of this kind may begin with this line.
    [[nodiscard]] static bool begins(std::string_view line);

    /// Nothing when the line has no frame in it. OutOfRange for a malformed one, a frame with a name in the place of its
    /// identifier: what is wrong, in one clause.
    [[nodiscard]] Result<std::optional<LoggedFrame>> parse(std::string_view line);
    /// CAN FD frames so far, in which it looks for nothing.
    [[nodiscard]] std::uint64_t fdFrames() const { return m_fdFrames; }

private:
    struct Words;
    Result<void> readBase(Words words);
    void readComment(std::string_view comment);
    Result<void> readTime(std::string_view time);
    Result<std::optional<LoggedFrame>> readEvent(std::string_view time, Words words);
    static LoggedFrame readErrorFrame(Words ours);
    Result<LoggedFrame> readFrame(std::string_view id, std::string_view direction, Words words) const;
    Result<void> readBytes(Words words, CanFrame &frame) const;
    [[nodiscard]] std::string nameOf(std::uint64_t channel) const;

    bool m_hex = true;
    bool m_relative = false;
    bool m_directions = true; ///< Rx and Tx tell who sent it
    std::uint64_t m_fdFrames = 0;
    Duration m_start{};
    Duration m_last{};                ///< of the event before, since the start
    std::vector<std::string> m_names; ///< of channel 1, 2, … where the log tells
};

/// Writes the same: `base hex timestamps absolute`, microseconds. What AscParser reads from it is what was written, to
/// the microsecond.
class AscWriter {
public:
    /// Appends the frame; the header before the first one.
    void write(const LoggedFrame &frame, std::string &out);
    /// Appends what ends a log.
    void finish(std::string &out) const;

private:
    void begin(Duration start, std::string &out);
    [[nodiscard]] std::size_t channelOf(const std::string &link, std::string &out);

    bool m_begun = false;
    bool m_directions = true;
    Duration m_start{};
    std::vector<std::string> m_names;
};

} // namespace mb
