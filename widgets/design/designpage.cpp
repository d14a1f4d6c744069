// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/design/designpage.h"

#include "tuning/envelope.h"
#include "tuning/proposals.h"
#include "tuning/verdict.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/emptystate.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/labels.h"
#include "widgets/common/pagekeys.h"
#include "widgets/common/segmented.h"
#include "widgets/common/wraplayout.h"
#include "widgets/control/envelopepanel.h"
#include "widgets/control/experimentplan.h"
#include "widgets/design/designframe.h"
#include "widgets/design/designplots.h"
#include "widgets/design/modelpanel.h"
#include "widgets/design/ownproposal.h"
#include "widgets/design/proposalcard.h"
#include "widgets/design/scrollcolumn.h"
#include "widgets/design/sweeppanel.h"
#include "widgets/design/tuningsteps.h"
#include "widgets/report/reportorder.h"

#include <QHBoxLayout>
#include <QPointer>
#include <QStackedWidget>

#include <algorithm>
#include <array>
#include <utility>

namespace mb {
namespace {

constexpr std::array designedLoops{Mode::Velocity, Mode::Position, Mode::Current};
constexpr double checkedDuty = 0.15;
constexpr double checkedSeconds = 0.6;
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
    auto *content = new DesignFrame(theme, m_stack);
    auto *orders = buildOrders();
    m_status = new StatusLine(theme, content);
    m_plots = new DesignPlots(theme, content);
    content->setParts({m_status, orders, buildColumn(), m_plots, buildSide()});
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

QWidget *DesignPage::buildOrders()
{
    auto *bar = new QWidget(this);
    auto *row = new WrapLayout(bar);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(m_theme.theme().u(8));
    m_loops = new Segmented(tr("Loop"), {tr("Velocity"), tr("Position"), tr("Current")}, bar);
    m_slots = new Segmented(tr("Gain slot"), {tr("slot 0"), tr("slot 1")}, bar);
    m_identify = new CommandButton(m_theme, tr("Identify"), bar);
    m_identify->setKeyHint(QStringLiteral("Shift+F6"));
    m_autotune = new CommandButton(m_theme, tr("Autotune"), bar);
    m_autotune->setKeyHint(QStringLiteral("F6"));
    m_autotune->setToolTip(tr("Identifies, writes the chosen set and proves it, in one go"));
    m_prove = new CommandButton(m_theme, Symbol::Play, tr("Write and prove"), bar);
    m_prove->setPrimary(true);
    m_prove->setKeyHint(QStringLiteral("F5"));
    row->addWidget(m_loops);
    row->addWidget(m_slots);
    row->addWidget(m_identify);
    row->addWidget(m_autotune);
    row->addWidget(m_prove);
    connect(m_loops, &Segmented::currentChanged, this,
        [this](int index) { chooseLoop(designedLoops.at(static_cast<std::size_t>(index))); });
    connect(m_slots, &Segmented::currentChanged, this, &DesignPage::chooseSlot);
    connect(m_identify, &QPushButton::clicked, this, &DesignPage::identify);
    connect(m_autotune, &QPushButton::clicked, this, &DesignPage::autotune);
    connect(m_prove, &QPushButton::clicked, this, &DesignPage::prove);
    return bar;
}

QWidget *DesignPage::buildColumn()
{
    auto *area = new ScrollColumn(m_theme.theme(), this);
    QWidget *const column = area->content();
    m_model = new ModelPanel(m_theme, column);
    m_envelope = new EnvelopePanel(m_theme, column);
    connect(m_envelope, &EnvelopePanel::changed, this, &DesignPage::follow);
    connect(m_envelope, &EnvelopePanel::failed, this, [this](const QString &cause) {
        m_workbench.report(Severity::Caution, {}, tr("the limits were not kept: %1").arg(cause));
    });
    m_cards = new QVBoxLayout;
    m_cards->setSpacing(m_theme.theme().u(8));
    area->rows().addWidget(m_model);
    area->rows().addWidget(separatorLine(Qt::Horizontal, column));
    area->rows().addWidget(m_envelope);
    area->rows().addWidget(separatorLine(Qt::Horizontal, column));
    area->rows().addWidget(new SectionLabel(tr("Proposals"), column));
    area->rows().addLayout(m_cards);
    area->rows().addStretch(1);
    return area;
}

/// What happens, the sliders, and the sines: in sight whatever the left column shows.
QWidget *DesignPage::buildSide()
{
    auto *area = new ScrollColumn(m_theme.theme(), this);
    QWidget *const side = area->content();
    m_steps = new TuningSteps(m_theme, side);
    m_own = new OwnProposal(m_theme, side);
    m_own->hide();
    connect(m_own, &OwnProposal::wished, this, &DesignPage::ownWished);
    connect(m_own, &Card::activated, this, &DesignPage::ownWished);
    m_sweep = new SweepPanel(m_arming, m_theme, side);
    connect(m_sweep, &SweepPanel::measured, this, [this](const tuning::FrequencyResponse &response) {
        m_responses[{place().device, place().axis}] = response;
        showChosen();
    });
    area->rows().addWidget(m_steps, 1);
    area->rows().addWidget(m_own);
    area->rows().addWidget(m_sweep);
    return area;
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

DesignPage::Choice DesignPage::choice() const
{
    const auto found = m_choices.find(place());
    return found == m_choices.end() ? Choice() : found->second;
}

const tuning::Proposal *DesignPage::chosen() const
{
    const Choice now = choice();
    if (now.own)
        return m_ownDesigned ? &*m_ownDesigned : nullptr;
    const auto found = std::find_if(m_designed.begin(), m_designed.end(),
        [&now](const tuning::Proposal &proposal) { return proposal.aim == now.aim; });
    return found == m_designed.end() ? nullptr : &*found;
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
    const Choice now = choice();
    plan.aim = now.own ? tuning::Aim::Normal : now.aim;
    plan.slot = now.slot;
    if (now.own) {
        plan.response = now.response;
        plan.ms = now.ms;
    }
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
        return {GlyphState::Busy, tr("Busy"), messageText(view->busy), false};
    if (m_arming.isArmed(view->id))
        return {GlyphState::Online, tr("Armed"), tr("The motor turns both ways as soon as you say so."), true};
    return {GlyphState::Gone, tr("Not armed"), tr("Hold the Arm button for 1 s to arm %1.").arg(name), false};
}

void DesignPage::chooseLoop(Mode loop)
{
    m_loop = loop;
    follow();
}

void DesignPage::chooseAim(tuning::Aim aim)
{
    Choice &now = m_choices[place()];
    now.aim = aim;
    now.own = false;
    showChosen();
}

void DesignPage::chooseOwn(double response, double ms)
{
    Choice &now = m_choices[place()];
    now.own = true;
    now.response = response;
    now.ms = ms;
    designOwn();
    showChosen();
}

void DesignPage::ownWished()
{
    chooseOwn(m_own->response(), m_own->ms());
}

/// The same model, other parameters: nothing has to be identified anew.
void DesignPage::chooseSlot(int slot)
{
    m_choices[place()].slot = slot;
    m_shown.reset();
    follow();
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
    wanted.taking = known->taking;
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
            now.proposals = before->second.proposals; // the three; what was proven may be the sliders' own
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
    m_slots->setVisible(view.family->capabilities.gainSlots > 1);
    m_slots->setCurrent(choice().slot);
    followLimits(view);
    const OperationView *const job = m_workbench.snapshot().operation(view.id);
    const bool works = m_arming.isOnTrial() && job && job->status.state == OperationStatus::State::Running;
    m_steps->show(works ? job : nullptr, report());
    if (m_shown != place()) {
        m_shown = place();
        showReport();
    }
    m_sweep->follow({view.family, report(), m_inForce, m_envelope->entered(), now.mayRun});
    m_prove->setEnabled(now.mayRun && chosen());
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
    m_inForce = check.inForce;
    m_envelope->setInForce(check.inForce, check.missing);
}

void DesignPage::showReport()
{
    const DeviceView *const view = device();
    const tuning::TuneReport *const known = report();
    m_model->setReport(known);
    for (ProposalCard *card : std::exchange(m_proposals, {}))
        delete card;
    m_designed.clear();
    m_ownDesigned.reset();
    if (view && known) {
        designAll(*view);
        showCards(*view);
    }
    m_own->setVisible(!m_designed.empty());
    m_plots->setWatermark(known && known->simulated ? tr("DEMO") : QString());
    showChosen();
}

tuning::ProposalBasis DesignPage::basisOf(const DeviceView &view) const
{
    return {*view.family, view.profile, m_loop, place().axis, choice().slot, report()->plant, m_inForce,
        report()->scale, report()->taking};
}

/// What the engine proposed; the same gains in another slot. Nothing is searched for here: that takes longer than a frame.
void DesignPage::designAll(const DeviceView &view)
{
    const tuning::TuneReport &known = *report();
    const Choice now = choice();
    m_designed = known.proposals;
    if (known.slot != now.slot && known.plant.gain > 0.0) {
        m_designed.clear();
        const tuning::ProposalBasis basis = basisOf(view);
        for (const tuning::Proposal &proposal : known.proposals) {
            if (auto moved = tuning::movedTo(basis, proposal))
                m_designed.push_back(std::move(*moved));
        }
    }
    designOwn();
}

/// Of the sliders; they begin where the normal proposal is.
void DesignPage::designOwn()
{
    const DeviceView *const view = device();
    const tuning::TuneReport *const known = report();
    m_ownDesigned.reset();
    if (!view || !known || !(known->plant.gain > 0.0))
        return;
    const double usual = tuning::responseOf(m_loop, tuning::Aim::Normal, known->plant);
    const Choice now = choice();
    const double response = now.response > 0.0 ? now.response : usual;
    const double ms = now.ms > 0.0 ? now.ms : tuning::msBoundsOf({}).model;
    const auto proposal = tuning::proposalFor(basisOf(*view), {tuning::Aim::Normal, response, ms});
    m_own->setWish(response, ms, usual);
    m_own->show(proposal);
    if (proposal)
        m_ownDesigned = *proposal;
}

void DesignPage::showCards(const DeviceView &view)
{
    for (const tuning::Proposal &proposal : m_designed) {
        auto *card = new ProposalCard(m_theme, *view.family, proposal, this);
        connect(card, &Card::activated, this, [this, aim = proposal.aim] { chooseAim(aim); });
        m_cards->addWidget(card);
        m_proposals.push_back(card);
    }
}

void DesignPage::showChosen()
{
    const tuning::Proposal *const proposal = chosen();
    const Choice now = choice();
    for (ProposalCard *card : m_proposals)
        card->setChosen(proposal && !now.own && card->aim() == proposal->aim);
    m_own->setChosen(proposal && now.own);
    const DeviceView *const view = device();
    if (!proposal || !view)
        return m_plots->clear();
    const auto response = m_responses.find({place().device, place().axis});
    m_plots->setMeasured(
        response == m_responses.end() ? std::vector<tuning::FrequencyPoint>() : response->second.points);
    m_plots->show(*report(), *proposal, now.own ? tr("own") : aimText(proposal->aim), basisOf(*view));
}

} // namespace mb
