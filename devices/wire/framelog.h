// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wire/asclog.h"
#include "wire/candumplog.h"

namespace mb {

enum class LogFormat { Candump, Asc };

/// By the ending: `.asc` is Vector ASC, everything else candump.
[[nodiscard]] LogFormat formatOfName(std::string_view fileName);

/// Reads a log line by line, whichever of the two it is: its first line that is not blank decides. A value: a copy goes on
/// from the line that the original stood at.
class FrameLogParser {
public:
    static constexpr std::size_t longestLine = 4096; ///< bytes; what is longer is no line of a log

    /// Nothing when there is no frame in the line. OutOfRange for a malformed line: its number, what is wrong, how such
    /// a line reads.
    [[nodiscard]] Result<std::optional<LoggedFrame>> parse(std::string_view line);
    /// The same of a last line that has no end: whoever wrote the log may have been interrupted. One that cannot be read is left
    /// out then, unless there is no other, or it cannot be the beginning of a line.
    [[nodiscard]] Result<std::optional<LoggedFrame>> parseLast(std::string_view line);
    /// The last line was something else than a frame, and has no end.
    void leaveOpen() { m_end = End::Open; }
    /// What of the log is left out, or may not be whole, for people; empty: nothing.
    [[nodiscard]] Message remark() const;
    /// The same error for the line after the last one.
    [[nodiscard]] Error tooLong() const { return malformed(m_lines + 1); }
    /// Known from the first line that is not blank.
    [[nodiscard]] std::optional<LogFormat> format() const { return m_format; }
    [[nodiscard]] std::uint64_t lines() const { return m_lines; }

private:
    [[nodiscard]] Error malformed(std::uint64_t line, const Message &cause = {}) const;

    enum class End { Whole, Open, Cut };

    std::uint64_t m_lines = 0;
    std::uint64_t m_fdFrames = 0; ///< of candump
    End m_end = End::Whole;
    std::optional<LogFormat> m_format;
    AscParser m_asc;
};

/// Writes a log in either format.
class FrameLogWriter {
public:
    explicit FrameLogWriter(LogFormat format)
        : m_format(format)
    {
    }
    /// Appends the frame, line end included.
    void write(const LoggedFrame &frame, std::string &out);
    /// Appends what ends the log.
    void finish(std::string &out) const;

private:
    LogFormat m_format;
    AscWriter m_asc;
};

} // namespace mb
