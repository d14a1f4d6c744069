// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/parameter.h"

#include "wire/fixedpoint.h"
#include "wire/number.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace mb {
namespace {

/// Of 32 bits.
std::optional<double> hexadecimalFrom(std::string_view text)
{
    if (!text.starts_with("0x") && !text.starts_with("0X"))
        return std::nullopt;
    const auto value = wholeFrom<std::uint32_t>(text.substr(2), 16);
    return value ? std::optional<double>(*value) : std::nullopt;
}

std::string trimmed(std::string_view text)
{
    const auto first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos)
        return {};
    return std::string(text.substr(first, text.find_last_not_of(" \t") - first + 1));
}

std::string rangeText(const Parameter &p)
{
    const std::string unit = p.unit.empty() ? std::string() : ' ' + std::string(p.unit);
    return numberText(p.minimum) + " … " + numberText(p.maximum) + unit;
}

} // namespace

std::optional<ParameterIndex> findParameter(std::span<const Parameter> table, std::string_view key)
{
    const auto found = std::ranges::find(table, key, &Parameter::key);
    if (found == table.end())
        return std::nullopt;
    return ParameterIndex{static_cast<std::uint16_t>(found - table.begin())};
}

std::string_view typeName(const Parameter &parameter)
{
    switch (parameter.type) {
    case WireType::Boolean: return "boolean";
    case WireType::Flags32:
    case WireType::Flags64: return "flags";
    case WireType::Fixed16x16: return "number";
    default: return parameter.one == 1.0 ? "integer" : "number";
    }
}

Value toValue(const Parameter &parameter, std::int64_t raw)
{
    if (parameter.type == WireType::Boolean)
        return raw != 0;
    return fromFixed(raw, parameter.one);
}

Result<std::int64_t> toRaw(const Parameter &parameter, double number)
{
    const std::string key(parameter.key);
    if (!std::isfinite(number))
        return fail(Fault::OutOfRange, say("%1 needs a number", key));
    if (number > parameter.maximum)
        return fail(Fault::OutOfRange, say("%1: %2 is above %3", key, number, parameter.maximum),
            say("legal is %1", rangeText(parameter)));
    if (number < parameter.minimum)
        return fail(Fault::OutOfRange, say("%1: %2 is below %3", key, number, parameter.minimum),
            say("legal is %1", rangeText(parameter)));
    if (parameter.one == 1.0 && number != std::floor(number))
        return fail(Fault::OutOfRange, say("%1: %2 is not a whole number", key, number),
            say("legal is %1", rangeText(parameter)));
    const RawRange wire = rangeOf(parameter.type);
    return std::clamp(toFixed(number, parameter.one), wire.low, wire.high);
}

bool isLegal(const Parameter &parameter, std::int64_t raw)
{
    const auto number = static_cast<double>(raw);
    return number >= parameter.minimum * parameter.one - 0.5 && number <= parameter.maximum * parameter.one + 0.5;
}

namespace {

Result<std::int64_t> parseSwitch(const Parameter &parameter, std::string word)
{
    std::transform(word.begin(), word.end(), word.begin(),
        [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    if (word == "on" || word == "true" || word == "yes" || word == "1")
        return 1;
    if (word == "off" || word == "false" || word == "no" || word == "0")
        return 0;
    return fail(Fault::OutOfRange, say("%1: '%2' is neither on nor off", parameter.key, word), say("write on or off"));
}

} // namespace

Result<std::int64_t> parseRaw(const Parameter &parameter, std::string_view text)
{
    const std::string word = trimmed(text);
    for (const Choice &choice : parameter.choices) {
        if (choice.label == word)
            return choice.raw;
    }
    if (parameter.type == WireType::Boolean)
        return parseSwitch(parameter, word);
    const auto hexadecimal = hexadecimalFrom(word);
    const auto number = hexadecimal ? hexadecimal : numberFrom(word);
    if (!number)
        return fail(Fault::OutOfRange, say("%1: '%2' is not a number", parameter.key, word),
            word.find(',') == std::string::npos ? say("write it like 2.5")
                                                : say("write it with a dot, like 1.5, and no comma"));
    return toRaw(parameter, *number);
}

std::string toText(const Parameter &parameter, std::int64_t raw)
{
    if (parameter.type == WireType::Boolean)
        return raw != 0 ? "on" : "off";
    const double value = fromFixed(raw, parameter.one);
    if (parameter.one == 1.0)
        return numberText(value);
    std::array<char, 64> buffer{};
    for (int digits = 0; digits < 12; ++digits) {
        const auto end
            = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, digits);
        const double back
            = numberFrom({buffer.data(), static_cast<std::size_t>(end.ptr - buffer.data())}).value_or(0.0);
        if (toFixed(back, parameter.one) == raw)
            return numberText(back);
    }
    return numberText(value);
}

std::string shownText(const Parameter &parameter, std::int64_t raw)
{
    constexpr int gainDigits = 4;
    std::string text = toText(parameter, raw);
    if (!isGain(parameter) || parameter.one == 1.0 || raw == 0)
        return text;
    const double value = fromFixed(raw, parameter.one);
    const int decimals = std::max(0, gainDigits - 1 - static_cast<int>(std::floor(std::log10(std::abs(value)))));
    std::array<char, 64> buffer{};
    const auto end
        = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, decimals);
    std::string four(buffer.data(), end.ptr);
    const auto back = numberFrom(four);
    return back && toFixed(*back, parameter.one) == raw ? four : text;
}

} // namespace mb
