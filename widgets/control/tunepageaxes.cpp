// SPDX-License-Identifier: GPL-3.0-or-later
// Boards with several axes: which one is shown, what the others do, several at once.
#include "model/axis.h"
#include "widgets/common/axistext.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/numberformat.h"
#include "widgets/control/axespanel.h"
#include "widgets/control/envelopepanel.h"
#include "widgets/control/gainspanel.h"
#include "widgets/control/gainunits.h"
#include "widgets/control/modepanel.h"
#include "widgets/control/stimulusbar.h"
#include "widgets/control/trialsview.h"
#include "widgets/control/tunepage.h"
#include "widgets/control/tuneplot.h"
#include "widgets/parameters/axisparameters.h"

#include <QLabel>

#include <algorithm>
#include <cmath>

namespace mb {

std::vector<int> TunePage::motorsOf(const DeviceView &view) const
{
    if (!hasAxes(*view.family))
        return {0};
    std::vector<int> axes;
    for (int axis = 1; axis <= view.family->capabilities.axes; ++axis)
        axes.push_back(axis);
    return axes;
}

/// The selected one; where the board is selected, the one that was shown last.
int TunePage::axisFor(const DeviceView &view)
{
    if (!hasAxes(*view.family))
        return 0;
    int &last = m_lastAxis.try_emplace(view.id, 1).first->second;
    if (m_selection.axis() > 0)
        last = std::min(m_selection.axis(), view.family->capabilities.axes);
    return last;
}

TunePage::Choice &TunePage::choiceOf(const DeviceView &view, int axis)
{
    Choice &chosen = m_choices[{view.id, axis}];
    StagedEdits &edits = m_desk.editsOf(view);
    if (chosen.edits == &edits)
        return chosen;
    if (!chosen.edits)
        chosen.units.revolutions = m_revolutions;
    chosen.edits = &edits;
    connect(&edits, &StagedEdits::changed, this, &TunePage::editsChanged, Qt::UniqueConnection);
    return chosen;
}

void TunePage::editsChanged()
{
    ++m_editRevision;
    follow();
}

void TunePage::showMotor(const DeviceView &view, int axis)
{
    if (Choice *before = choice())
        before->entered = m_setPoint->entered();
    const bool other = m_shown != view.id;
    m_shown = view.id;
    m_axis = axis;
    Choice &chosen = choiceOf(view, axis);
    if (other)
        m_axes->setAxes(view.family->capabilities.axes);
    m_axes->setAxis(axis);
    m_axesLine->setVisible(axis > 0);
    m_modes->setFamily(*view.family);
    m_modes->chainAfter(m_axes->chainAfter(m_run));
    m_modes->show(chosen.mode, chosen.editedSlot, chosen.runningSlot);
    chosen.mode = m_modes->mode();
    m_setPoint->reset(view.family->capabilities);
    m_setPoint->setFamily(*view.family);
    m_setPoint->setMode(chosen.mode);
    if (axis > 0)
        m_setPoint->restore(chosen.entered);
    m_setPoint->setUnits(chosen.units);
    m_plot->setUnits(chosen.units);
    m_gains->setUnits(chosen.units);
    m_trials->setUnits(chosen.units);
    m_stimulus->setUnits(chosen.mode, chosen.units);
    m_envelope->setUnits(chosen.units);
    m_plot->choose(view, chosen.mode, axis, beside());
    m_stimulus->setChoice(chosen.stimulus);
    m_envelope->choose(chosen.unit, false);
}

/// What runs elsewhere stays in sight, whatever is shown.
void TunePage::followAxes(const DeviceView &view)
{
    followFirstPower(view);
    for (int axis = 1; axis <= m_axes->count(); ++axis) {
        const SetPoint wished = wantedOf(view, axis);
        const bool runs = view.motion.on(axis) != nullptr;
        AxesPanel::State state;
        state.glyph = glyphOfAxis(view, axis);
        const ShownUnit unit = shownUnit(wished.mode, choiceOf(view, axis).units);
        state.command = runs ? commandOfAxis(view, axis)
                             : tr("%1 %2, at rest", "mode and target")
                                   .arg(modeText(wished.mode), formatValue(wished.target * unit.scale, 0, unit.text));
        state.value = valueOfAxis(view, axis, m_workbench.presentOf(view.link));
        m_axes->setState(axis, state);
    }
}

void TunePage::followFirstPower(const DeviceView &view)
{
    const auto limit = findParameter(view.family->parameters, axisKey(m_axis, "limit.power"));
    const double first = view.family->capabilities.firstPower;
    const bool unknown = m_axis > 0 && first > 0.0 && limit && limit->value < view.parameters.size()
        && !view.parameters[limit->value].raw;
    m_firstPower->setVisible(unknown);
    if (unknown)
        m_firstPower->setText(tr("The power limit of axis %1 is unknown: its first motion sets it to %2. Write another "
                                 "under Limits of the axis.")
                                  .arg(m_axis)
                                  .arg(formatValue(first * 100.0, 0, tr("%"))));
}

/// What Run would send to an axis: of one that is not shown, what was entered for it.
SetPoint TunePage::wantedOf(const DeviceView &view, int axis) const
{
    if (axis == m_axis)
        return wanted();
    const Choice &chosen = m_choices.at({view.id, axis});
    SetPoint setPoint;
    setPoint.axis = axis;
    setPoint.mode = chosen.mode;
    const auto found = chosen.entered.ranges.find(chosen.mode);
    const bool entered = found != chosen.entered.ranges.end() && found->second.touched;
    if (found != chosen.entered.ranges.end())
        setPoint.target = found->second.target;
    if (!entered && SetPointPanel::startsAtPresent(chosen.mode)) // so that nothing jumps
        setPoint.target = std::round(present(view, chosen.mode, axis).value_or(0.0));
    const bool profiled = chosen.mode == Mode::RampPosition || chosen.mode == Mode::RampVelocity;
    if (profiled && view.family->capabilities.commandsProfile) {
        setPoint.velocity = chosen.entered.velocity;
        setPoint.acceleration = chosen.entered.acceleration;
    }
    return setPoint;
}

std::vector<int> TunePage::beside() const
{
    std::vector<int> others = m_axes->together();
    std::erase(others, m_axis);
    return others;
}

void TunePage::spread()
{
    const DeviceView *view = device();
    Choice *shown = choice();
    const auto target = m_setPoint->target();
    if (!view || !shown || !target)
        return;
    shown->entered = m_setPoint->entered();
    const SetPointPanel::Range mine = shown->entered.ranges[shown->mode];
    const bool distance = SetPointPanel::startsAtPresent(shown->mode);
    const double here = distance ? present(*view, shown->mode, m_axis).value_or(0.0) : 0.0;
    for (const int axis : beside()) {
        Choice &other = choiceOf(*view, axis);
        if (isAxisMoving(*view, axis) && other.mode != shown->mode) {
            m_workbench.report(
                Severity::Caution, titleOf(*view), tr("axis %1 moves in another mode; stop it first").arg(axis));
            continue;
        }
        SetPointPanel::Range range = mine;
        range.touched = true;
        if (distance)
            range.target = std::round(present(*view, shown->mode, axis).value_or(0.0) + *target - here);
        range.limit = std::max(mine.limit, std::abs(range.target));
        other.mode = shown->mode;
        const auto ranges = other.entered.ranges;
        other.entered = shown->entered;
        other.entered.ranges = ranges;
        other.entered.ranges[shown->mode] = range;
    }
    follow();
}

void TunePage::copyGains(int from)
{
    const DeviceView *view = device();
    Choice *chosen = choice();
    if (!view || !chosen)
        return;
    const StagedEdits &source = *chosen->edits;
    const GainSet rows = gainSet(*view->family, chosen->mode, chosen->editedSlot, m_axis);
    const auto isShown = [&rows](ParameterIndex index) {
        return std::find(rows.gains.begin(), rows.gains.end(), index) != rows.gains.end()
            || std::find(rows.bounds.begin(), rows.bounds.end(), index) != rows.bounds.end();
    };
    std::vector<ParameterChange> changes = gainsOfAxis(*view->family, source, from, m_axis);
    std::erase_if(changes, [&](const ParameterChange &change) { return !isShown(change.index); });
    if (changes.empty()) {
        m_workbench.report(Severity::Caution, titleOf(*view),
            tr("nothing copied: no gain of axis %1 is known for this mode; write it first").arg(from));
        return;
    }
    chosen->edits->stageAll(changes, tr("Gains and limits of axis %1").arg(from));
}

/// " · axis 1, 3 move, too"; empty where nothing else runs.
QString TunePage::othersText(const DeviceView &view) const
{
    QStringList others;
    for (const SetPoint &setPoint : view.motion.setPoints) {
        if (m_axis > 0 && view.motion.running && setPoint.axis != m_axis)
            others << QString::number(setPoint.axis);
    }
    std::sort(others.begin(), others.end());
    return others.isEmpty() ? QString() : tr(" · also moving: axis %1").arg(others.join(QStringLiteral(", ")));
}

} // namespace mb
