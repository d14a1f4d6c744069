// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/supermodified/channels.h"

#include <QtGlobal>

#include <array>

namespace mb::supermodified {
namespace {

using Table = std::array<Channel, 11>;

consteval Table channelRows(std::string_view current)
{
    return {{
        {"position", "counts", QT_TRANSLATE_NOOP("table", "Position"), Quantity::Position},
        {"velocity", "counts/s", QT_TRANSLATE_NOOP("table", "Velocity"), Quantity::Velocity},
        {"current", current, QT_TRANSLATE_NOOP("table", "Current"), Quantity::Current},
        {"setpoint", "", QT_TRANSLATE_NOOP("table", "Set-point"), Quantity::SetPoint}, // unit of the mode
        {"velocity.reported", "counts/s", QT_TRANSLATE_NOOP("table", "Velocity as reported"), Quantity::Velocity},
        {"position.absolute", "counts", QT_TRANSLATE_NOOP("table", "Position in the turn"), Quantity::Position},
        {"analog1", "V", QT_TRANSLATE_NOOP("table", "Analog input 1"), Quantity::Voltage},
        {"analog2", "V", QT_TRANSLATE_NOOP("table", "Analog input 2"), Quantity::Voltage},
        {"analog3", "V", QT_TRANSLATE_NOOP("table", "Analog input 3"), Quantity::Voltage},
        {"analog4", "V", QT_TRANSLATE_NOOP("table", "Analog input 4"), Quantity::Voltage},
        {"digital", "", QT_TRANSLATE_NOOP("table", "Digital inputs"), Quantity::Other},
    }};
}

constexpr Table inCounts = channelRows("counts");
constexpr Table amperes = channelRows("A");

static_assert(checkChannels(inCounts) && checkChannels(amperes));
static_assert(inCounts[channel::analog1.value].key == "analog1" && inCounts[channel::digital.value].key == "digital");
static_assert(inCounts[channel::reportedVelocity.value].key == "velocity.reported");

} // namespace

std::span<const Channel> channelTable(bool currentKnown)
{
    return currentKnown ? amperes : inCounts;
}

} // namespace mb::supermodified
