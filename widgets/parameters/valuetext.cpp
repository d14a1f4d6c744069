// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/valuetext.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/numberformat.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>

namespace mb {
namespace {

struct ValueText {
    Q_DECLARE_TR_FUNCTIONS(ValueText)
};

QString screen(std::string_view ascii)
{
    return localNumber(qt(ascii)).replace(QLatin1Char('-'), MinusSign);
}

QString number(double value)
{
    return screen(numberText(value));
}

std::string shortest(const Parameter &parameter, double value)
{
    const auto raw = toRaw(parameter, value);
    return raw ? shownText(parameter, *raw) : numberText(value);
}

int hexDigits(WireType type)
{
    switch (type) {
    case WireType::Boolean:
    case WireType::Uint8: return 2;
    case WireType::Int16:
    case WireType::Uint16: return 4;
    default: return 8;
    }
}

QString percentOf(const Parameter &parameter, double value)
{
    const auto full = fullScale(parameter);
    return full && value != 0.0
        ? QStringLiteral(" (%1)").arg(formatValue(value / *full * 100.0, 0, QStringLiteral("%")))
        : QString();
}

QString remedyFor(const Parameter &parameter)
{
    const QString range
        = number(parameter.minimum) + QStringLiteral(" … ") + screen(shortest(parameter, parameter.maximum));
    if (!fullScale(parameter))
        return ValueText::tr("Enter %1.").arg(range);
    const QString example = formatValue(parameter.maximum > 0 ? 55 : -55, 0, QStringLiteral("%"));
    return ValueText::tr("Enter %1, or a percentage such as %2.").arg(range, example);
}

/// A number that was understood, but is not legal.
ParsedValue refused(const Parameter &parameter, const QString &typed, double value)
{
    ParsedValue parsed;
    parsed.remedy = remedyFor(parameter);
    if (value > parameter.maximum) {
        const QString bound = screen(shortest(parameter, parameter.maximum)) + percentOf(parameter, parameter.maximum);
        parsed.fault = ValueText::tr("%1 is above %2.").arg(typed, bound);
    } else if (value < parameter.minimum) {
        const QString bound = number(parameter.minimum) + percentOf(parameter, parameter.minimum);
        parsed.fault = ValueText::tr("%1 is below %2.").arg(typed, bound);
    } else {
        parsed.fault = ValueText::tr("%1 is not a whole number.").arg(typed);
    }
    const double near
        = std::clamp(parameter.one == 1.0 ? std::round(value) : value, parameter.minimum, parameter.maximum);
    if (const auto raw = toRaw(parameter, near))
        parsed.nearest = *raw;
    return parsed;
}

ParsedValue notANumber(const Parameter &parameter, const QString &typed)
{
    ParsedValue parsed;
    parsed.remedy = remedyFor(parameter);
    parsed.fault
        = typed.isEmpty() ? ValueText::tr("A number is missing.") : ValueText::tr("“%1” is not a number.").arg(typed);
    return parsed;
}

ParsedValue legal(std::int64_t raw)
{
    ParsedValue parsed;
    parsed.raw = raw;
    return parsed;
}

} // namespace

QString valueText(const Parameter &parameter, std::int64_t raw)
{
    for (const Choice &choice : parameter.choices) {
        if (choice.raw == raw)
            return tableText(choice.label);
    }
    if (parameter.type == WireType::Boolean)
        return raw != 0 ? ValueText::tr("on") : ValueText::tr("off");
    return screen(shownText(parameter, raw));
}

QString fieldText(const Parameter &parameter, std::int64_t raw)
{
    for (const Choice &choice : parameter.choices) {
        if (choice.raw == raw)
            return qt(choice.label);
    }
    return localNumber(qt(shownText(parameter, raw)));
}

QString rawText(const Parameter &parameter, std::int64_t raw)
{
    const int bits = hexDigits(parameter.type) * 4;
    const auto mask = (std::uint64_t{1} << static_cast<unsigned>(bits)) - 1U;
    return QStringLiteral("0x") + QString::number(static_cast<std::uint64_t>(raw) & mask, 16).toUpper();
}

QString rangeText(const Parameter &parameter)
{
    if (parameter.type == WireType::Boolean)
        return ValueText::tr("off or on");
    const QString range
        = number(parameter.minimum) + QStringLiteral(" … ") + screen(shortest(parameter, parameter.maximum));
    return parameter.unit.empty() ? range : range + QLatin1Char(' ') + qt(parameter.unit);
}

QString valueWithUnit(const Parameter &parameter, std::int64_t raw)
{
    const QString value = valueText(parameter, raw);
    const bool symbol = !parameter.unit.empty() && parameter.unit.size() <= 3;
    return symbol ? value + QChar(QChar::Nbsp) + qt(parameter.unit) : value;
}

std::int64_t defaultRaw(const Parameter &parameter)
{
    return toRaw(parameter, parameter.fallback).value_or(0);
}

std::optional<double> fullScale(const Parameter &parameter)
{
    if (!parameter.ofOutput)
        return std::nullopt;
    const double full = std::max(std::abs(parameter.minimum), std::abs(parameter.maximum));
    return full > 0 ? std::optional(full) : std::nullopt;
}

bool isEditable(const Parameter &parameter)
{
    return parameter.access != Access::ReadOnly && parameter.nature != Nature::Counter;
}

QString understoodValue(const Parameter &parameter, const QString &text)
{
    const auto raw = parseValue(parameter, text).raw;
    if (!raw || parameter.type == WireType::Boolean || !parameter.choices.empty())
        return {};
    const QString written = fieldText(parameter, *raw);
    const auto typed = parseNumber(text);
    const bool same = typed && typed == parseNumber(written) && !text.contains(foreignSign());
    return same ? QString() : QStringLiteral("= ") + written;
}

ParsedValue parseValue(const Parameter &parameter, const QString &text)
{
    const QString typed = text.trimmed();
    if (const auto raw = parseRaw(parameter, typed.toStdString()))
        return legal(*raw);
    QString shown = typed;
    shown.replace(QLatin1Char('-'), MinusSign);
    auto value = parseNumber(typed, fullScale(parameter));
    if (const auto whole = value ? std::nullopt : parseInteger(typed)) // hexadecimal
        value = static_cast<double>(*whole);
    if (!value)
        return notANumber(parameter, shown);
    const bool percent = typed.endsWith(QLatin1Char('%'));
    const double meant = percent && parameter.one == 1.0 ? std::round(*value) : *value;
    if (const auto raw = toRaw(parameter, meant))
        return legal(*raw);
    return refused(parameter, shown, meant);
}

} // namespace mb
