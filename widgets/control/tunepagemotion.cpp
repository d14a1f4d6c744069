// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/tunepage.h"

#include "model/axis.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/iconbutton.h"
#include "widgets/control/axespanel.h"
#include "widgets/control/envelopepanel.h"
#include "widgets/control/gainspanel.h"
#include "widgets/control/modepanel.h"
#include "widgets/control/responseplot.h"
#include "widgets/control/setpointpanel.h"
#include "widgets/control/stimulusbar.h"
#include "widgets/control/trialsview.h"
#include "widgets/control/tuneplot.h"
#include "widgets/plots/plotstack.h"

#include <QPointer>

#include <algorithm>

namespace mb {

void TunePage::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    follow();
}

void TunePage::hideEvent(QHideEvent *event)
{
    QWidget::hideEvent(event);
    wishRates(nullptr);
}

SetPoint TunePage::wanted() const
{
    SetPoint setPoint;
    m_setPoint->apply(setPoint);
    setPoint.slot = m_modes->runningSlot();
    setPoint.axis = std::max(m_axis, 1);
    return setPoint;
}

/// Gently, without a loop where the device can: for as long as J or K is held.
std::optional<SetPoint> TunePage::jogSetPoint(bool forwards) const
{
    constexpr double gentleDuty = 0.08;
    constexpr double slowly = 200.0; // counts/s
    const DeviceView *const view = device();
    if (!view || view->id != m_shown || !m_arming.isArmed(view->id))
        return std::nullopt;
    const auto has = [view](Mode mode) {
        return std::find(view->family->modes.begin(), view->family->modes.end(), mode) != view->family->modes.end();
    };
    if (!has(Mode::Duty) && !has(Mode::Velocity))
        return std::nullopt;
    SetPoint setPoint;
    setPoint.axis = std::max(m_axis, 1);
    setPoint.slot = m_modes->runningSlot();
    setPoint.mode = has(Mode::Duty) ? Mode::Duty : Mode::Velocity;
    setPoint.target = (has(Mode::Duty) ? gentleDuty : slowly) * (forwards ? 1.0 : -1.0);
    setPoint.brake = view->family->capabilities.outputOptions;
    return setPoint;
}

void TunePage::identify()
{
    const DeviceView *const view = device();
    if (!view)
        return;
    if (!view->family->capabilities.identify) { // its shaft would turn, and that is asked for elsewhere
        m_workbench.report(Severity::Info, titleOf(*view), tr("it has no lamp that could blink"));
        return;
    }
    m_workbench.send(orders::Identify{view->id},
        [self = QPointer<TunePage>(this), name = titleOf(*view)](const Result<void> &result) {
            if (self && !result)
                self->m_workbench.report(
                    Severity::Caution, name, tr("not identified: %1").arg(errorText(result.error())));
        });
}

void TunePage::pauseLive()
{
    if (isLive())
        m_plot->stack().view().setLive(!m_plot->stack().view().isLive());
}

PlotStack &TunePage::shownStack()
{
    return isLive() ? m_plot->stack() : m_trials->plot().stack();
}

std::optional<double> TunePage::present(const DeviceView &view, Mode mode, int axis) const
{
    const Quantity quantity = quantityOf(mode);
    if (quantity == Quantity::Voltage) // of the supply, not of the motor
        return std::nullopt;
    for (const Channel &channel : view.family->channels) {
        if (channel.quantity == quantity && axisOf(channel.key) == axis)
            return liveValue(view, channel.key, m_workbench.presentOf(view.link));
    }
    return std::nullopt;
}

void TunePage::disarmBecause(const QString &what)
{
    if (!m_arming.isArmed(m_shown))
        return;
    const DeviceView *view = device();
    m_workbench.report(Severity::Info, view ? titleOf(*view) : QString(), tr("disarmed: %1 changed").arg(what));
    m_arming.disarm();
}

void TunePage::modeChosen(Mode mode)
{
    const DeviceView *view = device();
    const bool rests = view && m_axis > 0 && m_arming.isMoving() && !isAxisMoving(*view, m_axis);
    if (!rests) // what other axes do is not changed by it
        disarmBecause(tr("the mode"));
    if (Choice *chosen = choice())
        chosen->mode = mode;
    m_setPoint->setMode(mode);
    follow();
}

void TunePage::choose(Mode mode, double target)
{
    const Choice *chosen = choice();
    if (!chosen)
        return;
    m_modes->show(mode, chosen->editedSlot, chosen->runningSlot);
    if (chosen->mode != m_modes->mode())
        modeChosen(m_modes->mode());
    m_setPoint->showTarget(target);
    m_setPoint->keepTarget();
    showCommands();
}

void TunePage::slotsChosen()
{
    if (Choice *chosen = choice()) {
        chosen->editedSlot = m_modes->editedSlot();
        chosen->runningSlot = m_modes->runningSlot();
    }
    follow();
}

void TunePage::setRevolutions(bool on)
{
    m_revolutions = on;
    for (auto &[place, chosen] : m_choices)
        chosen.units.revolutions = on;
    if (const Choice *shown = choice()) {
        m_plot->setUnits(shown->units);
        unitsChosen(DisplayUnits(shown->units));
    }
}

