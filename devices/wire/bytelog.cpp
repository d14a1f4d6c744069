// SPDX-License-Identifier: GPL-3.0-or-later
#include "wire/bytelog.h"

#include "wire/decimaltime.h"

#include <algorithm>

namespace mb {
namespace {

constexpr std::string_view blanks = " \t\r\n";
constexpr std::string_view digits = "0123456789ABCDEF";
constexpr std::size_t secondDigits = 10;

std::string_view takeWord(std::string_view &rest)
{
    rest.remove_prefix(std::min(rest.size(), rest.find_first_not_of(blanks)));
    const std::string_view word = rest.substr(0, rest.find_first_of(blanks));
    rest.remove_prefix(word.size());
    return word;
}

int digitOf(char c)
{
    if (c >= 'a' && c <= 'f')
        c = static_cast<char>(c - 'a' + 'A');
    const auto place = digits.find(c);
    return place == std::string_view::npos ? -1 : static_cast<int>(place);
}

bool appendBytes(std::string_view word, std::vector<std::uint8_t> &out)
{
    if (word.size() % 2 != 0)
        return false;
    for (std::size_t i = 0; i < word.size(); i += 2) {
        const int high = digitOf(word[i]);
        const int low = digitOf(word[i + 1]);
        if (high < 0 || low < 0)
            return false;
        out.push_back(static_cast<std::uint8_t>(high * 16 + low));
    }
    return true;
}

} // namespace

std::optional<LoggedBytes> parseByteLine(std::string_view text)
{
    const auto close = text.find(") ");
    if (close == std::string_view::npos || text.front() != '(')
        return std::nullopt;
    const auto time = parseSeconds(text.substr(1, close - 1));
    std::string_view rest = text.substr(close + 1);
    const std::string_view link = takeWord(rest);
    const std::string_view direction = takeWord(rest);
    const bool printable = std::ranges::none_of(link, [](unsigned char c) { return c < 0x20 || c == 0x7F; });
    if (!time || !printable || (direction != "tx" && direction != "rx"))
        return std::nullopt;
    LoggedBytes line{*time, std::string(link), direction == "tx" ? LogDirection::Sent : LogDirection::Received, {}};
    for (auto word = takeWord(rest); !word.empty(); word = takeWord(rest)) {
        if (!appendBytes(word, line.bytes))
            return std::nullopt;
    }
    return line.bytes.empty() ? std::nullopt : std::optional(std::move(line));
}

std::string toByteLine(
    Duration time, std::string_view link, LogDirection direction, std::span<const std::uint8_t> bytes)
{
    std::string line = "(";
    appendSeconds(line, time, secondDigits, '0');
    line += ") ";
    line += link;
    line += direction == LogDirection::Sent ? " tx " : " rx ";
    line += toHexText(bytes);
    return line;
}

std::string toHexText(std::span<const std::uint8_t> bytes)
{
    std::string text;
    text.reserve(bytes.size() * 2);
    for (const std::uint8_t byte : bytes) {
        text += digits[byte >> 4U];
        text += digits[byte & 0xFU];
    }
    return text;
}

} // namespace mb
