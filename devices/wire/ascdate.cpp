// SPDX-License-Identifier: GPL-3.0-or-later
#include "wire/ascdate.h"

#include "wire/decimaltime.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <vector>

namespace mb {
namespace {

constexpr std::array<const char *, 12> months{
    "Jan", "Feb", "Mar", "Apr", "May", "Jun", "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"};
constexpr std::array<const char *, 7> weekdays{"Sun", "Mon", "Tue", "Wed", "Thu", "Fri", "Sat"};
constexpr std::array<std::pair<std::string_view, unsigned>, 7> german{
    {{"M\xE4r", 3}, {"M\xC3\xA4r", 3}, {"Mrz", 3}, {"Mai", 5}, {"Okt", 10}, {"Dez", 12}, {"Sept", 9}}};

std::optional<int> number(std::string_view text)
{
    int value = 0;
    const char *end = text.data() + text.size();
    const auto parsed = std::from_chars(text.data(), end, value);
    if (text.empty() || text.front() == '-' || parsed.ec != std::errc{} || parsed.ptr != end)
        return std::nullopt;
    return value;
}

std::optional<unsigned> monthOf(std::string_view name)
{
    for (unsigned i = 0; i < months.size(); ++i) {
        if (name == months[i])
            return i + 1;
    }
    const auto known = std::ranges::find_if(german, [&](const auto &entry) { return entry.first == name; });
    return known == german.end() ? std::nullopt : std::optional(known->second);
}

/// `15:06:13.191`
std::optional<Duration> timeOfDay(std::string_view text, std::string_view half)
{
    if (text.size() < 8 || text[2] != ':' || text[5] != ':')
        return std::nullopt;
    auto hours = number(text.substr(0, 2));
    const auto minutes = number(text.substr(3, 2));
    const bool whole = text.find('.') == std::string_view::npos;
    const auto seconds = parseSeconds(std::string(text.substr(6)) + (whole ? ".0" : ""));
    if (!hours || !minutes || !seconds || *hours > 23 || *minutes > 59 || *seconds >= std::chrono::seconds(61))
        return std::nullopt;
    if (!half.empty())
        hours = *hours % 12 + (half == "pm" ? 12 : 0);
    return std::chrono::hours(*hours) + std::chrono::minutes(*minutes) + *seconds;
}

std::vector<std::string_view> wordsOf(std::string_view text)
{
    std::vector<std::string_view> words;
    while (words.size() < 8) {
        text.remove_prefix(std::min(text.size(), text.find_first_not_of(" \t\r\n")));
        if (text.empty())
            break;
        words.push_back(text.substr(0, text.find_first_of(" \t\r\n")));
        text.remove_prefix(words.back().size());
    }
    return words;
}

} // namespace

std::optional<Duration> unixTimeOfAscDate(std::string_view text)
{
    const std::vector<std::string_view> words = wordsOf(text);
    const bool halves = words.size() == 6 && (words[4] == "am" || words[4] == "pm");
    if (words.size() != 5 && !halves)
        return std::nullopt;
    const auto month = monthOf(words[1]);
    const auto day = number(words[2]);
    const auto time = timeOfDay(words[3], halves ? words[4] : std::string_view{});
    const auto year = number(words.back());
    if (!month || !day || !time || !year || *year < 1970 || *year > 2200)
        return std::nullopt;
    const std::chrono::year_month_day date{
        std::chrono::year(*year), std::chrono::month(*month), std::chrono::day(static_cast<unsigned>(*day))};
    if (!date.ok())
        return std::nullopt;
    return std::chrono::sys_days(date).time_since_epoch() + *time;
}

std::string toAscDate(Duration unixTime)
{
    const auto days = std::chrono::floor<std::chrono::days>(unixTime);
    const std::chrono::sys_days day{days};
    const std::chrono::year_month_day date{day};
    const std::chrono::weekday weekday{day};
    const auto ms = std::chrono::floor<std::chrono::milliseconds>(unixTime - days).count();
    std::array<char, 64> out{};
    std::snprintf(out.data(), out.size(), "%s %s %02u %02d:%02d:%02d.%03d %d", weekdays[weekday.c_encoding()],
        months[static_cast<unsigned>(date.month()) - 1], static_cast<unsigned>(date.day()),
        static_cast<int>(ms / 3'600'000), static_cast<int>(ms / 60'000 % 60), static_cast<int>(ms / 1000 % 60),
        static_cast<int>(ms % 1000), static_cast<int>(date.year()));
    return out.data();
}

} // namespace mb
