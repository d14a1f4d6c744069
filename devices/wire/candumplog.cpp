// SPDX-License-Identifier: GPL-3.0-or-later
#include "wire/candumplog.h"

#include "wire/decimaltime.h"

#include <algorithm>

namespace mb {
namespace {

constexpr std::string_view blanks = " \t";
constexpr std::size_t secondDigits = 10; // zeros in front, as candump does

/// Takes the first word off `rest`, blanks before it passed over.
std::string_view takeWord(std::string_view &rest)
{
    rest.remove_prefix(std::min(rest.size(), rest.find_first_not_of(blanks)));
    const std::string_view word = rest.substr(0, rest.find_first_of(blanks));
    rest.remove_prefix(word.size());
    return word;
}

} // namespace

std::optional<CandumpLine> parseCandumpLine(std::string_view text)
{
    if (const auto end = text.find_last_not_of(" \t\r\n"); end != std::string_view::npos)
        text = text.substr(0, end + 1);
    const auto close = text.find(") ");
    if (close == std::string_view::npos || text.front() != '(')
        return std::nullopt;
    const auto time = parseSeconds(text.substr(1, close - 1));
    std::string_view rest = text.substr(close + 1);
    const std::string_view link = takeWord(rest);
    const auto frame = canFrameFromText(takeWord(rest));
    const std::string_view direction = takeWord(rest);
    const bool printable
        = std::none_of(link.begin(), link.end(), [](unsigned char c) { return c < 0x20 || c == 0x7F; });
    if (!time || !frame || !printable || !rest.empty() || (!direction.empty() && direction != "R" && direction != "T"))
        return std::nullopt;
    return CandumpLine{*time, std::string(link), *frame,
        direction.empty()      ? LogDirection::Unknown
            : direction == "R" ? LogDirection::Received
                               : LogDirection::Sent};
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
