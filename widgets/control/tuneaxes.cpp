// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/tuneaxes.h"

#include "widgets/common/axistext.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/numberformat.h"
#include "widgets/control/axespanel.h"
#include "widgets/control/setpointpanel.h"
#include "widgets/control/tunecolumn.h"

#include <algorithm>
#include <cmath>

namespace mb {

TuneAxes::TuneAxes(Workbench &workbench, TuneChoices &choices, TuneMotion &motion, TuneColumn &column)
    : m_workbench(workbench)
    , m_choices(choices)
    , m_motion(motion)
    , m_column(column)
{
}

void TuneAxes::follow(const DeviceView &view)
{
    m_column.showFirstPower(view, m_choices.axis());
    AxesPanel &panel = m_column.axesPanel();
    for (int axis = 1; axis <= panel.count(); ++axis) {
        const SetPoint wished = m_motion.wanted(view, axis);
        const bool runs = view.motion.on(axis) != nullptr;
        AxesPanel::State state;
        state.glyph = glyphOfAxis(view, axis);
        const ShownUnit unit = shownUnit(wished.mode, m_choices.of(view, axis).units);
        const QString target = formatValue(wished.target * unit.scale, 0, unit.text);
        state.command = runs      ? commandOfAxis(view, axis)
            : view.liveness.heard ? tr("%1 %2, at rest", "mode and target").arg(modeText(wished.mode), target)
                                  : modeText(wished.mode) + QLatin1Char(' ') + target;
        state.value = valueOfAxis(view, axis, m_workbench.presentOf(view.link));
        panel.setState(axis, state);
    }
}

std::vector<int> TuneAxes::beside() const
{
    std::vector<int> others = m_column.axesPanel().together();
    std::erase(others, m_choices.axis());
    return others;
}

void TuneAxes::spread()
{
    const DeviceView *const view = m_choices.device();
    TuneChoice *const shown = m_choices.current();
    if (!view || !shown || !m_column.setPointPanel().target())
        return;
    shown->entered = m_column.setPointPanel().entered();
    for (const int axis : beside()) {
        if (m_motion.isMoving(*view, axis) && m_choices.of(*view, axis).mode != shown->mode)
            m_workbench.report(
                Severity::Caution, titleOf(*view), tr("axis %1 moves in another mode; stop it first").arg(axis));
        else
            spreadTo(*view, axis, *shown);
    }
    Q_EMIT changed();
}

void TuneAxes::spreadTo(const DeviceView &view, int axis, const TuneChoice &shown)
{
    const Mode mode = shown.mode;
    SetPointEntries::Range range = shown.entered.range(mode);
    const double limit = range.limit;
    range.touched = true;
    if (startsAtPresent(mode)) {
        const auto here = m_motion.present(view, mode, m_choices.axis());
        const auto there = m_motion.present(view, mode, axis);
        const double target = m_column.setPointPanel().target().value_or(0.0);
        range.touched = here && there; // else it stays where it is
        range.target = range.touched ? std::round(*there + target - *here) : 0.0;
    }
    range.limit = std::max(limit, std::abs(range.target));
    TuneChoice &other = m_choices.of(view, axis);
    auto ranges = other.entered.ranges;
    ranges[mode] = range;
    other.mode = mode;
    other.entered = shown.entered;
    other.entered.ranges = std::move(ranges);
}

} // namespace mb
