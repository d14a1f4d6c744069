// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/design/designpage.h"

#include "tuning/envelope.h"
#include "tuning/verdict.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/emptystate.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/labels.h"
#include "widgets/common/numberformat.h"
#include "widgets/common/pagekeys.h"
#include "widgets/common/segmented.h"
#include "widgets/control/envelopepanel.h"
#include "widgets/control/experimentplan.h"
#include "widgets/design/bodeplot.h"
#include "widgets/design/modelpanel.h"
#include "widgets/design/proposalcard.h"
#include "widgets/design/tuningsteps.h"
#include "widgets/plots/curveplot.h"
#include "widgets/report/reportorder.h"

#include <QHBoxLayout>
#include <QPointer>
#include <QScrollArea>
#include <QStackedWidget>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace mb {
namespace {

constexpr int modelWidth = 344;
constexpr int stepsWidth = 236;
constexpr std::array designedLoops{Mode::Velocity, Mode::Position, Mode::Current};
constexpr double checkedDuty = 0.15;
constexpr double checkedSeconds = 0.6;
constexpr double shownSettles = 4.0;   ///< predicted times to settle that a step is drawn for
constexpr double shortestShown = 0.05; ///< s, of one of them

bool isSame(const tuning::ScaledGains &a, const tuning::ScaledGains &b)
{
    return std::equal(a.rows.begin(), a.rows.end(), b.rows.begin(), b.rows.end(),
        [](const auto &one, const auto &other) { return one.key == other.key && one.raw == other.raw; });
}

Curve curveOf(
    const QString &name, const TraceLook &look, const tuning::Trace &whole, double origin, double sign, double end)
{
    Curve curve{name, look, {}, {}};
    const tuning::Trace trace = whole.part(whole.isEmpty() ? 0.0 : whole.t.front(), end);
    for (std::size_t i = 0; i < trace.size(); ++i) {
        curve.x.append(trace.t[i]);
        curve.y.append(sign * (trace.y[i] - origin));
    }
    return curve;
}

double shortestHold(const std::vector<tuning::Trial> &trials)
{
    double shortest = std::numeric_limits<double>::infinity();
    for (const tuning::Trial &trial : trials) {
        for (const tuning::Span &hold : trial.holds)
            shortest = std::min(shortest, hold.to - hold.from);
    }
    return shortest;
}

TraceRole roleOf(Mode loop)
{
    if (loop == Mode::Current)
        return TraceRole::Current;
    return loop == Mode::Velocity ? TraceRole::Velocity : TraceRole::Position;
}

} // namespace

