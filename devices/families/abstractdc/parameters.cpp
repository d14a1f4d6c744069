// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/abstractdc/parameters.h"

#include <QtGlobal>

#include <algorithm>
#include <array>
#include <cstdlib>

namespace mb::abstractdc {
namespace {

constexpr double low = -2147483648.0;
constexpr double high = 2147483647.0;

constexpr std::string_view velocityLoop = QT_TRANSLATE_NOOP("table", "Velocity loop");
constexpr std::string_view currentLoop = QT_TRANSLATE_NOOP("table", "Current loop");
constexpr std::string_view positionLoop = QT_TRANSLATE_NOOP("table", "Position loop");
constexpr std::string_view pLabel = QT_TRANSLATE_NOOP("table", "P");
constexpr std::string_view iLabel = QT_TRANSLATE_NOOP("table", "I");
constexpr std::string_view dLabel = QT_TRANSLATE_NOOP("table", "D");
constexpr std::string_view divisorLabel = QT_TRANSLATE_NOOP("table", "Divisor");
constexpr std::string_view pHelp = QT_TRANSLATE_NOOP("table",
    "Output (255 = 100 %) per unit of error, times the divisor. Above 32767 the output wraps to full reverse: the "
    "program keeps set-points close enough to the motor for that.");
constexpr std::string_view iHelp = QT_TRANSLATE_NOOP("table",
    "Output per unit of error and millisecond, times the divisor. Each step of 20 ms is cut to a whole number, so "
    "small "
    "gains do nothing, and nothing limits the sum.");
constexpr std::string_view dHelp = QT_TRANSLATE_NOOP("table",
    "Output times milliseconds per change of error, times the divisor. Its sign is inverted in the drive: only "
    "negative "
    "numbers damp.");
constexpr std::string_view divisorHelp = QT_TRANSLATE_NOOP("table",
    "P, I and D are divided by it. Blank flash holds 0, with which no loop works; 0 is never written. A negative "
    "divisor "
    "keeps the integral across modes: to reverse the loop, change the signs of P, I and D.");
constexpr std::string_view averagingHelp = QT_TRANSLATE_NOOP("table",
    "Samples of 20 ms in a mean of the current, which reads wrong until so many were taken: it is changed at a "
    "standstill. Once lowered, the drive must lose its power for a moment before it is driven.");

constexpr Parameter row(std::string_view key, Loop loop, Field field, std::string_view group, std::string_view label,
    std::string_view help, double fallback = 0.0)
{
    return {key, parameterId(loop, field), WireType::Int32, 1.0, {}, low, high, fallback, Access::WriteOnly, true,
        Nature::Setting, group, label, help};
}

constexpr std::array<Parameter, 13> table{{
    as(Role::Proportional, row("velocity.p", Loop::Velocity, Field::P, velocityLoop, pLabel, pHelp)),
    as(Role::Integral, row("velocity.i", Loop::Velocity, Field::I, velocityLoop, iLabel, iHelp)),
    as(Role::Derivative, row("velocity.d", Loop::Velocity, Field::D, velocityLoop, dLabel, dHelp)),
    as(Role::Divisor,
        row("velocity.divisor", Loop::Velocity, Field::Divisor, velocityLoop, divisorLabel, divisorHelp, 1.0)),
    as(Role::Proportional, row("current.p", Loop::Current, Field::P, currentLoop, pLabel, pHelp)),
    as(Role::Integral, row("current.i", Loop::Current, Field::I, currentLoop, iLabel, iHelp)),
    as(Role::Derivative, row("current.d", Loop::Current, Field::D, currentLoop, dLabel, dHelp)),
    as(Role::Divisor,
        row("current.divisor", Loop::Current, Field::Divisor, currentLoop, divisorLabel, divisorHelp, 1.0)),
    {"current.averaging", parameterId(Loop::Current, Field::Averaging), WireType::Uint16, 1.0, "", 1.0, averagingMost,
        1.0, Access::WriteOnly, true, Nature::Setting, currentLoop, QT_TRANSLATE_NOOP("table", "Averaging"),
        averagingHelp},
    as(Role::Proportional, row("position.p", Loop::Position, Field::P, positionLoop, pLabel, pHelp)),
    as(Role::Integral, row("position.i", Loop::Position, Field::I, positionLoop, iLabel, iHelp)),
    as(Role::Derivative, row("position.d", Loop::Position, Field::D, positionLoop, dLabel, dHelp)),
    as(Role::Divisor,
        row("position.divisor", Loop::Position, Field::Divisor, positionLoop, divisorLabel, divisorHelp, 1.0)),
}};

static_assert(checkParameters(table));

/// What is known of a loop, and what it becomes.
struct Set {
    std::optional<std::int64_t> before;
    std::optional<std::int64_t> after;
    [[nodiscard]] bool grows() const { return after && (!before || std::abs(*after) >= std::abs(*before)); }
};

Set setOf(const ParameterStore &known, const std::vector<ParameterChange> &changes, Loop loop, Field field)
{
    const auto index = parameterOf(loop, field);
    if (!index)
        return {};
    Set set{known.entry(*index).raw, std::nullopt};
    for (const ParameterChange &change : changes) {
        if (change.index == *index)
            set.after = change.raw;
    }
    return set;
}

} // namespace

std::span<const Parameter> parameterTable()
{
    return table;
}

std::optional<ParameterIndex> parameterOf(Loop loop, Field field)
{
    const auto found = std::ranges::find(table, parameterId(loop, field), &Parameter::id);
    if (found == table.end())
        return std::nullopt;
    return ParameterIndex{static_cast<std::uint16_t>(found - table.begin())};
}

void arrange(const ParameterStore &known, std::vector<ParameterChange> &changes)
{
    const std::vector<ParameterChange> all = changes;
    const auto rank = [&](const ParameterChange &change) {
        const Parameter &parameter = known.parameter(change.index);
        const Loop loop = loopOf(parameter);
        const bool divisorLast = !setOf(known, all, loop, Field::Divisor).grows();
        const bool dampFirst = setOf(known, all, loop, Field::P).grows();
        const int place = static_cast<int>(loop) * 8;
        switch (fieldOf(parameter)) {
        case Field::Divisor: return place + (divisorLast ? 5 : 0);
        case Field::D: return place + (dampFirst ? 1 : 3);
        case Field::P: return place + 2;
        case Field::I: return place + 4;
        case Field::Averaging: return place + 6;
        }
        return place;
    };
    std::ranges::stable_sort(
        changes, [&](const ParameterChange &a, const ParameterChange &b) { return rank(a) < rank(b); });
}

} // namespace mb::abstractdc
