// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/tunechoices.h"

#include "widgets/common/devicetext.h"

#include <algorithm>

namespace mb {

TuneChoices::TuneChoices(Workbench &workbench, const Selection &selection)
    : m_workbench(workbench)
    , m_desk(EditDesk::of(workbench))
    , m_selection(selection)
{
}

const DeviceView *TuneChoices::device() const
{
    return m_workbench.snapshot().device(m_selection.device());
}

int TuneChoices::axisOf(const DeviceView &view) const
{
    return hasAxes(*view.family) ? std::min(m_selection.motor(), view.family->capabilities.axes) : 0;
}

TuneChoice *TuneChoices::find(const TuneMotor &motor)
{
    const auto found = m_choices.find(motor);
    return found == m_choices.end() ? nullptr : &found->second;
}

void TuneChoices::make(const DeviceView &view)
{
    const bool several = hasAxes(*view.family);
    for (int axis = several ? 1 : 0; axis <= (several ? view.family->capabilities.axes : 0); ++axis)
        (void)of(view, axis);
}

TuneChoice &TuneChoices::of(const DeviceView &view, int axis)
{
    TuneChoice &chosen = m_choices[{view.id, axis}];
    StagedEdits &edits = m_desk.editsOf(view);
    if (chosen.edits == &edits)
        return chosen;
    if (!chosen.edits)
        chosen.units.revolutions = m_revolutions;
    chosen.edits = &edits;
    connect(&edits, &StagedEdits::changed, this, &TuneChoices::countEdit, Qt::UniqueConnection);
    return chosen;
}

void TuneChoices::countEdit()
{
    ++m_editRevision;
    Q_EMIT edited();
}

void TuneChoices::setRevolutions(bool on)
{
    m_revolutions = on;
    for (auto &[motor, chosen] : m_choices)
        chosen.units.revolutions = on;
}

void TuneChoices::forgetMotion()
{
    for (auto &[motor, chosen] : m_choices)
        chosen.ours = false;
}

} // namespace mb