DesignPage::DesignPage(
    Workbench &workbench, Selection &selection, Arming &arming, const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_workbench(workbench)
    , m_selection(selection)
    , m_arming(arming)
    , m_theme(theme)
{
    setObjectName(QStringLiteral("designPage"));
    m_stack = new QStackedWidget(this);
    m_empty = new EmptyState(theme, Symbol::Wave, {}, {}, m_stack);
    auto *content = new QWidget(m_stack);
    auto *grid = new QGridLayout(content);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(0);
    grid->addWidget(buildCommands(), 0, 0, 1, 5);
    grid->addWidget(separatorLine(Qt::Horizontal, content), 1, 0, 1, 5);
    grid->addWidget(buildColumn(), 2, 0);
    grid->addWidget(separatorLine(Qt::Vertical, content), 2, 1);
    grid->addWidget(buildPlots(), 2, 2);
    grid->addWidget(separatorLine(Qt::Vertical, content), 2, 3);
    m_steps = new TuningSteps(theme, content);
    m_steps->setFixedWidth(theme.theme().u(stepsWidth));
    grid->addWidget(m_steps, 2, 4);
    grid->setColumnStretch(2, 1);
    grid->setRowStretch(2, 1);
    m_stack->addWidget(m_empty);
    m_stack->addWidget(content);
    auto *all = new QVBoxLayout(this);
    all->setContentsMargins(0, 0, 0, 0);
    all->addWidget(m_stack);
    buildKeys();
    connect(&workbench, &Workbench::changed, this, &DesignPage::follow);
    connect(&arming, &Arming::changed, this, &DesignPage::follow);
    connect(&selection, &Selection::changed, this, &DesignPage::follow);
}

QWidget *DesignPage::buildCommands()
{
    const Theme &theme = m_theme.theme();
    auto *bar = new QWidget(this);
    auto *row = new QHBoxLayout(bar);
    row->setContentsMargins(theme.u(12), theme.u(6), theme.u(12), theme.u(6));
    row->setSpacing(theme.u(8));
    m_status = new StatusLine(m_theme, bar);
    m_loops = new Segmented(tr("Loop"), {tr("Velocity"), tr("Position"), tr("Current")}, bar);
    m_identify = new CommandButton(m_theme, tr("Identify"), bar);
    m_identify->setKeyHint(QStringLiteral("Shift+F6"));
    m_autotune = new CommandButton(m_theme, tr("Autotune"), bar);
    m_autotune->setKeyHint(QStringLiteral("F6"));
    m_autotune->setToolTip(tr("Identifies, writes the chosen set and proves it, in one go"));
    m_prove = new CommandButton(m_theme, Symbol::Play, tr("Write and prove"), bar);
    m_prove->setPrimary(true);
    m_prove->setKeyHint(QStringLiteral("F5"));
    row->addWidget(m_status, 1);
    row->addWidget(m_loops);
    row->addWidget(m_identify);
    row->addWidget(m_autotune);
    row->addWidget(m_prove);
    connect(m_loops, &Segmented::currentChanged, this,
        [this](int index) { chooseLoop(designedLoops.at(static_cast<std::size_t>(index))); });
    connect(m_identify, &QPushButton::clicked, this, &DesignPage::identify);
    connect(m_autotune, &QPushButton::clicked, this, &DesignPage::autotune);
    connect(m_prove, &QPushButton::clicked, this, &DesignPage::prove);
    return bar;
}

QWidget *DesignPage::buildColumn()
{
    const Theme &theme = m_theme.theme();
    auto *scroll = new QScrollArea(this);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFocusPolicy(Qt::NoFocus);
    scroll->setFixedWidth(theme.u(modelWidth));
    auto *column = new QWidget(scroll);
    column->setProperty("transparent", true);
    auto *inner = new QVBoxLayout(column);
    inner->setContentsMargins(theme.u(12), theme.u(10), theme.u(12), theme.u(10));
    inner->setSpacing(theme.u(10));
    inner->setSizeConstraint(QLayout::SetMinimumSize); // it scrolls before anything is squeezed
    m_model = new ModelPanel(m_theme, column);
    m_envelope = new EnvelopePanel(m_theme, column);
    connect(m_envelope, &EnvelopePanel::changed, this, &DesignPage::follow);
    connect(m_envelope, &EnvelopePanel::failed, this, [this](const QString &cause) {
        m_workbench.report(Severity::Caution, {}, tr("the limits were not kept: %1").arg(cause));
    });
    m_cards = new QVBoxLayout;
    m_cards->setSpacing(theme.u(8));
    inner->addWidget(m_model);
    inner->addWidget(separatorLine(Qt::Horizontal, column));
    inner->addWidget(m_envelope);
    inner->addWidget(separatorLine(Qt::Horizontal, column));
    inner->addWidget(new SectionLabel(tr("Proposals"), column));
    inner->addLayout(m_cards);
    inner->addStretch(1);
    scroll->setWidget(column);
    return scroll;
}

QWidget *DesignPage::buildPlots()
{
    auto *plots = new QWidget(this);
    auto *column = new QVBoxLayout(plots);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    m_bode = new BodePlot(m_theme, plots);
    m_step = new CurvePlot(m_theme, tr("Step, predicted and measured"), plots);
    m_step->setLegendPlace(Qt::AlignBottom | Qt::AlignRight);
    column->addWidget(m_bode, 7);
    column->addWidget(separatorLine(Qt::Horizontal, plots));
    column->addWidget(m_step, 4);
    return plots;
}

void DesignPage::buildKeys()
{
    auto *keys = new PageKeys(*this);
    keys->add({Qt::Key_F5}, tr("writes the chosen set and proves it"), [this] { prove(); });
    keys->add({Qt::Key_F6}, tr("identifies, writes and proves in one go"), [this] { autotune(); });
    keys->add({QKeySequence(QStringLiteral("Shift+F6"))}, tr("identifies the motor"), [this] { identify(); });
    m_order = new ReportOrder(m_workbench, *this);
    keys->add({QKeySequence::Print}, tr("writes a report of what is shown"), [this] { writeReport(); });
}

const DeviceView *DesignPage::device() const
{
    return m_workbench.snapshot().device(m_selection.device());
}

DesignPage::Place DesignPage::place() const
{
    return {m_selection.device(), std::max(m_selection.axis(), 1), m_loop};
}

const tuning::TuneReport *DesignPage::report() const
{
    const auto found = m_reports.find(place());
    return found == m_reports.end() ? nullptr : &found->second;
}

tuning::Aim DesignPage::aim() const
{
    const auto found = m_aims.find(place());
    return found == m_aims.end() ? tuning::Aim::Normal : found->second;
}

const tuning::Proposal *DesignPage::chosen() const
{
    const tuning::TuneReport *const known = report();
    if (!known)
        return nullptr;
    const auto found = std::find_if(known->proposals.begin(), known->proposals.end(),
        [this](const tuning::Proposal &proposal) { return proposal.aim == aim(); });
    return found == known->proposals.end() ? nullptr : &*found;
}

/// The loop that is chosen may be one that this family has not.
QString DesignPage::whyNot(const DeviceView &view) const
{
    if (view.identity.state == DeviceState::Bootloader)
        return tr("%1 waits in its bootloader.").arg(titleOf(view));
    tuning::TunePlan wanted;
    wanted.loop = m_loop;
    wanted.axis = place().axis;
    if (!view.family->trials)
        return tr("This family has no loop that can be tuned.");
    const auto possible = tuning::checkTuning(*view.family, wanted);
    return possible ? QString() : errorText(possible.error());
}

tuning::TunePlan DesignPage::plan() const
{
    tuning::TunePlan plan;
    plan.loop = m_loop;
    plan.axis = place().axis;
    plan.aim = aim();
    plan.limits = m_envelope->entered();
    return plan;
}

PageStatus DesignPage::status() const
{
    const DeviceView *const view = device();
    if (!view)
        return {};
    const QString name = titleOf(*view);
    if (m_arming.isOnTrial())
        return {GlyphState::Moving, tr("Tuning"), tr("STOP ends it; what was changed is put back."), false};
    if (m_arming.isMoving())
        return {GlyphState::Moving, tr("Moving"), tr("Stop the motion before the motor is tuned."), false};
    if (!view->busy.empty())
        return {GlyphState::Busy, tr("Busy"), tableText(view->busy), false};
    if (m_arming.isArmed(view->id))
        return {GlyphState::Online, tr("Armed"), tr("The motor turns both ways as soon as you say so."), true};
    return {GlyphState::Gone, tr("Not armed"), tr("Hold the lamp for 1 s to arm %1.").arg(name), false};
}

void DesignPage::chooseLoop(Mode loop)
{
    m_loop = loop;
    follow();
}

void DesignPage::chooseAim(tuning::Aim aim)
{
    m_aims[place()] = aim;
    showChosen();
}

void DesignPage::identify()
{
    tuning::TunePlan wanted = plan();
    wanted.propose = true;
    run(std::move(wanted));
}

/// Without a model there is nothing to write.
void DesignPage::prove()
{
    const tuning::TuneReport *const known = report();
    if (!known || !chosen())
        return;
    tuning::TunePlan wanted = plan();
    wanted.known = known->plant;
    wanted.scale = known->scale;
    run(std::move(wanted));
}

void DesignPage::autotune()
{
    run(plan());
}

void DesignPage::writeReport()
{
    const DeviceView *const view = device();
    if (!view)
        return;
    ReportWish wish;
    wish.tuningsOnly = true;
    if (const tuning::TuneReport *const known = report())
        wish.trials = known->trials;
    m_order->ask(*view, wish);
}

void DesignPage::run(tuning::TunePlan plan)
{
    const DeviceView *const view = device();
    if (!view || !status().mayRun || !whyNot(*view).isEmpty())
        return;
    m_arming.runTuning(plan, [self = QPointer<DesignPage>(this), where = place()](const auto &report) {
        if (self)
            self->ended(where, report);
    });
    follow();
}

/// A proof brings no model of its own, and what was stopped before it had one leaves the one that is known.
void DesignPage::ended(const Place &place, const Result<tuning::TuneReport> &report)
{
    if (report) {
        tuning::TuneReport now = *report;
        const auto before = m_reports.find(place);
        if (before != m_reports.end() && !now.motor) {
            now.motor = before->second.motor;
            now.plant = before->second.plant;
            now.scale = before->second.scale;
            now.gates = before->second.gates;
            if (now.proposals.empty())
                now.proposals = before->second.proposals;
        }
        m_reports[place] = std::move(now);
        m_shown.reset();
    }
    follow();
}

void DesignPage::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    follow();
}