void TunePage::unitsChosen(const DisplayUnits &units)
{
    if (Choice *chosen = choice())
        chosen->units = units;
    m_setPoint->setUnits(units);
    m_gains->setUnits(units);
    m_trials->setUnits(units);
    m_stimulus->setUnits(m_modes->mode(), units);
    m_envelope->setUnits(units);
    follow();
}

void TunePage::run()
{
    const PageStatus now = status();
    if (!now.mayRun) {
        m_workbench.report(Severity::Caution, {}, tr("not run: %1. %2").arg(now.cause, now.remedy));
        return;
    }
    if (!isLive())
        return tryOut();
    const Choice *chosen = choice();
    if (chosen->editedSlot == chosen->runningSlot && !m_gains->toWrite().empty())
        writeThen([this] { start(); });
    else
        start();
}

void TunePage::write()
{
    if (m_write->isEnabled())
        writeThen({});
}

void TunePage::writeThen(std::function<void()> next)
{
    const DeviceId target = m_shown;
    const Place place{m_shown, m_axis};
    const std::vector<ParameterChange> changes = m_gains->toWrite();
    m_writing = true;
    m_workbench.send(orders::WriteParameters{target, changes},
        [self = QPointer<TunePage>(this), place, target, changes, next](const Result<void> &result) {
            if (!self)
                return;
            self->m_writing = false;
            const auto found = self->m_choices.find(place);
            if (result && found != self->m_choices.end())
                found->second.edits->settle(changes);
            self->follow();
            if (!result)
                self->m_workbench.report(
                    Severity::Danger, {}, tr("gains not written: %1").arg(errorText(result.error())));
            else if (next && Place{self->m_shown, self->m_axis} == place && self->m_arming.isArmed(target))
                next();
        });
    showCommands();
}

/// Of a board: what Run has started, the axis that is shown or all that are ticked.
void TunePage::halt()
{
    const DeviceView *view = device();
    if (!view || !m_arming.isArmed(m_shown))
        return;
    m_toTry.clear();
    if (m_arming.isOnTrial())
        return m_arming.halt();
    const std::vector<int> stopped = m_axes->together();
    const auto &all = view->motion.setPoints;
    const bool goesOn = m_axis > 0 && std::any_of(all.begin(), all.end(), [&](const SetPoint &setPoint) {
        return std::find(stopped.begin(), stopped.end(), setPoint.axis) == stopped.end();
    });
    if (!goesOn) {
        forgetMotion();
        m_arming.halt();
        return;
    }
    for (const int axis : stopped) {
        Choice &chosen = choiceOf(*view, axis);
        chosen.ours = false;
        m_arming.haltAxis(axis);
    }
}

void TunePage::forgetMotion()
{
    for (auto &[place, chosen] : m_choices)
        chosen.ours = false;
}

bool TunePage::isAxisMoving(const DeviceView &view, int axis) const
{
    if (!m_arming.isMoving() || !m_arming.isArmed(view.id))
        return false;
    const auto chosen = m_choices.find({view.id, axis});
    return axis == 0 || view.motion.on(axis) || (chosen != m_choices.end() && chosen->second.ours);
}

void TunePage::zero()
{
    const DeviceView *view = device();
    if (!view || view->id != m_shown)
        return;
    halt();
    m_workbench.send(orders::ZeroPosition{m_shown},
        [self = QPointer<TunePage>(this), target = m_shown, name = titleOf(*view)](const Result<void> &result) {
            if (!self || !result) // the engine says what went wrong
                return;
            self->m_workbench.report(Severity::Good, name, tr("position 0 is here; the motor is off until Run"));
            if (self->m_shown == target)
                self->m_setPoint->forgetTargets();
        });
}

/// The first set-point is where the motor is, then no faster than the hand's limit. A step of another quantity than position
/// goes out at once; of several axes, once each holds where it is.
void TunePage::start()
{
    const DeviceView *view = device();
    if (!view || !m_setPoint->target() || !m_arming.isArmed(view->id))
        return;
    choice()->entered = m_setPoint->entered();
    const std::vector<int> axes = m_axis > 0 ? m_axes->together() : std::vector{0};
    for (const int axis : axes)
        startAxis(*view, axis, axes.size() > 1);
    m_setPoint->keepTarget();
}

void TunePage::startAxis(const DeviceView &view, int axis, bool several)
{
    Choice &chosen = choiceOf(view, axis);
    const SetPoint wished = axis == m_axis ? wanted() : wantedOf(view, axis);
    Glide glide;
    if (wished.mode != Mode::Follow) {
        glide.rate = axis == m_axis ? m_setPoint->slewRate() : m_setPoint->slewRate(chosen.entered, wished.mode);
        if (several || wished.mode == Mode::Position || glide.rate > 0.0)
            glide.from = present(view, wished.mode, axis).value_or(0.0);
    }
    chosen.ours = true;
    m_arming.run(wished, glide);
}

void TunePage::applyTarget()
{
    if (m_arming.isMoving() && status().mayRun)
        start();
}

void TunePage::followForeignRun(const DeviceView &view)
{
    const bool moving = m_arming.isMoving() && m_arming.device() == view.id && view.motion.running;
    const SetPoint *told = m_axis > 0 ? view.motion.on(m_axis) : &view.motion.setPoint;
    if (!moving || !told || choice()->ours || told->mode != m_setPoint->mode())
        return;
    if (m_setPoint->target() != told->target)
        m_setPoint->showTarget(told->target);
}

} // namespace mb
