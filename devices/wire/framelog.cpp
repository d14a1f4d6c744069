// SPDX-License-Identifier: GPL-3.0-or-later
#include "wire/framelog.h"

#include <algorithm>

namespace mb {
namespace {

constexpr std::string_view example = "; such a line reads (1436509052.249713) can0 044#2A366C2B";
constexpr std::string_view ascExample = "; such a line reads 0.249713 1 44 Rx d 4 2A 36 6C 2B";
constexpr std::string_view blfMagic = "LOGG";
constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";

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

Error FrameLogParser::malformed(std::uint64_t line, std::string_view cause) const
{
    std::string text = "line " + std::to_string(line);
    if (!m_format)
        text += " is neither a line of candump -L nor the beginning of a Vector ASC log";
    else
        text += *m_format == LogFormat::Candump ? " is not a line of candump -L" : " is not a line of a Vector ASC log";
    if (!cause.empty())
        text += ": " + std::string(cause);
    text += m_format == LogFormat::Asc ? ascExample : example;
    return Error::fromPhrase(Fault::OutOfRange, text);
}

Error FrameLogParser::tooLong() const
{
    return malformed(m_lines + 1);
}

Result<std::optional<LoggedFrame>> FrameLogParser::parse(std::string_view line)
{
    ++m_lines;
    if (m_lines == 1 && line.starts_with(byteOrderMark))
        line.remove_prefix(byteOrderMark.size());
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
            return fail(Fault::OutOfRange, "it is a Vector BLF log", "save it as ASC and take that");
        else
            return fail(malformed(m_lines));
    }
    if (*m_format == LogFormat::Candump) {
        auto frame = parseCandumpLine(line);
        if (!frame)
            return fail(malformed(m_lines));
        return frame;
    }
    auto parsed = m_asc.parse(line);
    if (!parsed)
        return fail(malformed(m_lines, parsed.error().detail));
    return parsed;
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
