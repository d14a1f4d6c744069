// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/abstractdc/channels.h"

#include <QtGlobal>

#include <array>

namespace mb::abstractdc {
namespace {

using Table = std::array<Channel, 6>;

consteval Table channelRows(std::string_view current, std::string_view temperature)
{
    return {{
        {"position", "counts", QT_TRANSLATE_NOOP("table", "Position"), Quantity::Position},
        {"velocity", "counts/s", QT_TRANSLATE_NOOP("table", "Velocity"), Quantity::Velocity},
        {"current", current, QT_TRANSLATE_NOOP("table", "Current"), Quantity::Current},
        {"duty", "fraction", QT_TRANSLATE_NOOP("table", "Duty"), Quantity::Duty},
        {"setpoint", "", QT_TRANSLATE_NOOP("table", "Set-point"), Quantity::SetPoint}, // unit of the mode
        {"temperature", temperature, QT_TRANSLATE_NOOP("table", "Temperature"), Quantity::Temperature},
    }};
}

constexpr Table inCounts = channelRows("counts", "counts");
constexpr Table amperes = channelRows("A", "counts");
constexpr Table degrees = channelRows("counts", "°C");
constexpr Table both = channelRows("A", "°C");

static_assert(checkChannels(inCounts) && checkChannels(both));
static_assert(inCounts[channel::duty.value].key == "duty" && inCounts[channel::temperature.value].key == "temperature");

} // namespace

std::span<const Channel> channelTable(bool currentKnown, bool temperatureKnown)
{
    if (currentKnown)
        return temperatureKnown ? both : amperes;
    return temperatureKnown ? degrees : inCounts;
}

} // namespace mb::abstractdc
