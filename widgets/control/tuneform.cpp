// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/tuneform.h"

#include "widgets/control/axespanel.h"
#include "widgets/control/envelopepanel.h"
#include "widgets/control/gainspanel.h"
#include "widgets/control/modepanel.h"
#include "widgets/control/setpointpanel.h"
#include "widgets/control/trialsview.h"
#include "widgets/control/tunecolumn.h"
#include "widgets/control/tuneplot.h"

#include <QSignalBlocker>

#include <utility>

namespace mb {

TuneForm::TuneForm(TuneChoices &choices, TuneMotion &motion, const TuneParts &parts, const Arming &arming)
    : m_choices(choices)
    , m_motion(motion)
    , m_parts(parts)
    , m_arming(arming)
{
    connectPanels();
}

void TuneForm::connectPanels()
{
    TuneColumn &column = *m_parts.column;
    connect(&column.modePanel(), &ModePanel::modeChanged, this, &TuneForm::takeMode);
    connect(&column.modePanel(), &ModePanel::editedSlotChanged, this, &TuneForm::takeSlots);
    connect(&column.modePanel(), &ModePanel::runningSlotChanged, this, [this] {
        m_motion.disarmBecause(tr("the running slot"));
        takeSlots();
    });
    connect(&column.setPointPanel(), &SetPointPanel::polarityChanged, this,
        [this] { m_motion.disarmBecause(tr("a direction or a limit")); });
    connect(&column.setPointPanel(), &SetPointPanel::changed, this, &TuneForm::takeEntries);
    connect(m_parts.stimulus, &StimulusBar::changed, this, &TuneForm::takeStimulus);
    connect(&column.envelope(), &EnvelopePanel::changed, this, &TuneForm::takeStimulus);
    connect(m_parts.plot, &TunePlot::unitsChanged, this, [this](const DisplayUnits &units) {
        if (TuneChoice *const chosen = m_choices.current()) {
            chosen->units = units;
            showUnits(*chosen);
        }
        Q_EMIT changed();
    });
}

void TuneForm::show(const DeviceView &view, int axis)
{
    SetPointPanel &setPoint = m_parts.column->setPointPanel();
    takeEntries();
    const QSignalBlocker quiet(setPoint); // what it shows by and by was not entered
    if (m_choices.shown().device != view.id)
        m_parts.column->axesPanel().setAxes(view.family->capabilities.axes);
    m_choices.show({view.id, axis});
    m_parts.column->setAxis(axis);
    TuneChoice &chosen = m_choices.of(view, axis);
    if (chosen.unit.empty())
        chosen.unit = view.unit;
    ModePanel &modes = m_parts.column->modePanel();
    modes.setFamily(*view.family);
    modes.show(chosen.mode, chosen.editedSlot, chosen.runningSlot);
    chosen.mode = modes.mode();
    setPoint.show(*view.family, chosen.mode, chosen.entered);
    m_parts.plot->setUnits(chosen.units);
    showUnits(chosen);
    m_parts.stimulus->setChoice(chosen.stimulus);
    m_parts.column->envelope().choose(chosen.unit, false);
}

void TuneForm::followProfile(const DeviceView &view)
{
    TuneChoice &chosen = *m_choices.current();
    const double counts = view.profile->calibrated(countsPerRevolutionKey);
    if (counts <= 0.0 || counts == std::exchange(chosen.profiled, counts))
        return;
    chosen.units.countsPerRevolution = counts;
    m_parts.plot->setUnits(chosen.units);
    showUnits(chosen);
}

/// In all panels but the plot, which has the switch of the units.
void TuneForm::showUnits(const TuneChoice &chosen)
{
    m_parts.column->setPointPanel().setUnits(chosen.units);
    m_parts.column->gainsPanel().setUnits(chosen.units);
    m_parts.column->envelope().setUnits(chosen.units);
    m_parts.trials->setUnits(chosen.units);
    m_parts.stimulus->setUnits(chosen.mode, chosen.units);
}

void TuneForm::setRevolutions(bool on)
{
    m_choices.setRevolutions(on);
    if (const TuneChoice *const shown = m_choices.current()) {
        m_parts.plot->setUnits(shown->units);
        showUnits(*shown);
        Q_EMIT changed();
    }
}

void TuneForm::chooseMode(Mode mode)
{
    const TuneChoice &chosen = *m_choices.current();
    ModePanel &modes = m_parts.column->modePanel();
    modes.show(mode, chosen.editedSlot, chosen.runningSlot);
    if (chosen.mode != modes.mode())
        takeMode(modes.mode());
}

void TuneForm::choose(Mode mode, double target)
{
    if (!m_choices.current())
        return;
    chooseMode(mode);
    SetPointPanel &setPoint = m_parts.column->setPointPanel();
    setPoint.showTarget(target);
    setPoint.keepTarget();
    Q_EMIT setPoint.changed();
}

void TuneForm::chooseStimulus(Mode mode, const StimulusChoice &stimulus)
{
    TuneChoice *const chosen = m_choices.current();
    if (!chosen)
        return;
    chooseMode(mode);
    chosen->stimulus = stimulus;
    m_parts.stimulus->setChoice(stimulus);
    Q_EMIT changed();
}

void TuneForm::setRepeats(int repeats)
{
    TuneChoice *const chosen = m_choices.current();
    if (!chosen)
        return;
    chosen->stimulus.repeat = repeats;
    m_parts.stimulus->setChoice(chosen->stimulus);
}

void TuneForm::takeMode(Mode mode)
{
    const DeviceView *const view = m_choices.device();
    const int axis = m_choices.axis();
    const bool rests = view && axis > 0 && m_arming.isMoving() && !m_motion.isMoving(*view, axis);
    if (!rests) // what other axes do is not changed by it
        m_motion.disarmBecause(tr("the mode"));
    if (TuneChoice *const chosen = m_choices.current())
        chosen->mode = mode;
    m_parts.column->setPointPanel().setMode(mode);
    takeEntries();
    Q_EMIT changed();
}

void TuneForm::takeEntries()
{
    if (TuneChoice *const chosen = m_choices.current())
        chosen->entered = m_parts.column->setPointPanel().entered();
}

void TuneForm::takeSlots()
{
    if (TuneChoice *const chosen = m_choices.current()) {
        chosen->editedSlot = m_parts.column->modePanel().editedSlot();
        chosen->runningSlot = m_parts.column->modePanel().runningSlot();
    }
    Q_EMIT changed();
}

void TuneForm::takeStimulus()
{
    TuneChoice *const chosen = m_choices.current();
    if (!chosen)
        return;
    chosen->stimulus = m_parts.stimulus->choice();
    Q_EMIT changed();
}

} // namespace mb
