// SPDX-License-Identifier: GPL-3.0-or-later
#include "wire/candumplog.h"

#include "wire/decimaltime.h"

#include <algorithm>
#include <cctype>

namespace mb {
namespace {

constexpr std::string_view blanks = " \t";
constexpr std::size_t mostFdBytes = 64;
constexpr std::size_t secondDigits = 10; // zeros in front, as candump does

/// Takes the first word off `rest`, blanks before it passed over.
std::string_view takeWord(std::string_view &rest)
{
    rest.remove_prefix(std::min(rest.size(), rest.find_first_not_of(blanks)));
    const std::string_view word = rest.substr(0, rest.find_first_of(blanks));
    rest.remove_prefix(word.size());
    return word;
}

/// The parts of a line, not looked into.
struct Parts {
    Duration time{};
    std::string_view link;
    std::string_view frame;
    std::string_view direction;
};

std::optional<Parts> partsOf(std::string_view text)
{
    if (const auto end = text.find_last_not_of(" \t\r\n"); end != std::string_view::npos)
        text = text.substr(0, end + 1);
    const auto close = text.find(") ");
    if (close == std::string_view::npos || text.front() != '(')
        return std::nullopt;
    const auto time = parseSeconds(text.substr(1, close - 1));
    std::string_view rest = text.substr(close + 1);
    Parts parts;
    parts.link = takeWord(rest);
    parts.frame = takeWord(rest);
    parts.direction = takeWord(rest);
    const bool printable = std::ranges::none_of(parts.link, [](unsigned char c) { return c < 0x20 || c == 0x7F; });
    const bool known = parts.direction.empty() || parts.direction == "R" || parts.direction == "T";
    if (!time || !printable || !rest.empty() || !known)
        return std::nullopt;
    parts.time = *time;
    return parts;
}

bool isHex(std::string_view text)
{
    return std::ranges::all_of(text, [](unsigned char c) { return std::isxdigit(c) != 0; });
}

} // namespace

std::optional<CandumpLine> parseCandumpLine(std::string_view text)
{
    const auto parts = partsOf(text);
    const auto frame = parts ? canFrameFromText(parts->frame) : std::nullopt;
    if (!frame)
        return std::nullopt;
    return CandumpLine{parts->time, std::string(parts->link), *frame,
        parts->direction.empty()      ? LogDirection::Unknown
            : parts->direction == "R" ? LogDirection::Received
                                      : LogDirection::Sent};
}

bool isCandumpFdLine(std::string_view text)
{
    const auto parts = partsOf(text);
    const auto mark = parts ? parts->frame.find("##") : std::string_view::npos;
    if (mark != 3 && mark != 8) // digits of an identifier
        return false;
    const std::string_view flagsAndData = parts->frame.substr(mark + 2);
    return isHex(parts->frame.substr(0, mark)) && isHex(flagsAndData) && flagsAndData.size() % 2 == 1
        && flagsAndData.size() <= 1 + 2 * mostFdBytes;
}

std::string toCandumpLine(Duration time, std::string_view link, const CanFrame &frame)
{
    std::string line;
    line.reserve(64 + link.size());
    line += '(';
    appendSeconds(line, time, secondDigits, '0');
    line += ") ";
    line += link;
    line += ' ';
    line += toText(frame);
    return line;
}

std::string toCandumpLine(const CandumpLine &line)
{
    std::string text = toCandumpLine(line.time, line.link, line.frame);
    if (line.direction != LogDirection::Unknown)
        text += line.direction == LogDirection::Sent ? " T" : " R";
    return text;
}

} // namespace mb