/// Thirty times a second, and only while somebody sees it.
void DesignPage::follow()
{
    if (!isVisible())
        return;
    const DeviceView *const view = device();
    const QString why = view ? whyNot(*view) : QString();
    const bool usable = view && (why.isEmpty() || view->family->trials);
    if (!usable)
        m_empty->setText(view ? tr("No tuning here") : tr("No device selected"),
            view ? why : tr("Choose a controller in the list at the left."));
    m_stack->setCurrentIndex(usable ? 1 : 0);
    if (usable)
        followDevice(*view, why);
}

void DesignPage::followDevice(const DeviceView &view, const QString &whyNot)
{
    const PageStatus now
        = whyNot.isEmpty() ? status() : PageStatus{GlyphState::Warning, tr("Not by itself"), whyNot, false};
    m_status->say(now);
    m_loops->setCurrent(
        static_cast<int>(std::find(designedLoops.begin(), designedLoops.end(), m_loop) - designedLoops.begin()));
    m_identify->setEnabled(now.mayRun);
    m_autotune->setEnabled(now.mayRun);
    m_prove->setEnabled(now.mayRun && chosen());
    followLimits(view);
    const OperationView *const job = m_workbench.snapshot().operation(view.id);
    const bool works = m_arming.isOnTrial() && job && job->status.state == OperationStatus::State::Running;
    m_steps->show(works ? job : nullptr, report());
    if (m_shown != place()) {
        m_shown = place();
        showReport();
    }
}

