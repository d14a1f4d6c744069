// SPDX-License-Identifier: GPL-3.0-or-later
#include "wire/framelog.h"

#include "wire/byteordermark.h"

#include <algorithm>

namespace mb {
namespace {

constexpr std::string_view example = "(1436509052.249713) can0 044#2A366C2B";
constexpr std::string_view ascExample = "0.249713 1 44 Rx d 4 2A 36 6C 2B";
constexpr std::string_view blfMagic = "LOGG";

} // namespace

LogFormat formatOfName(std::string_view fileName)
{
    constexpr std::string_view ending = ".asc";
    const auto same = [](char a, char b) { return (a >= 'A' && a <= 'Z' ? static_cast<char>(a + 32) : a) == b; };
    return fileName.size() >= ending.size()
            && std::equal(ending.begin(), ending.end(), fileName.end() - ending.size(),
                [&](char lower, char any) { return same(any, lower); })
        ? LogFormat::Asc
        : LogFormat::Candump;
}

Error FrameLogParser::malformed(std::uint64_t line, const Message &cause) const
{
    Message what = !m_format
        ? say("line %1 is neither a line of candump -L nor the beginning of a Vector ASC log", line)
        : *m_format == LogFormat::Candump ? say("line %1 is not a line of candump -L", line)
                                          : say("line %1 is not a line of a Vector ASC log", line);
    if (!cause.empty())
        what = say("%1: %2", what, cause);
    return {Fault::OutOfRange, std::move(what),
        say("such a line reads %1", m_format == LogFormat::Asc ? ascExample : example)};
}

Result<std::optional<LoggedFrame>> FrameLogParser::parse(std::string_view line)
{
    ++m_lines;
    if (m_lines == 1)
        line = withoutByteOrderMark(line);
    if (line.find_first_not_of(" \t\r\n") == std::string_view::npos)
        return std::optional<LoggedFrame>();
    if (line.size() > longestLine)
        return fail(malformed(m_lines));
    if (!m_format) {
        if (line.front() == '(')
            m_format = LogFormat::Candump;
        else if (AscParser::begins(line))
            m_format = LogFormat::Asc;
        else if (line.starts_with(blfMagic))
            return fail(Fault::OutOfRange, say("it is a Vector BLF log"), say("save it as ASC and take that"));
        else
            return fail(malformed(m_lines));
    }
    if (*m_format == LogFormat::Candump) {
        auto frame = parseCandumpLine(line);
        if (!frame && !isCandumpFdLine(line))
            return fail(malformed(m_lines));
        m_fdFrames += frame ? 0U : 1U;
        return frame;
    }
    auto parsed = m_asc.parse(line);
    if (!parsed)
        return fail(malformed(m_lines, parsed.error().detail));
    return parsed;
}

Result<std::optional<LoggedFrame>> FrameLogParser::parseLast(std::string_view line)
{
    const std::uint64_t fdFrames = m_fdFrames;
    auto parsed = parse(line);
    const bool mayBeOne = m_format != LogFormat::Candump || line.starts_with('(');
    if (!parsed && m_lines > 1 && mayBeOne) {
        m_end = End::Cut;
        return std::optional<LoggedFrame>();
    }
    const bool hasFrame = parsed && (*parsed || m_fdFrames > fdFrames);
    const bool tellsDirection = parsed && *parsed && (*parsed)->direction != LogDirection::Unknown;
    if (hasFrame && !tellsDirection && m_format == LogFormat::Candump) // which counts no bytes
        m_end = End::Open;
    return parsed;
}

Message FrameLogParser::remark() const
{
    Message end;
    if (m_end == End::Cut)
        end = say("the last line is cut off, and left out");
    else if (m_end == End::Open)
        end = say("the last line has no end, so its frame may be cut short");
    Message left;
    if (const std::uint64_t count = m_fdFrames + m_asc.fdFrames(); count > 0)
        left = count == 1 ? say("1 CAN FD frame is left out, because only classic CAN is read")
                          : say("%1 CAN FD frames are left out, because only classic CAN is read", count);
    return joined(left, end);
}

void FrameLogWriter::write(const LoggedFrame &frame, std::string &out)
{
    if (m_format == LogFormat::Asc) {
        m_asc.write(frame, out);
        return;
    }
    out += toCandumpLine(frame);
    out += '\n';
}

void FrameLogWriter::finish(std::string &out) const
{
    if (m_format == LogFormat::Asc)
        m_asc.finish(out);
}

} // namespace mb
