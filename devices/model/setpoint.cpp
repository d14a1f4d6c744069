// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/setpoint.h"

#include <array>

namespace mb {
namespace {

struct Row {
    Mode mode;
    std::string_view name;
    std::string_view unit;
};
constexpr std::array rows{
    Row{Mode::Off, "off", ""},
    Row{Mode::Duty, "duty", ""},
    Row{Mode::Velocity, "velocity", "counts/s"},
    Row{Mode::Position, "position", "counts"},
    Row{Mode::Current, "current", "A"},
    Row{Mode::Voltage, "voltage", "V"},
    Row{Mode::Follow, "follow", ""},
    Row{Mode::RampPosition, "ramp-position", "counts"},
    Row{Mode::RampVelocity, "ramp-velocity", "counts/s"},
};

const Row &rowOf(Mode mode)
{
    for (const Row &row : rows) {
        if (row.mode == mode)
            return row;
    }
    return rows.front();
}

} // namespace

std::string_view toString(Mode mode)
{
    return rowOf(mode).name;
}

std::optional<Mode> modeFromString(std::string_view text)
{
    for (const Row &row : rows) {
        if (row.name == text)
            return row.mode;
    }
    return std::nullopt;
}

std::string_view unitOf(Mode mode)
{
    return rowOf(mode).unit;
}

} // namespace mb
