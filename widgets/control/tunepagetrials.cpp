// SPDX-License-Identifier: GPL-3.0-or-later
// Experiments of the page: what is asked for, whether it may run, what came of it.
#include "tuning/verdict.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/numberformat.h"
#include "widgets/common/segmented.h"
#include "widgets/control/axespanel.h"
#include "widgets/control/batterydialog.h"
#include "widgets/control/envelopepanel.h"
#include "widgets/control/gainspanel.h"
#include "widgets/control/gainunits.h"
#include "widgets/control/modepanel.h"
#include "widgets/control/stimulusbar.h"
#include "widgets/control/trialsview.h"
#include "widgets/control/trialwords.h"
#include "widgets/control/tuneframe.h"
#include "widgets/control/tunepage.h"
#include "widgets/report/reportorder.h"

#include <QPointer>
#include <QStackedWidget>

#include <algorithm>
#include <cmath>

namespace mb {

void TunePage::showLive(bool live)
{
    m_view->setCurrent(live ? 1 : 0);
    viewChosen(live ? 1 : 0);
}

bool TunePage::isLive() const
{
    return m_view->current() == 1;
}

void TunePage::viewChosen(int view)
{
    const bool live = view == 1;
    m_work->setCurrentIndex(view);
    m_frame->setLive(live);
    m_envelope->setVisible(!live);
    m_liveColumn->setVisible(live);
    follow();
}

void TunePage::chooseStimulus(Mode mode, const StimulusChoice &stimulus)
{
    Choice *const chosen = choice();
    if (!chosen)
        return;
    m_modes->show(mode, chosen->editedSlot, chosen->runningSlot);
    if (chosen->mode != m_modes->mode())
        modeChosen(m_modes->mode());
    chosen->stimulus = stimulus;
    m_stimulus->setChoice(stimulus);
    follow();
}

void TunePage::stimulusChosen()
{
    Choice *const chosen = choice();
    if (!chosen)
        return;
    chosen->stimulus = m_stimulus->choice();
    follow();
}

ExperimentWish TunePage::wishOf(const DeviceView &view, int axis) const
{
    const Choice &chosen = m_choices.at({view.id, axis});
    ExperimentWish wish;
    wish.mode = chosen.mode;
    wish.axis = std::max(axis, 1);
    wish.slot = chosen.runningSlot;
    wish.stimulus = chosen.stimulus;
    wish.limits = m_envelope->entered();
    if (axis == m_axis && chosen.editedSlot == chosen.runningSlot)
        wish.gains = m_gains->toWrite();
    return wish;
}

void TunePage::followTrials(const DeviceView &view)
{
    Choice &chosen = *choice();
    const Instant now = m_workbench.presentOf(view.link);
    if (chosen.unit.empty() || !view.identity.serial.empty()) // a scan may forget it for a moment
        chosen.unit = tuning::unitOf(view.identity, view.selector, view.link.starts_with("sim:"));
    m_envelope->choose(chosen.unit, true);
    m_trials->choose(view.family, chosen.unit, std::max(m_axis, 1), chosen.mode);
    m_stimulus->setUnits(chosen.mode, chosen.units);
    if (!chosen.stimulus.to && view.liveness.heard && m_stimulus->fault().isEmpty())
        chosen.stimulus = usualStimulus(view, wishOf(view, m_axis), chosen.units, now);
    m_stimulus->setChoice(chosen.stimulus);
    const ExperimentCheck check = checkExperiment(view, wishOf(view, m_axis), chosen.units, now);
    m_stimulus->setEnabled(check.possible);
    m_envelope->setInForce(check.inForce, check.missing);
    checkKinds(view, chosen, now);
    if (!m_stimulus->fault().isEmpty())
        m_stimulus->setVerdict(false, m_stimulus->fault());
    else
        m_stimulus->setVerdict(check.good, check.words);
}

/// Each kind of stimulus with the values as they are, so that the list says which would leave the envelope. The one that is
/// chosen stays: what is wrong with it stands beside it, and at Run.
void TunePage::checkKinds(const DeviceView &view, const Choice &chosen, Instant now)
{
    if (isLive())
        return;
    ExperimentWish wish = wishOf(view, m_axis);
    for (const tuning::Profile kind : StimulusBar::kinds()) {
        wish.stimulus.profile = kind;
        const bool free = kind == chosen.stimulus.profile || !chosen.stimulus.to || !m_stimulus->fault().isEmpty();
        const ExperimentCheck check = free ? ExperimentCheck{} : checkExperiment(view, wish, chosen.units, now);
        m_stimulus->setKindFault(
            kind, free || check.good || !check.possible || !check.missing.isEmpty() ? QString() : check.words);
    }
}

PageStatus TunePage::trialStatus(const DeviceView &view, const QString &name) const
{
    const Choice &chosen = m_choices.at({m_shown, m_axis});
    const ExperimentCheck check
        = checkExperiment(view, wishOf(view, m_axis), chosen.units, m_workbench.presentOf(view.link));
    if (m_arming.isOnTrial()) {
        const OperationView *operation = m_workbench.snapshot().operation(view.id);
        const QString step = operation ? messageText(operation->status.step) : QString();
        return {GlyphState::Moving, tr("Experiment"), step, false};
    }
    if (m_arming.isMoving())
        return {GlyphState::Moving, tr("Moving"), tr("Stop the motion before an experiment."), false};
    if (!m_stimulus->fault().isEmpty())
        return {GlyphState::OutOfRange, tr("The stimulus cannot be sent"), m_stimulus->fault(), false};
    if (!check.good)
        return {GlyphState::Warning, check.possible ? tr("No experiment yet") : tr("No experiment in this mode"),
            check.words, false};
    if (m_arming.isArmed(view.id))
        return {GlyphState::Online, tr("Armed"), tr("F5 runs the experiment."), true};
    return {GlyphState::Gone, tr("Not armed"), tr("Hold the Arm button for 1 s to arm %1.").arg(name), false};
}

/// What is staged and no part of an experiment is written first. Several axes take turns.
void TunePage::tryOut()
{
    const DeviceView *const view = device();
    if (!view || !status().mayRun)
        return;
    m_toTry = m_axis > 0 ? m_axes->together() : std::vector{0};
    for (const int axis : m_toTry) { // as far from where each is, in position mode
        Choice &other = choiceOf(*view, axis);
        const Choice &shown = *choice();
        if (axis == m_axis)
            continue;
        const double here = present(*view, shown.mode, m_axis).value_or(0.0);
        const bool distance = shown.mode == Mode::Position;
        other.mode = shown.mode;
        other.stimulus = shown.stimulus;
        if (distance && other.stimulus.to)
            *other.stimulus.to += std::round(present(*view, shown.mode, axis).value_or(0.0) - here);
        if (distance)
            other.stimulus.from.reset();
    }
    const std::vector<ParameterChange> all = wishOf(*view, m_axis).gains;
    const bool others = triable(*view->family, all).size() < all.size();
    const int first = m_toTry.front();
    m_toTry.erase(m_toTry.begin());
    if (others)
        writeThen([this, first] {
            if (const DeviceView *now = device())
                tryAxis(*now, first);
        });
    else
        tryAxis(*view, first);
}

void TunePage::runRepeated(int repeats)
{
    Choice *const chosen = choice();
    if (!isLive() && chosen) {
        chosen->stimulus.repeat = repeats;
        m_stimulus->setChoice(chosen->stimulus);
    }
    run();
}

void TunePage::tryAxis(const DeviceView &view, int axis)
{
    const auto plan = planOf(view, wishOf(view, axis));
    const auto mine = [self = QPointer<TunePage>(this), device = view.id, axis](auto &&act) {
        if (self && self->m_shown == device && self->m_axis == axis)
            act(*self);
    };
    m_arming.runTrial(
        plan,
        [mine](const tuning::Trial &trial) { mine([&trial](TunePage &page) { page.m_trials->showMeasured(trial); }); },
        [self = QPointer<TunePage>(this), mine](const Result<tuning::Trial> &trial) {
            if (trial)
                mine([&trial](TunePage &page) { page.m_trials->addFinished(*trial); });
            if (self)
                self->tried(trial);
        });
    follow();
}

void TunePage::tried(const Result<tuning::Trial> &trial)
{
    const DeviceView *const view = device();
    const bool goesOn = trial && trial->reason == "done" && view && m_arming.isArmed(view->id) && !m_toTry.empty();
    if (!goesOn)
        m_toTry.clear();
    follow();
    if (!goesOn)
        return;
    const int next = m_toTry.front();
    m_toTry.erase(m_toTry.begin());
    tryAxis(*view, next);
}

/// The gains of a trial come back as edits of the slot that is edited: seen, and written like any other.
void TunePage::useGains(const KeptTrial &kept)
{
    const DeviceView *view = device();
    Choice *chosen = choice();
    if (!view || !chosen)
        return;
    const GainSet set = gainSet(*view->family, kept.trial.mode, chosen->editedSlot, m_axis);
    std::vector<ParameterChange> changes;
    for (const std::vector<ParameterIndex> *rows : {&set.gains, &set.bounds}) {
        for (const ParameterIndex index : *rows) {
            const Parameter &row = view->family->parameters[index.value];
            for (const auto &[key, value] : kept.trial.gains) {
                if (!value || gainName(row) != std::string_view(key).substr(key.rfind('.') + 1))
                    continue;
                if (const auto raw = toRaw(row, *value))
                    changes.push_back({index, *raw});
            }
        }
    }
    chosen->edits->stageAll(changes, tr("Gains of trial #%1").arg(kept.number));
    ++m_editRevision;
    follow();
}

/// With the gains in force: what is staged is no part of it.
void TunePage::showBattery()
{
    const DeviceView *const view = device();
    if (!view || isLive() || !choice() || !choice()->stimulus.to)
        return;
    ExperimentWish wish = wishOf(*view, m_axis);
    wish.gains.clear();
    if (!checkExperiment(*view, wish, choice()->units, m_workbench.presentOf(view->link)).good)
        return;
    if (!m_battery)
        m_battery = new BatteryDialog(m_arming, m_theme, this);
    const double here = present(*view, wish.mode, m_axis).value_or(0.0);
    const std::string_view unit = unitOf(wish.mode);
    m_battery->setBattery(tuning::batteryOf(planOf(*view, wish), here, view->family->capabilities.zeroPosition),
        view->id, QString::fromUtf8(unit.data(), static_cast<int>(unit.size())));
    m_battery->show();
    m_battery->raise();
    m_battery->activateWindow();
}

void TunePage::writeReport()
{
    const DeviceView *view = device();
    if (!view)
        return;
    ReportWish wish;
    for (const KeptTrial *const shown : {m_trials->a(), m_trials->b()}) {
        if (shown)
            wish.trials.push_back(shown->number);
    }
    if (!m_order)
        m_order = new ReportOrder(m_workbench, *this);
    m_order->ask(*view, wish);
}

/// Staged, never written: one key runs it.
void TunePage::stageAdvice(const std::vector<std::pair<std::string, double>> &values)
{
    const DeviceView *view = device();
    Choice *chosen = choice();
    if (!view || !chosen)
        return;
    std::vector<ParameterChange> changes;
    for (const auto &[key, value] : values) {
        const auto index = findParameter(view->family->parameters, key);
        const auto raw = index ? toRaw(view->family->parameters[index->value], value) : Result<std::int64_t>(0);
        if (index && raw)
            changes.push_back({*index, *raw});
    }
    chosen->edits->stageAll(changes, tr("What the adviser proposes"));
    ++m_editRevision;
    follow();
}

} // namespace mb
