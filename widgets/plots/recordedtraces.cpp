// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/recordedtraces.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/displayunits.h"
#include "widgets/plots/plotstack.h"
#include "widgets/plots/telemetrysource.h"
#include "widgets/plots/tracecolours.h"

namespace mb {

std::vector<int> showRecording(PlotStack &stack, const LoadedRecording &recording)
{
    QStringList panes;
    std::vector<TraceLook> used;
    std::vector<int> traces;
    for (std::uint16_t i = 0; i < recording.table.size(); ++i) {
        const Channel &row = recording.table[i];
        if (recording.telemetry->size({i}) == 0) {
            traces.push_back(-1);
            continue;
        }
        const ShownUnit unit = shownUnit(row, {});
        if (!panes.contains(unit.text))
            panes << unit.text;
        const auto source
            = std::make_shared<TelemetrySource>(recording.telemetry, ChannelIndex{i}, TelemetrySource::Foot::WhenLossy);
        source->setScale(unit.scale);
        TraceStyle style{qt(row.label), unit.text, roleOf(row.quantity), static_cast<int>(panes.indexOf(unit.text))};
        style.mostDecimals = mostDecimals(row.quantity, unit);
        chooseColour(style, used);
        used.push_back(style.look());
        traces.push_back(stack.strips().addTrace(style, source));
    }
    const double from = plotKey(recording.first);
    const double to = plotKey(recording.last);
    if (recording.hasClock)
        stack.strips().times().setClock(WallClock{});
    if (recording.simulated)
        stack.strips().setWatermark(QStringLiteral("DEMO"));
    stack.view().setWhole(from, to > from ? to : from + 1.0);
    return traces;
}

} // namespace mb
