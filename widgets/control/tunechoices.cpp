// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/tunechoices.h"

#include "widgets/common/devicetext.h"

#include <algorithm>
#include <utility>

namespace mb {

TuneChoices::TuneChoices(Workbench &workbench, const Selection &selection)
    : m_workbench(workbench)
    , m_desk(EditDesk::of(workbench))
    , m_selection(selection)
    , m_kept(workbench.kept<Kept>())
{
}

int TuneChoices::axisOf(const DeviceView &view) const
{
    return hasAxes(*view.family) ? std::min(m_selection.motor(), view.family->capabilities.axes) : 0;
}

double TuneChoices::countsPerRevolution(Workbench &workbench, const DeviceView &view, int axis)
{
    const auto &choices = workbench.kept<Kept>().choices;
    const auto chosen = choices.find({view.id, hasAxes(*view.family) ? axis : 0});
    const double profile = view.profile->calibrated(countsPerRevolutionKey);
    if (chosen == choices.end() || (profile > 0.0 && profile != chosen->second.profiled))
        return profile;
    return chosen->second.units.countsPerRevolution;
}

TuneChoice *TuneChoices::find(const TuneMotor &motor)
{
    const auto found = m_kept.choices.find(motor);
    return found == m_kept.choices.end() ? nullptr : &found->second;
}

void TuneChoices::make(const DeviceView &view)
{
    const bool several = hasAxes(*view.family);
    for (int axis = several ? 1 : 0; axis <= (several ? view.family->capabilities.axes : 0); ++axis)
        (void)of(view, axis);
}

TuneChoice &TuneChoices::of(const DeviceView &view, int axis)
{
    const auto [place, isNew] = m_kept.choices.try_emplace({view.id, axis});
    TuneChoice &chosen = place->second;
    if (isNew)
        chosen.units.revolutions = m_kept.revolutions;
    chosen.edits = &m_desk.editsOf(view);
    connect(chosen.edits, &StagedEdits::changed, this, &TuneChoices::countEdit, Qt::UniqueConnection);
    return chosen;
}

void TuneChoices::countEdit()
{
    ++m_editRevision;
    Q_EMIT edited();
}

void TuneChoices::setRevolutions(bool on)
{
    if (std::exchange(m_kept.revolutions, on) == on)
        return;
    for (auto &[motor, chosen] : m_kept.choices)
        chosen.units.revolutions = on;
}

bool TuneChoices::forgetPlaces(const DeviceView &view)
{
    bool shown = false;
    for (auto &[motor, chosen] : m_kept.choices) {
        if (motor.device != view.id || std::exchange(chosen.origin, view.origin) == view.origin)
            continue;
        chosen.entered.forgetPositions();
        shown = shown || motor == m_shown;
    }
    return shown;
}

void TuneChoices::forgetMotion()
{
    for (auto &[motor, chosen] : m_kept.choices)
        chosen.ours = false;
}

} // namespace mb
