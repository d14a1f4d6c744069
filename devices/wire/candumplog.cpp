// SPDX-License-Identifier: GPL-3.0-or-later
#include "wire/candumplog.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdint>

namespace mb {
namespace {

constexpr std::string_view blanks = " \t";
constexpr std::size_t secondDigits = 10; // zeros in front, as candump does
constexpr std::size_t maxFraction = 9;   // digits of a nanosecond
constexpr std::int64_t maxSeconds = std::chrono::duration_cast<std::chrono::seconds>(Duration::max()).count() - 1;

std::optional<std::int64_t> number(std::string_view digits)
{
    std::uint64_t value = 0;
    const char *end = digits.data() + digits.size();
    const auto parsed = std::from_chars(digits.data(), end, value);
    if (digits.empty() || parsed.ec != std::errc{} || parsed.ptr != end || value > std::uint64_t{maxSeconds})
        return std::nullopt;
    return static_cast<std::int64_t>(value);
}

std::optional<Duration> timeFrom(std::string_view text)
{
    const auto point = text.find('.');
    if (point == std::string_view::npos)
        return std::nullopt;
    const std::string_view fraction = text.substr(point + 1);
    const auto seconds = number(text.substr(0, point));
    auto nanoseconds = number(fraction);
    if (!seconds || !nanoseconds || fraction.size() > maxFraction)
        return std::nullopt;
    for (std::size_t i = fraction.size(); i < maxFraction; ++i)
        *nanoseconds *= 10;
    return std::chrono::seconds(*seconds) + std::chrono::nanoseconds(*nanoseconds);
}

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
    const auto time = timeFrom(text.substr(1, close - 1));
    std::string_view rest = text.substr(close + 1);
    const std::string_view link = takeWord(rest);
    const auto frame = canFrameFromText(takeWord(rest));
    const std::string_view direction = takeWord(rest);
    const bool printable
        = std::none_of(link.begin(), link.end(), [](unsigned char c) { return c < 0x20 || c == 0x7F; });
    if (!time || !frame || !printable || !rest.empty() || (!direction.empty() && direction != "R" && direction != "T"))
        return std::nullopt;
    return CandumpLine{*time, std::string(link), *frame};
}

std::string toCandumpLine(Duration time, std::string_view link, const CanFrame &frame)
{
    const auto microseconds
        = std::chrono::duration_cast<std::chrono::microseconds>(std::max(time, Duration::zero())).count();
    const std::string seconds = std::to_string(microseconds / 1'000'000);
    const std::string fraction = std::to_string(microseconds % 1'000'000);
    std::string line;
    line.reserve(64 + link.size());
    line += '(';
    line.append(seconds.size() < secondDigits ? secondDigits - seconds.size() : 0, '0');
    line += seconds;
    line += '.';
    line.append(6 - fraction.size(), '0');
    line += fraction;
    line += ") ";
    line += link;
    line += ' ';
    line += toText(frame);
    return line;
}

std::string toCandumpLine(const CandumpLine &line)
{
    return toCandumpLine(line.time, line.link, line.frame);
}

} // namespace mb