void DesignPage::followLimits(const DeviceView &view)
{
    ExperimentWish pushes;
    pushes.mode = Mode::Duty;
    pushes.axis = place().axis;
    pushes.stimulus.to = checkedDuty;
    pushes.stimulus.seconds = checkedSeconds;
    m_envelope->choose(tuning::unitOf(view.identity, view.selector, view.link.starts_with("sim:")),
        std::exchange(m_limitsOf, view.id) == view.id);
    pushes.limits = m_envelope->entered();
    const ExperimentCheck check = checkExperiment(view, pushes, {}, m_workbench.presentOf(view.link));
    m_envelope->setInForce(check.inForce, check.missing);
}

void DesignPage::showReport()
{
    const DeviceView *const view = device();
    const tuning::TuneReport *const known = report();
    m_model->setReport(known);
    for (ProposalCard *card : std::exchange(m_proposals, {}))
        delete card;
    if (view && known) {
        for (const tuning::Proposal &proposal : known->proposals) {
            auto *card = new ProposalCard(m_theme, *view->family, proposal, this);
            connect(card, &Card::activated, this, [this, aim = proposal.aim] { chooseAim(aim); });
            m_cards->addWidget(card);
            m_proposals.push_back(card);
        }
    }
    m_bode->setWatermark(known && known->simulated ? tr("DEMO") : QString());
    m_step->setWatermark(known && known->simulated ? tr("DEMO") : QString());
    showChosen();
}

void DesignPage::showChosen()
{
    const tuning::Proposal *const proposal = chosen();
    for (ProposalCard *card : m_proposals)
        card->setChosen(proposal && card->aim() == proposal->aim);
    if (!proposal) {
        m_bode->clear();
        m_step->setCurves({});
        m_step->setNote(tr("What the gains will do appears here, before they are written."));
        return;
    }
    m_bode->setLoop(m_loop, report()->plant, proposal->gains.made, proposal->margins);
    showStep(*proposal);
}

/// What was measured stands beside the prediction of the gains that were proven.
void DesignPage::showStep(const tuning::Proposal &proposal)
{
    const tuning::TuneReport *const proven = isSame(report()->proposed, proposal.gains) ? report() : nullptr;
    double end = shownSettles * std::max(proposal.predicted.metrics.settle.value_or(0.5), shortestShown);
    if (proven)
        end = std::min(end, shortestHold(proven->proof));
    TraceLook dotted;
    dotted.role = TraceRole::Setpoint;
    dotted.dash = TraceDash::Dots;
    std::vector<Curve> curves{
        curveOf(tr("%1, predicted").arg(aimText(proposal.aim)), dotted, proposal.predicted.measured, 0.0, 1.0, end)};
    QString note = tr("a step of %1").arg(formatSignificant(proposal.step, 4));
    if (proven) {
        for (const tuning::Trial &trial : proven->proof) {
            const double sign = trial.stimulus.to < trial.stimulus.from ? -1.0 : 1.0;
            TraceLook look;
            look.role = roleOf(m_loop);
            look.dash = sign > 0.0 ? TraceDash::Solid : TraceDash::Long;
            curves.push_back(curveOf(sign > 0.0 ? tr("measured, forwards") : tr("measured, backwards"), look,
                trial.folded(tuning::measuredOf(trial.mode)), trial.stimulus.from, sign, end));
        }
        const tuning::Metrics &measured = proven->measured;
        if (!proven->proof.empty() && measured.overshoot)
            note += QStringLiteral(" · ")
                + tr("measured: %1 % over, settled after %2")
                      .arg(formatNumber(*measured.overshoot * 100.0, 1),
                          measured.settle ? formatDuration(*measured.settle) : QString(UnknownMark));
    }
    m_step->setAxes(tr("s"),
        m_loop == Mode::Current        ? tr("A")
            : m_loop == Mode::Velocity ? tr("counts/s")
                                       : tr("counts"),
        false);
    m_step->setCurves(curves);
    m_step->setNote(note);
    m_step->fit();
}

} // namespace mb
