// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <charconv>
#include <cmath>
#include <concepts>
#include <optional>
#include <string_view>

namespace mb {

/// The one reading of numbers in command lines, link addresses, options and files; scripts/lint refuses others above `wire`. What people type
/// into the window, comma and all, is `widgets/common/numberformat`.

/// Digits, with a minus where the type has one; nothing around them, and no more than the type holds.
template <std::integral Whole> [[nodiscard]] std::optional<Whole> wholeFrom(std::string_view text, int base = 10)
{
    Whole value{};
    const auto parsed = std::from_chars(text.data(), text.data() + text.size(), value, base);
    if (parsed.ec != std::errc{} || parsed.ptr != text.data() + text.size())
        return std::nullopt;
    return value;
}

/// Sign, digits, a dot, an exponent; finite, and nothing else around it. A comma is no number: 1,500 may mean two things.
[[nodiscard]] inline std::optional<double> numberFrom(std::string_view text)
{
    if (text.starts_with('+') && !text.starts_with("+-"))
        text.remove_prefix(1);
    double value = 0.0;
    const auto parsed = std::from_chars(text.data(), text.data() + text.size(), value);
    if (parsed.ec != std::errc{} || parsed.ptr != text.data() + text.size() || !std::isfinite(value))
        return std::nullopt;
    return value;
}

/// Both, for a place of a given type.
template <class Number> [[nodiscard]] bool takeNumber(std::string_view text, Number &out)
{
    if constexpr (std::is_floating_point_v<Number>) {
        const auto number = numberFrom(text);
        out = number.value_or(out);
        return number.has_value();
    } else {
        const auto number = wholeFrom<Number>(text);
        out = number.value_or(out);
        return number.has_value();
    }
}

} // namespace mb
