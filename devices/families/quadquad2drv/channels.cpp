// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/quadquad2drv/channels.h"

#include <QtGlobal>

#include <array>

namespace mb::quadquad2drv {
namespace {

constexpr std::string_view status = QT_TRANSLATE_NOOP("table", "Status bits");
constexpr std::string_view setPointLabel = QT_TRANSLATE_NOOP("table", "Set-point");

constexpr std::array<Channel, 16> channelRows{{
    {"ch1.position", "counts", QT_TRANSLATE_NOOP("table", "Position"), Quantity::Position},
    {"ch1.velocity", "counts/s", QT_TRANSLATE_NOOP("table", "Velocity"), Quantity::Velocity},
    {"ch1.status", "", status, Quantity::Other},
    {"ch1.setpoint", "", setPointLabel, Quantity::SetPoint}, // unit of the mode
    {"ch2.position", "counts", QT_TRANSLATE_NOOP("table", "Position"), Quantity::Position},
    {"ch2.velocity", "counts/s", QT_TRANSLATE_NOOP("table", "Velocity"), Quantity::Velocity},
    {"ch2.status", "", status, Quantity::Other},
    {"ch2.setpoint", "", setPointLabel, Quantity::SetPoint}, // unit of the mode
    {"ch3.position", "counts", QT_TRANSLATE_NOOP("table", "Position"), Quantity::Position},
    {"ch3.velocity", "counts/s", QT_TRANSLATE_NOOP("table", "Velocity"), Quantity::Velocity},
    {"ch3.status", "", status, Quantity::Other},
    {"ch3.setpoint", "", setPointLabel, Quantity::SetPoint}, // unit of the mode
    {"ch4.position", "counts", QT_TRANSLATE_NOOP("table", "Position"), Quantity::Position},
    {"ch4.velocity", "counts/s", QT_TRANSLATE_NOOP("table", "Velocity"), Quantity::Velocity},
    {"ch4.status", "", status, Quantity::Other},
    {"ch4.setpoint", "", setPointLabel, Quantity::SetPoint}, // unit of the mode
}};

static_assert(checkChannels(channelRows));
static_assert(channelRows[channelOf(3, AxisChannel::SetPoint).value].key == "ch4.setpoint");

} // namespace

std::span<const Channel> channelTable()
{
    return channelRows;
}

} // namespace mb::quadquad2drv
