// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/tuneexperiments.h"

#include "experiment/gains.h"
#include "experiment/kepttrial.h"
#include "widgets/common/axistext.h"
#include "widgets/common/devicetext.h"
#include "widgets/control/batterydialog.h"
#include "widgets/control/envelopepanel.h"
#include "widgets/control/gainspanel.h"
#include "widgets/control/gainunits.h"
#include "widgets/control/trialsview.h"
#include "widgets/control/tunecolumn.h"
#include "widgets/control/tunecommands.h"
#include "widgets/report/reportorder.h"

#include <QPointer>

#include <algorithm>
#include <cmath>

namespace mb {

TuneExperiments::TuneExperiments(
    const Surroundings &surroundings, const TuneParts &parts, const ThemeSource &theme, QWidget &page)
    : m_workbench(surroundings.workbench)
    , m_arming(surroundings.arming)
    , m_choices(surroundings.choices)
    , m_motion(surroundings.motion)
    , m_gains(surroundings.gains)
    , m_parts(parts)
    , m_theme(theme)
    , m_page(page)
{
}

ExperimentWish TuneExperiments::wishOf(const DeviceView &view, int axis) const
{
    const TuneChoice &chosen = *m_choices.find({view.id, axis});
    ExperimentWish wish;
    wish.mode = chosen.mode;
    wish.axis = std::max(axis, 1);
    wish.slot = chosen.runningSlot;
    wish.stimulus = chosen.stimulus;
    wish.limits = m_parts.column->envelope().entered();
    wish.limitsFault = m_parts.column->envelope().fault();
    if (axis == m_choices.axis() && chosen.editedSlot == chosen.runningSlot)
        wish.gains = m_parts.column->gainsPanel().toWrite();
    return wish;
}

ExperimentCheck TuneExperiments::check(const DeviceView &view, const ExperimentWish &wish) const
{
    return checkExperiment(view, wish, m_choices.current()->units, m_workbench.presentOf(view.link));
}

void TuneExperiments::follow(const DeviceView &view)
{
    TuneChoice &chosen = *m_choices.current();
    StimulusBar &stimulus = *m_parts.stimulus;
    EnvelopePanel &envelope = m_parts.column->envelope();
    const int axis = m_choices.axis();
    if (chosen.unit.empty() || !view.identity->serial.empty()) // a scan may forget it for a moment
        chosen.unit = view.unit;
    envelope.choose(chosen.unit, true);
    m_parts.trials->choose(view.family, chosen.unit, std::max(axis, 1), chosen.mode);
    stimulus.setUnits(chosen.mode, chosen.units);
    if (!chosen.stimulus.to && view.liveness.heard && stimulus.fault().isEmpty())
        chosen.stimulus = usualStimulus(view, wishOf(view, axis), chosen.units, m_workbench.presentOf(view.link));
    stimulus.setChoice(chosen.stimulus);
    const ExperimentCheck found = check(view, wishOf(view, axis));
    stimulus.setEnabled(found.possible);
    envelope.setInForce(found.inForce, found.missing);
    if (m_page.isVisible() && !m_parts.commands->isLive())
        checkKinds(view);
    const QString fault = stimulus.fault();
    stimulus.setVerdict(fault.isEmpty() && found.good, fault.isEmpty() ? found.words : fault);
    if (m_battery)
        m_battery->followOffer();
}

/// Each kind of stimulus with the values as they are, so that the list says which would leave the envelope. The one that is
/// chosen stays: what is wrong with it stands beside it, and at Run.
void TuneExperiments::checkKinds(const DeviceView &view)
{
    StimulusBar &stimulus = *m_parts.stimulus;
    ExperimentWish wish = wishOf(view, m_choices.axis());
    const bool open = !wish.stimulus.to || !stimulus.fault().isEmpty();
    const tuning::Profile chosen = wish.stimulus.profile;
    for (const tuning::Profile kind : StimulusBar::kinds()) {
        wish.stimulus.profile = kind;
        const bool free = open || kind == chosen;
        const ExperimentCheck found = free ? ExperimentCheck{} : check(view, wish);
        const bool fits = free || found.good || !found.possible || !found.missing.isEmpty();
        stimulus.setKindFault(kind, fits ? QString() : found.words);
    }
}

PageStatus TuneExperiments::status(const DeviceView &view, const QString &name) const
{
    if (m_arming.isOnTrial(view.id)) {
        const OperationView *const operation = m_workbench.snapshot().operation(view.id);
        const QString step = operation ? messageText(operation->status.step) : QString();
        return {GlyphState::Moving, tr("Experiment"), step, false};
    }
    if (m_arming.isMoving())
        return {GlyphState::Moving, tr("Moving"), tr("Stop the motion before an experiment."), false};
    if (const QString fault = m_parts.stimulus->fault(); !fault.isEmpty())
        return {GlyphState::OutOfRange, tr("The stimulus cannot be sent"), fault, false};
    for (const int axis : m_parts.column->motorsToRun()) {
        if (axis != m_choices.axis() && m_choices.current()->mode == Mode::Position
            && !m_motion.present(view, Mode::Position, axis))
            return {GlyphState::Busy, tr("The position of axis %1 is not known yet").arg(axis), {}, false};
    }
    const ExperimentCheck found = check(view, wishOf(view, m_choices.axis()));
    if (!found.good)
        return {GlyphState::Warning, found.possible ? tr("No experiment yet") : tr("No experiment in this mode"),
            found.words, false};
    if (m_arming.isArmed(view.id))
        return {GlyphState::Online, tr("Armed"), tr("Run begins the experiment."), true};
    return {GlyphState::Gone, tr("Not armed"), tr("Hold the Arm button for 1 s to arm %1.").arg(name), false};
}

void TuneExperiments::run()
{
    const DeviceView *const view = m_choices.device();
    if (!view)
        return;
    const std::vector<ParameterChange> all = wishOf(*view, m_choices.axis()).gains;
    const bool isWritten = tuning::triable(*view->family, all).size() < all.size();
    m_turns.clear();
    for (const int axis : m_parts.column->motorsToRun()) {
        if (axis != m_choices.axis())
            handOver(*view, axis);
        m_turns.emplace_back(axis, wishOf(*view, axis));
        if (isWritten)
            m_turns.back().second.gains.clear();
    }
    if (isWritten)
        m_gains.write([this] { runNext(); });
    else
        runNext();
}

/// The experiment of the axis that is shown for another one: as far from where each is, in position mode.
void TuneExperiments::handOver(const DeviceView &view, int axis)
{
    const TuneChoice &shown = *m_choices.current();
    TuneChoice &other = m_choices.of(view, axis);
    other.mode = shown.mode;
    other.stimulus = shown.stimulus;
    if (shown.mode != Mode::Position)
        return;
    const double here = m_motion.present(view, shown.mode, m_choices.axis()).value_or(0.0);
    if (other.stimulus.to)
        *other.stimulus.to += std::round(m_motion.present(view, shown.mode, axis).value_or(0.0) - here);
    other.stimulus.from.reset();
}

void TuneExperiments::runNext()
{
    const DeviceView *const view = m_choices.device();
    if (!view || m_turns.empty())
        return;
    auto [axis, wish] = std::move(m_turns.front());
    m_turns.erase(m_turns.begin());
    wish.limits = m_parts.column->envelope().entered(); // those of a unit hold at once
    const auto ifShown = [self = QPointer<TuneExperiments>(this), motor = TuneMotor{view->id, axis}](auto &&act) {
        if (self && self->m_choices.shown() == motor)
            act(*self->m_parts.trials);
    };
    m_arming.runTrial(
        planOf(*view, wish),
        [ifShown](
            const tuning::Trial &trial) { ifShown([&trial](TrialsView &trials) { trials.showMeasured(trial); }); },
        [self = QPointer<TuneExperiments>(this), ifShown, number = m_arming.armingNumber()](
            const Result<tuning::Trial> &trial) {
            if (trial)
                ifShown([&trial](TrialsView &trials) { trials.addFinished(*trial); });
            if (self)
                self->ended(trial, number);
        });
    Q_EMIT changed();
}

void TuneExperiments::ended(const Result<tuning::Trial> &trial, std::uint64_t armingNumber)
{
    const DeviceView *const view = m_choices.device();
    const bool goesOn = trial && trial->mayGoOn() && view && m_arming.isArmed(view->id)
        && m_arming.armingNumber() == armingNumber && !m_turns.empty();
    if (!goesOn)
        m_turns.clear();
    Q_EMIT changed();
    if (goesOn)
        runNext();
}

BatteryOffer TuneExperiments::batteryNow() const
{
    const DeviceView *const view = m_choices.device();
    const TuneChoice *const chosen = m_choices.current();
    BatteryOffer offer;
    offer.whyNot = !view || !chosen ? tr("no device") : m_parts.stimulus->fault();
    if (!offer.whyNot.isEmpty())
        return offer;
    ExperimentWish wish = wishOf(*view, m_choices.axis());
    wish.gains.clear(); // what is staged is no part of it
    const std::optional<double> here = m_motion.present(*view, wish.mode, m_choices.axis());
    if (const ExperimentCheck found = check(*view, wish); !found.good || !wish.stimulus.to)
        offer.whyNot = found.words;
    else if (!here && wish.mode == Mode::Position && !view->family->capabilities.zeroPosition)
        offer.whyNot = tr("its position is not known yet");
    if (!offer.whyNot.isEmpty())
        return offer;
    offer.device = view->id;
    offer.motor = motorTitle(*view, m_choices.axis());
    offer.battery = tuning::batteryOf(planOf(*view, wish), here.value_or(0.0), view->family->capabilities.zeroPosition);
    const std::string_view unit = unitOf(wish.mode);
    offer.unit = QString::fromUtf8(unit.data(), static_cast<int>(unit.size()));
    return offer;
}

void TuneExperiments::showBattery()
{
    if (!batteryNow().whyNot.isEmpty())
        return; // the page says it
    if (!m_battery)
        m_battery = new BatteryDialog(
            m_arming, [this] { return batteryNow(); }, m_theme, &m_page);
    m_battery->showOffer();
    m_battery->show();
    m_battery->raise();
    m_battery->activateWindow();
}

void TuneExperiments::writeReport()
{
    const DeviceView *const view = m_choices.device();
    if (!view)
        return;
    ReportWish wish;
    for (const KeptTrial *const shown : {m_parts.trials->a(), m_parts.trials->b()}) {
        if (shown && shown->number > 0) // it is kept
            wish.trials.push_back(shown->number);
    }
    if (!m_report)
        m_report = new ReportOrder(m_workbench, m_page);
    m_report->ask(*view, wish);
}

} // namespace mb
