// SPDX-License-Identifier: GPL-3.0-or-later
#include "wire/decimaltime.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>

namespace mb {
namespace {

constexpr std::size_t maxFraction = 9; // digits of a nanosecond
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

} // namespace

std::optional<Duration> parseSeconds(std::string_view text)
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

void appendSeconds(std::string &out, Duration time, std::size_t digits, char fill)
{
    const auto microseconds
        = std::chrono::duration_cast<std::chrono::microseconds>(std::max(time, Duration::zero())).count();
    std::array<char, 24> text{};
    const auto append = [&](std::int64_t value, std::size_t places, char with) {
        const char *end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
        const auto size = static_cast<std::size_t>(end - text.data());
        out.append(size < places ? places - size : 0, with);
        out.append(text.data(), size);
    };
    append(microseconds / 1'000'000, digits, fill);
    out += '.';
    append(microseconds % 1'000'000, 6, '0');
}

} // namespace mb
