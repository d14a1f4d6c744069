// SPDX-License-Identifier: GPL-3.0-or-later
#include "tinker/tables.h"

#include <QtGlobal>

#include <array>

namespace mb::tinker {
namespace {

constexpr std::string_view loop = QT_TRANSLATE_NOOP("table", "Tinkered loop");

constexpr Parameter row(std::uint16_t number, std::string_view key, double one, std::string_view unit, double maximum,
    double fallback, std::string_view label, std::string_view help)
{
    return {key, number, WireType::Int32, one, unit, 0.0, maximum, fallback, Access::ReadWrite, true, Nature::Setting,
        loop, label, help};
}

constexpr Parameter ofOutput(Parameter row)
{
    row.ofOutput = true;
    return row;
}

constexpr std::array<Parameter, 3> parameters{{
    as(Role::Proportional,
        row(1, "loop.stiffness", 1000.0, "fraction/turn", 100.0, 5.0, QT_TRANSLATE_NOOP("table", "Tinkered stiffness"),
            QT_TRANSLATE_NOOP("table", "Tinkered duty for a turn of error."))),
    as(Role::Derivative,
        row(2, "loop.damping", 1000.0, "fraction·s/turn", 100.0, 0.2, QT_TRANSLATE_NOOP("table", "Tinkered damping"),
            QT_TRANSLATE_NOOP("table", "Tinkered duty for a turn per second."))),
    as(Role::Limit,
        ofOutput(row(3, "limit.duty", 10000.0, "fraction", 1.0, 1.0, QT_TRANSLATE_NOOP("table", "Tinkered limit"),
            QT_TRANSLATE_NOOP("table", "Greatest duty in every mode.")))),
}};
static_assert(checkParameters(parameters));

constexpr std::array<Channel, 3> channels{{
    {"position", "counts", QT_TRANSLATE_NOOP("table", "Position"), Quantity::Position},
    {"duty", "fraction", QT_TRANSLATE_NOOP("table", "Duty"), Quantity::Duty},
    {"setpoint", "", QT_TRANSLATE_NOOP("table", "Set-point"), Quantity::SetPoint},
}};
static_assert(checkChannels(channels));

constexpr std::array<StateRow, 1> states{{
    {"end_switch", QT_TRANSLATE_NOOP("table", "Tinkered end switch"),
        QT_TRANSLATE_NOOP("table", "tinkered end switch holds"), StateKind::Switch},
}};
static_assert(checkStates(states));

constexpr std::array<FaultRow, 1> faults{{{"stalled", QT_TRANSLATE_NOOP("table", "tinkered to a standstill")}}};

} // namespace

std::span<const Parameter> parameterTable()
{
    return parameters;
}

std::span<const Channel> channelTable()
{
    return channels;
}

std::span<const StateRow> stateTable()
{
    return states;
}

std::span<const FaultRow> faultTable()
{
    return faults;
}

} // namespace mb::tinker
