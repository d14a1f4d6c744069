// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/tunepage.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/emptystate.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/labels.h"
#include "widgets/common/numberformat.h"
#include "widgets/common/ratekeeper.h"
#include "widgets/common/spoken.h"
#include "widgets/control/axespanel.h"
#include "widgets/control/envelopepanel.h"
#include "widgets/control/gainspanel.h"
#include "widgets/control/gainunits.h"
#include "widgets/control/jogpanel.h"
#include "widgets/control/modepanel.h"
#include "widgets/control/movespanel.h"
#include "widgets/control/setpointpanel.h"
#include "widgets/control/stimulusbar.h"
#include "widgets/control/trialsview.h"
#include "widgets/control/tuneframe.h"
#include "widgets/control/tuneplot.h"

#include <QStackedWidget>

#include <algorithm>
#include <cmath>
#include <utility>

namespace mb {
namespace {

bool isRunning(const OperationView *operation)
{
    return operation && operation->status.state == OperationStatus::State::Running;
}

} // namespace

const DeviceView *TunePage::device() const
{
    return m_workbench.snapshot().device(m_selection.device());
}

TunePage::Choice *TunePage::choice()
{
    const auto found = m_choices.find({m_shown, m_axis});
    return found == m_choices.end() ? nullptr : &found->second;
}

void TunePage::selectionChanged()
{
    const bool live = m_arming.state() == LampState::Armed || m_arming.state() == LampState::Moving;
    if (live && m_arming.device() != m_selection.device()) {
        m_workbench.report(Severity::Info, {}, tr("disarmed: another device is selected"));
        m_arming.disarm();
    }
    follow();
}

void TunePage::follow()
{
    if (!m_arming.isMoving())
        forgetMotion();
    const DeviceView *view = device();
    const bool usable = view && view->identity.state != DeviceState::Bootloader;
    wishRates(usable ? view : nullptr);
    if (usable)
        followDevice(*view);
    else
        showEmpty(view);
    m_stack->setCurrentIndex(usable ? 1 : 0);
}

void TunePage::wishRates(const DeviceView *view)
{
    std::vector<RateKeeper::Wish> wishes;
    if (view && isVisible() && isLive() && (m_arming.isArmed(view->id) || RateKeeper::isFree(*view))) {
        for (const ChannelRate &rate : view->family->watched) {
            if (const auto channel = findChannel(view->family->channels, rate.channel))
                wishes.push_back({view->id, *channel, rate.hertz});
        }
    }
    RateKeeper::of(m_workbench).wish(this, wishes);
}

void TunePage::followDevice(const DeviceView &view)
{
    const int axis = axisFor(view);
    for (const int motor : motorsOf(view))
        (void)choiceOf(view, motor);
    if (m_shown != view.id || m_axis != axis)
        showMotor(view, axis);
    Choice &chosen = choiceOf(view, axis);
    const double counts = view.profile.calibrated(countsPerRevolutionKey);
    if (counts > 0.0 && counts != std::exchange(chosen.profiled, counts)) {
        chosen.units.countsPerRevolution = counts;
        m_setPoint->setUnits(chosen.units);
        m_plot->setUnits(chosen.units);
        m_gains->setUnits(chosen.units);
        m_trials->setUnits(chosen.units);
        m_stimulus->setUnits(chosen.mode, chosen.units);
        m_envelope->setUnits(chosen.units);
    }
    m_plot->choose(view, chosen.mode, axis, beside());
    m_plot->follow(view);
    m_setPoint->showPresent(present(view, chosen.mode, axis));
    followForeignRun(view);
    followAxes(view);
    if (isVisible())
        readOnce(view);
    followGains(view);
    m_moves->follow(view);
    if (!isLive())
        m_moves->hide();
    followTrials(view);
    showCommands();
}

void TunePage::followGains(const DeviceView &view)
{
    const Choice &chosen = *choice();
    const bool reading = isRunning(m_workbench.snapshot().operation(view.id));
    const QString rows = QStringLiteral("%1 %2 %3 %4 %5 %6 %7 %8")
                             .arg(view.id.value)
                             .arg(view.parameterRevision)
                             .arg(reading)
                             .arg(m_editRevision)
                             .arg(static_cast<int>(chosen.mode))
                             .arg(chosen.editedSlot)
                             .arg(chosen.units.countsPerRevolution)
                             .arg(m_axis);
    if (rows == m_rowsShown)
        return;
    m_rowsShown = rows;
    m_gains->choose(*view.family, *chosen.edits, chosen.mode, chosen.editedSlot, m_axis);
    m_gains->refresh(view, reading);
}

void TunePage::readOnce(const DeviceView &view)
{
    const bool unknown = std::all_of(view.parameters.begin(), view.parameters.end(),
        [](const auto &entry) { return entry.state == ParameterState::Unknown; });
    const bool ready = view.liveness.heard && view.busy.empty() && view.family->capabilities.readback;
    if (!unknown || !ready || isRunning(m_workbench.snapshot().operation(view.id)) || !m_asked.insert(view.id).second)
        return;
    m_workbench.send(orders::ReadParameters{view.id});
}

void TunePage::showEmpty(const DeviceView *view)
{
    if (view) {
        m_empty->setText(tr("%1 is in its bootloader").arg(titleOf(*view)),
            tr("It cannot drive a motor until it has firmware. Write an image on the Firmware page."));
        return;
    }
    const bool any = !m_workbench.snapshot().devices.empty();
    m_empty->setText(any ? tr("Select a device") : tr("No device yet"),
        any ? tr("Choose one in the list at the left; its loop is tuned here.")
            : tr("Open a link, or the simulated bench from the menu, to drive a motor."));
}

PageStatus TunePage::status() const
{
    const DeviceView *view = device();
    if (!view)
        return {GlyphState::Gone, tr("No device"), {}, false};
    const QString name = QStringLiteral("#%1").arg(view->identity.address);
    if (!view->liveness.heard)
        return {GlyphState::Gone, tr("No answer from %1").arg(name), tr("The plot keeps what it has."), false};
    if (m_arming.state() == LampState::Stopped)
        return {m_arming.isStoppedByHand() ? GlyphState::Gone : GlyphState::Fault,
            tr("Stopped: %1").arg(m_arming.reason()), tr("Hold the Arm button for 1 s to arm again."), false};
    if (!view->mayNotMove.empty())
        return {GlyphState::Warning, tr("%1 cannot be armed").arg(name), messageText(view->mayNotMove), false};
    if (isLive() && !m_setPoint->fault().isEmpty())
        return {GlyphState::OutOfRange, tr("The set-point cannot be sent"), m_setPoint->fault(), false};
    if (m_gains->hasFault())
        return {GlyphState::OutOfRange, tr("A gain is out of range"), tr("Correct or revert it first."), false};
    if (const QString leap = m_gains->unconfirmed(); !leap.isEmpty())
        return {GlyphState::Warning, tr("Look at a gain again"), leap, false};
    return liveStatus(*view, name);
}

PageStatus TunePage::liveStatus(const DeviceView &view, const QString &name) const
{
    if (m_writing)
        return {GlyphState::Busy, tr("Writing gains"), {}, false};
    const OperationView *operation = m_workbench.snapshot().operation(view.id);
    const bool known = std::any_of(
        view.parameters.begin(), view.parameters.end(), [](const auto &entry) { return entry.raw.has_value(); });
    if (isRunning(operation) && !known)
        return {GlyphState::Busy, tr("Reading gains"),
            tr("%1 of %2").arg(operation->status.done).arg(operation->status.total), false};
    if (!isLive())
        return trialStatus(view, name);
    const SetPoint *told = m_axis > 0 ? view.motion.on(m_axis) : view.motion.running ? &view.motion.setPoint : nullptr;
    const QString others = othersText(view);
    if (isAxisMoving(view, m_axis))
        return {GlyphState::Moving, tr("Moving"), describe(told ? *told : wanted()) + others, true};
    if (m_arming.isArmed(view.id))
        return {GlyphState::Online, tr("Armed"), tr("F5 runs %1").arg(describe(wanted())) + others, true};
    return {GlyphState::Gone, tr("Not armed"), tr("Hold the Arm button for 1 s to arm %1.").arg(name), false};
}

QString TunePage::describe(const SetPoint &setPoint) const
{
    const auto chosen = m_choices.find({m_shown, m_axis});
    const ShownUnit unit = shownUnit(setPoint.mode, chosen == m_choices.end() ? DisplayUnits{} : chosen->second.units);
    const double number = setPoint.target * unit.scale;
    const int decimals = number == std::round(number) ? 0 : unit.scale == 1.0 && unit.decimals == 0 ? 0 : 1;
    const QString target
        = setPoint.mode == Mode::Follow ? QStringLiteral("#%1").arg(number) : formatValue(number, decimals, unit.text);
    const QString what = modeText(setPoint.mode) + QLatin1Char(' ') + target;
    const DeviceView *view = device();
    if (m_axis > 0)
        return tr("axis %1: %2").arg(setPoint.axis).arg(what);
    const bool several = view && view->family->capabilities.gainSlots > 1 && isClosedLoop(setPoint.mode);
    return several ? tr("%1, slot %2").arg(what).arg(setPoint.slot) : what;
}

void TunePage::showCommands()
{
    const DeviceView *view = device();
    if (!view || view->id != m_shown)
        return;
    const PageStatus now = status();
    m_status->say(now, m_frame->isCompact());
    m_jogPanel->setPossible(m_arming.state() == LampState::Armed && jogSetPoint(true),
        m_arming.isArmed(view->id) ? tr("Something moves") : tr("Hold the Arm button for 1 s to arm it first."));
    const Choice &chosen = *choice();
    const QStringList staged = m_gains->stagedNames();
    const bool withGains = !staged.isEmpty() && chosen.editedSlot == chosen.runningSlot;
    const bool moving = isAxisMoving(*view, m_axis);
    const auto together = m_axes->together().size();
    m_run->setText(withGains     ? tr("Write and run")
            : together > 1       ? tr("Run %1 axes").arg(together)
            : moving && isLive() ? tr("Apply")
                                 : tr("Run"));
    m_run->setEnabled(now.mayRun);
    m_run->setToolTip(now.mayRun ? QString() : now.cause + QStringLiteral(": ") + now.remedy);
    setSpoken(*m_run, m_run->text(), m_run->toolTip());
    m_halt->setEnabled(moving || m_arming.isOnTrial());
    const bool others = view->motion.setPoints.size() > 1 && together < 2;
    const QString stop = moving && m_axis > 0 && others ? tr("Stop axis %1").arg(m_axis) : tr("Stop motion");
    m_halt->setText(m_frame->isCompact() ? QString() : stop);
    setSpoken(*m_halt, stop, m_halt->accessibleDescription());
    const bool several = view->family->capabilities.gainSlots > 1;
    const QString names
        = staged.size() > 3 ? tr("%n value(s)", nullptr, staged.size()) : staged.join(QStringLiteral(", "));
    m_write->setText(staged.isEmpty() ? tr("Nothing to write")
            : several                 ? tr("Write %1 to slot %2").arg(names).arg(chosen.editedSlot)
                                      : tr("Write %1").arg(names));
    const bool free = view->liveness.heard && view->busy.empty() && !m_writing
        && !isRunning(m_workbench.snapshot().operation(view->id));
    m_write->setEnabled(!staged.isEmpty() && free && !m_gains->hasFault());
    m_write->setToolTip(m_gains->hasFault() ? tr("A gain is out of range")
            : staged.isEmpty()              ? tr("No gain is edited")
            : free                          ? QString()
                                            : tr("The device is busy"));
    m_revert->setEnabled(!staged.isEmpty() || m_gains->hasFault() || !m_gains->unconfirmed().isEmpty());
}

} // namespace mb
