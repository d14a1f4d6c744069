// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/dmc60c/channels.h"

#include <array>

namespace mb::dmc60c {
namespace {

constexpr std::array<Channel, 9> table{{
    {"position", "counts", "Position", Quantity::Position},
    {"velocity", "counts/s", "Velocity", Quantity::Velocity},
    {"current", "A", "Current", Quantity::Current},
    {"duty", "fraction", "Duty", Quantity::Duty},
    {"setpoint", "", "Set-point", Quantity::SetPoint}, // unit of the mode in use, as the next
    {"error", "", "Loop error", Quantity::Error},
    {"bus_voltage", "V", "Supply", Quantity::Voltage},
    {"temperature", "°C", "Temperature", Quantity::Temperature},
    {"analog1", "V", "Analog input", Quantity::Voltage},
}};

static_assert(checkChannels(table));
static_assert(table[channel::duty.value].key == "duty" && table[channel::analog1.value].key == "analog1");

} // namespace

std::span<const Channel> channelTable()
{
    return table;
}

} // namespace mb::dmc60c
