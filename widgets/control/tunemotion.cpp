// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/tunemotion.h"

#include "model/axis.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/displayunits.h"
#include "widgets/common/guarded.h"
#include "widgets/common/livetext.h"
#include "widgets/common/numberformat.h"
#include "widgets/control/axespanel.h"
#include "widgets/control/gainunits.h"
#include "widgets/control/modepanel.h"
#include "widgets/control/setpointpanel.h"
#include "widgets/control/tunecolumn.h"

#include <QApplication>

#include <algorithm>
#include <cmath>

namespace mb {

TuneMotion::TuneMotion(Workbench &workbench, Arming &arming, TuneChoices &choices, TuneColumn &column)
    : m_workbench(workbench)
    , m_arming(arming)
    , m_choices(choices)
    , m_column(column)
{
}

std::optional<double> TuneMotion::present(const DeviceView &view, Mode mode, int axis) const
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

/// For the motor that is shown.
SetPoint TuneMotion::entered() const
{
    SetPoint setPoint;
    m_column.setPointPanel().apply(setPoint);
    setPoint.slot = m_column.modePanel().runningSlot();
    setPoint.axis = std::max(m_choices.axis(), 1);
    return setPoint;
}

SetPoint TuneMotion::wanted(const DeviceView &view, int axis) const
{
    if (axis == m_choices.axis())
        return entered();
    const TuneChoice &chosen = *m_choices.find({view.id, axis});
    SetPoint setPoint;
    setPoint.axis = axis;
    setPoint.mode = chosen.mode;
    const SetPointEntries::Range range = chosen.entered.range(chosen.mode);
    setPoint.target = range.target;
    if (!range.touched && startsAtPresent(chosen.mode))                                        // so that nothing jumps
        setPoint.target = std::round(present(view, chosen.mode, axis).value_or(range.target)); // hasNoStart() otherwise
    if (isProfiled(view.family, chosen.mode)) {
        setPoint.velocity = chosen.entered.velocity;
        setPoint.acceleration = chosen.entered.acceleration;
    }
    return setPoint;
}

std::optional<SetPoint> TuneMotion::jog(bool forwards) const
{
    constexpr double gentleDuty = 0.08;
    constexpr double slowly = 200.0; // counts/s
    const DeviceView *const view = m_choices.device();
    if (!view || view->id != m_choices.shown().device || !m_arming.isArmed(view->id))
        return std::nullopt;
    const auto has
        = [view](Mode mode) { return std::ranges::find(view->family->modes, mode) != view->family->modes.end(); };
    if (!has(Mode::Duty) && !has(Mode::Velocity))
        return std::nullopt;
    SetPoint setPoint;
    setPoint.axis = std::max(m_choices.axis(), 1);
    setPoint.slot = m_column.modePanel().runningSlot();
    setPoint.mode = has(Mode::Duty) ? Mode::Duty : Mode::Velocity;
    setPoint.target = (has(Mode::Duty) ? gentleDuty : slowly) * (forwards ? 1.0 : -1.0);
    if (view->family->capabilities.output.brake)
        setPoint.brake = true;
    return setPoint;
}

void TuneMotion::start()
{
    const DeviceView *const view = m_choices.device();
    SetPointPanel &panel = m_column.setPointPanel();
    if (!view || !panel.target() || !m_arming.isArmed(view->id))
        return;
    panel.keepTarget();
    m_choices.current()->entered = panel.entered();
    const std::vector<int> axes = m_column.motorsToRun();
    for (const int axis : axes)
        startAxis(*view, axis, axes.size() > 1);
}

/// An unknown position is no 0: the first set-point would be a leap.
bool TuneMotion::hasNoStart(const DeviceView &view, int axis) const
{
    const TuneChoice *const chosen = m_choices.find({view.id, axis});
    return chosen && startsAtPresent(chosen->mode) && !present(view, chosen->mode, axis);
}

void TuneMotion::startAxis(const DeviceView &view, int axis, bool several)
{
    TuneChoice &chosen = m_choices.of(view, axis);
    const SetPointPanel &panel = m_column.setPointPanel();
    const SetPoint wished = wanted(view, axis);
    Glide glide;
    if (wished.mode != Mode::Follow) {
        glide.rate = axis == m_choices.axis() ? panel.slewRate() : chosen.entered.slewRate(view.family, wished.mode);
        if (several || wished.mode == Mode::Position || glide.rate > 0.0)
            glide.from = present(view, wished.mode, axis);
        if (!glide.from && !startsAtPresent(wished.mode)) // what the motor is told before is nothing
            glide.from = 0.0;
    }
    chosen.ours = true;
    m_arming.run(wished, glide);
}

void TuneMotion::halt()
{
    const DeviceView *const view = m_choices.device();
    if (!view || !m_arming.isArmed(m_choices.shown().device))
        return;
    const std::vector<int> stopped = m_column.axesPanel().together();
    const auto &all = view->motion.setPoints;
    const bool goesOn = m_choices.axis() > 0 && std::ranges::any_of(all, [&](const SetPoint &setPoint) {
        return std::ranges::find(stopped, setPoint.axis) == stopped.end();
    });
    if (m_arming.isOnTrial(view->id) || !goesOn) {
        m_choices.forgetMotion();
        m_arming.halt();
        return;
    }
    for (const int axis : stopped) {
        m_choices.of(*view, axis).ours = false;
        m_arming.haltAxis(axis);
    }
}

void TuneMotion::zero()
{
    const DeviceView *const view = m_choices.device();
    if (!view || view->id != m_choices.shown().device)
        return;
    m_workbench.send(
        orders::ZeroPosition{view->id}, guarded(this, [this, name = titleOf(*view)](const Result<void> &result) {
            if (result) // the engine says what went wrong
                m_workbench.report(Severity::Good, name, tr("position 0 is here; the motor is off until Run"));
        }));
}

void TuneMotion::identify()
{
    const DeviceView *const view = m_choices.device();
    if (!view)
        return;
    if (!view->family->capabilities.identify) { // its shaft would turn, and that is asked for elsewhere
        m_workbench.report(Severity::Info, titleOf(*view), tr("it has no lamp that could blink"));
        return;
    }
    m_workbench.send(
        orders::Identify{view->id}, guarded(this, [this, name = titleOf(*view)](const Result<void> &result) {
            if (!result)
                m_workbench.report(Severity::Caution, name, tr("not identified: %1").arg(errorText(result.error())));
        }));
}

void TuneMotion::disarmBecause(const QString &what)
{
    if (!m_arming.isArmed(m_choices.shown().device))
        return;
    const DeviceView *const view = m_choices.device();
    m_workbench.report(Severity::Info, view ? titleOf(*view) : QString(), tr("disarmed: %1 changed").arg(what));
    m_arming.disarm();
}

bool TuneMotion::isMoving(const DeviceView &view, int axis) const
{
    if (!m_arming.isMoving() || !m_arming.isArmed(view.id))
        return false;
    const TuneChoice *const chosen = m_choices.find({view.id, axis});
    return axis == 0 || view.motion.on(axis) || (chosen && chosen->ours);
}

void TuneMotion::follow(const DeviceView &view)
{
    SetPointPanel &panel = m_column.setPointPanel();
    if (m_choices.forgetPlaces(view))
        panel.forgetTargets();
    panel.showPresent(present(view, m_choices.current()->mode, m_choices.axis()));
    followForeignRun(view);
}

void TuneMotion::followForeignRun(const DeviceView &view)
{
    SetPointPanel &panel = m_column.setPointPanel();
    const bool moving = m_arming.isMoving() && m_arming.device() == view.id && view.motion.running;
    const SetPoint *const told = m_choices.axis() > 0 ? view.motion.on(m_choices.axis()) : &view.motion.setPoint;
    const TuneChoice &chosen = *m_choices.current();
    if (!moving || !told || told->relative || chosen.ours || told->mode != chosen.mode) {
        m_foreign.reset();
        return;
    }
    const std::pair<TuneMotor, double> foreign{m_choices.shown(), told->target};
    if (m_foreign == foreign)
        return;
    m_foreign = foreign;
    const bool isTyped = panel.entered().range(chosen.mode).touched && panel.isAncestorOf(QApplication::focusWidget());
    if (panel.target() != told->target && !isTyped)
        panel.showTarget(told->target);
}

PageStatus TuneMotion::status(const DeviceView &view, const QString &name) const
{
    const int axis = m_choices.axis();
    const SetPoint *told = axis > 0 ? view.motion.on(axis) : view.motion.running ? &view.motion.setPoint : nullptr;
    for (const int motor : m_column.motorsToRun()) {
        if (hasNoStart(view, motor))
            return {GlyphState::Busy, tr("Its position is not known yet"),
                tr("It starts where it is once it has told where that is."), false};
    }
    const QString others = othersText(view);
    if (isMoving(view, axis))
        return {GlyphState::Moving, tr("Moving"), describe(told ? *told : entered()) + others, true};
    if (m_arming.isArmed(view.id))
        return {GlyphState::Online, tr("Armed"), tr("Run begins %1").arg(describe(entered())) + others, true};
    return {GlyphState::Gone, tr("Not armed"), tr("Hold the Arm button for 1 s to arm %1.").arg(name), false};
}

QString TuneMotion::describe(const SetPoint &setPoint) const
{
    const TuneChoice *const chosen = m_choices.current();
    const ShownUnit unit = shownUnit(setPoint.mode, chosen ? chosen->units : DisplayUnits{});
    const double number = setPoint.target * unit.scale;
    const int decimals = number == std::round(number) ? 0 : unit.scale == 1.0 && unit.decimals == 0 ? 0 : 1;
    const QString target
        = setPoint.mode == Mode::Follow ? QStringLiteral("#%1").arg(number) : formatValue(number, decimals, unit.text);
    const QString mode = modeText(setPoint.mode);
    const QString what = !setPoint.relative ? mode + QLatin1Char(' ') + target
        : setPoint.target == 0.0            ? tr("%1: holds").arg(mode)
                                            : tr("%1 by %2").arg(mode, target);
    const DeviceView *const view = m_choices.device();
    if (m_choices.axis() > 0)
        return tr("axis %1: %2").arg(setPoint.axis).arg(what);
    const bool several = view && view->family->capabilities.gainSlots > 1 && isClosedLoop(setPoint.mode);
    return several ? tr("%1, slot %2").arg(what).arg(setPoint.slot) : what;
}

/// " · axis 1, 3 move, too"; empty where nothing else runs.
QString TuneMotion::othersText(const DeviceView &view) const
{
    QStringList others;
    for (const SetPoint &setPoint : view.motion.setPoints) {
        if (m_choices.axis() > 0 && view.motion.running && setPoint.axis != m_choices.axis())
            others << QString::number(setPoint.axis);
    }
    others.sort();
    return others.isEmpty() ? QString() : tr(" · also moving: axis %1").arg(others.join(QStringLiteral(", ")));
}

} // namespace mb
