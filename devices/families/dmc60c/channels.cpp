// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/dmc60c/channels.h"

#include <QtGlobal>

#include <array>

namespace mb::dmc60c {
namespace {

constexpr std::array<Channel, 9> channelRows{{
    {"position", "counts", QT_TRANSLATE_NOOP("table", "Position"), Quantity::Position},
    {"velocity", "counts/s", QT_TRANSLATE_NOOP("table", "Velocity"), Quantity::Velocity},
    {"current", "A", QT_TRANSLATE_NOOP("table", "Current"), Quantity::Current},
    {"duty", "fraction", QT_TRANSLATE_NOOP("table", "Duty"), Quantity::Duty},
    {"setpoint", "", QT_TRANSLATE_NOOP("table", "Set-point"), Quantity::SetPoint}, // unit of the mode, as the next
    {"error", "", QT_TRANSLATE_NOOP("table", "Loop error"), Quantity::Error},
    {"bus_voltage", "V", QT_TRANSLATE_NOOP("table", "Supply"), Quantity::Voltage},
    {"temperature", "°C", QT_TRANSLATE_NOOP("table", "Temperature"), Quantity::Temperature},
    {"analog1", "V", QT_TRANSLATE_NOOP("table", "Analog input"), Quantity::Voltage},
}};

static_assert(checkChannels(channelRows));
static_assert(channelRows[channel::duty.value].key == "duty" && channelRows[channel::analog1.value].key == "analog1");

} // namespace

std::span<const Channel> channelTable()
{
    return channelRows;
}

} // namespace mb::dmc60c
