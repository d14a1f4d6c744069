// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/tunepage.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/iconbutton.h"
#include "widgets/control/gainspanel.h"
#include "widgets/control/modepanel.h"
#include "widgets/control/setpointpanel.h"
#include "widgets/control/steptable.h"
#include "widgets/control/tuneplot.h"

#include <QPointer>

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

void TunePage::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    constexpr int roomy = 760;
    m_steps->setRows(height() > m_theme.theme().u(roomy) ? 4 : 3);
}

SetPoint TunePage::wanted() const
{
    SetPoint setPoint;
    m_setPoint->apply(setPoint);
    setPoint.slot = m_modes->runningSlot();
    return setPoint;
}

std::optional<double> TunePage::present(const DeviceView &view) const
{
    const Quantity quantity = quantityOf(m_setPoint->mode());
    if (quantity == Quantity::Voltage) // of the supply, not of the motor
        return std::nullopt;
    for (const Channel &channel : view.family->channels) {
        if (channel.quantity == quantity)
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
    disarmBecause(tr("the mode"));
    if (Choice *chosen = choice())
        chosen->mode = mode;
    m_setPoint->setMode(mode);
    follow();
}

void TunePage::slotsChosen()
{
    if (Choice *chosen = choice()) {
        chosen->editedSlot = m_modes->editedSlot();
        chosen->runningSlot = m_modes->runningSlot();
    }
    follow();
}

void TunePage::unitsChosen(const DisplayUnits &units)
{
    if (Choice *chosen = choice())
        chosen->units = units;
    m_setPoint->setUnits(units);
    m_gains->setUnits(units);
    m_steps->setUnits(units);
    follow();
}

void TunePage::run()
{
    const Status now = status();
    if (!now.mayRun) {
        m_workbench.report(Severity::Caution, {}, tr("not run: %1. %2").arg(now.cause, now.remedy));
        return;
    }
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
    const std::vector<ParameterChange> changes = m_gains->toWrite();
    m_writing = true;
    m_workbench.writeParameters(
        target, changes, [self = QPointer<TunePage>(this), target, changes, next](const Result<void> &result) {
            if (!self)
                return;
            self->m_writing = false;
            const auto found = self->m_choices.find(target);
            if (result && found != self->m_choices.end())
                found->second.edits->settle(changes);
            self->follow();
            if (!result)
                self->m_workbench.report(
                    Severity::Danger, {}, tr("gains not written: %1").arg(errorText(result.error())));
            else if (next && self->m_shown == target && self->m_arming.isArmed(target))
                next();
        });
    showCommands();
}

void TunePage::halt()
{
    m_slewTimer.stop();
    if (m_arming.isArmed(m_shown))
        m_arming.halt();
}

void TunePage::zero()
{
    const DeviceView *view = device();
    if (!view || view->id != m_shown)
        return;
    halt();
    m_workbench.zeroPosition(m_shown,
        [self = QPointer<TunePage>(this), target = m_shown, name = titleOf(*view)](const Result<void> &result) {
            if (!self || !result) // the engine says what went wrong
                return;
            self->m_workbench.report(Severity::Good, name, tr("position 0 is here; the motor is off until Run"));
            if (self->m_shown == target)
                self->m_setPoint->forgetTargets();
        });
}

/// tuning.md 5.6: the first set-point is where the motor is, then no faster than the hand's limit. A step of another
/// quantity than position goes out at once.
void TunePage::start()
{
    const DeviceView *view = device();
    const auto target = m_setPoint->target();
    if (!view || !target || !m_arming.isArmed(view->id))
        return;
    const bool moving = m_arming.isMoving();
    m_base = wanted();
    m_slew.setRate(m_setPoint->slewRate());
    if (!moving || !m_slewTimer.isActive())
        m_slew.start(whereItIs(*view), m_workbench.now());
    m_slew.setTarget(*target);
    m_setPoint->keepTarget();
    if (moving && m_slewTimer.isActive())
        return; // it takes the new target along
    m_ours = true;
    const bool careful = m_base.mode == Mode::Position || m_setPoint->slewRate() > 0.0;
    send(!moving && careful && m_base.mode != Mode::Follow ? m_slew.value() : m_slew.advance(m_workbench.now()));
    if (moving || !m_slew.isThere())
        m_slewTimer.start();
}

/// Where a new set-point starts from.
double TunePage::whereItIs(const DeviceView &view) const
{
    if (m_arming.isMoving() && m_ours)
        return m_slew.value();
    if (m_arming.isMoving() && view.motion.setPoint.mode == m_setPoint->mode())
        return view.motion.setPoint.target;
    return present(view).value_or(0.0);
}

void TunePage::applyTarget()
{
    if (m_arming.isMoving() && status().mayRun)
        start();
}

void TunePage::slewTick()
{
    const bool news = !m_slew.isThere() || m_base.target != m_slew.value();
    if (m_arming.isMoving() && news)
        send(m_slew.advance(m_workbench.now()));
    if (!m_arming.isMoving() || m_slew.isThere())
        m_slewTimer.stop();
}

void TunePage::send(double target)
{
    m_base.target = target;
    m_arming.run(m_base);
}

void TunePage::followForeignRun(const DeviceView &view)
{
    const bool moving = m_arming.isMoving() && m_arming.device() == view.id && view.motion.running;
    if (!moving || m_ours || view.motion.setPoint.mode != m_setPoint->mode())
        return;
    if (m_setPoint->target() != view.motion.setPoint.target)
        m_setPoint->showTarget(view.motion.setPoint.target);
}

} // namespace mb
