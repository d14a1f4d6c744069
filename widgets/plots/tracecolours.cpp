// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/tracecolours.h"

#include <algorithm>
#include <array>

namespace mb {
namespace {

/// Colours that stand in for one that is taken, and patterns for when all are.
constexpr std::array substitutes{TraceRole::Velocity, TraceRole::Position, TraceRole::Current, TraceRole::Duty,
    TraceRole::Temperature, TraceRole::Error};
constexpr std::array patterns{TraceDash::Long, TraceDash::Short, TraceDash::Dots};

} // namespace

void chooseColour(TraceStyle &style, const std::vector<TraceLook> &used)
{
    const auto taken = [&](TraceRole colour, TraceDash dash) {
        return std::ranges::any_of(used, [&](const TraceLook &look) {
            const bool wished = (look.role == TraceRole::Setpoint) == (style.role == TraceRole::Setpoint);
            return wished && look.colourRole() == colour && look.dash == dash;
        });
    };
    if (!taken(style.role, TraceDash::Automatic))
        return;
    if (style.role != TraceRole::Setpoint) {
        for (const TraceRole colour : substitutes) {
            if (!taken(colour, TraceDash::Automatic)) {
                style.colour = colour;
                return;
            }
        }
    }
    const auto dash = std::ranges::find_if(patterns, [&](TraceDash pattern) { return !taken(style.role, pattern); });
    style.dash = dash == patterns.end() ? patterns.back() : *dash;
}

} // namespace mb
