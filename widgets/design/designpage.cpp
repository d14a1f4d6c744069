// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/design/designpage.h"

#include "experiment/envelope.h"
#include "widgets/common/axistext.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/emptystate.h"
#include "widgets/common/guarded.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/pagekeys.h"
#include "widgets/control/envelopepanel.h"
#include "widgets/control/experimentplan.h"
#include "widgets/design/designcolumn.h"
#include "widgets/design/designcourse.h"
#include "widgets/design/designframe.h"
#include "widgets/design/designorders.h"
#include "widgets/design/designplots.h"
#include "widgets/design/modelpanel.h"
#include "widgets/design/ownproposal.h"
#include "widgets/design/proposallist.h"
#include "widgets/design/sweeppanel.h"
#include "widgets/report/reportorder.h"

#include <QStackedWidget>

#include <utility>

namespace mb {
namespace {

constexpr double checkedDuty = 0.15;
constexpr double checkedSeconds = 0.6;

} // namespace

DesignPage::DesignPage(
    Workbench &workbench, Selection &selection, Arming &arming, const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_workbench(workbench)
    , m_arming(arming)
    , m_book(workbench, selection)
{
    setObjectName(QStringLiteral("designPage"));
    buildContent(theme);
    connectOrders();
    buildKeys();
    connect(&workbench, &Workbench::changed, this, &DesignPage::follow);
    connect(&arming, &Arming::changed, this, &DesignPage::follow);
    connect(&selection, &Selection::changed, this, &DesignPage::follow);
}

void DesignPage::buildContent(const ThemeSource &theme)
{
    m_stack = new QStackedWidget(this);
    m_empty = new EmptyState(theme, Symbol::Wave, {}, {}, m_stack);
    auto *content = new DesignFrame(theme, m_stack);
    m_orders = new DesignOrders(theme, content);
    m_status = new StatusLine(theme, content);
    m_plots = new DesignPlots(theme, content);
    auto *const column = buildColumn(theme);
    m_course = new DesignCourse(m_workbench, m_book, theme, content);
    m_sweep = new SweepPanel(m_arming, theme, m_plots);
    m_plots->setFoot(m_sweep);
    content->setParts({m_status, m_orders, column, m_plots, m_course});
    m_stack->addWidget(m_empty);
    m_stack->addWidget(content);
    auto *all = layoutIn<QVBoxLayout>(this);
    all->addWidget(m_stack);
}

QWidget *DesignPage::buildColumn(const ThemeSource &theme)
{
    m_column = new DesignColumn(theme, this);
    QWidget *const column = m_column->content();
    m_model = new ModelPanel(theme, column);
    m_envelope = new EnvelopePanel(theme, column);
    m_proposals = new ProposalList(m_book, *m_plots, theme, column);
    m_column->setParts(m_model, m_proposals, m_envelope);
    return m_column;
}

void DesignPage::connectOrders()
{
    connect(m_orders, &DesignOrders::loopChosen, this, &DesignPage::chooseLoop);
    connect(m_orders, &DesignOrders::slotChosen, this, &DesignPage::chooseSlot);
    connect(m_orders, &DesignOrders::identifyRequested, this, &DesignPage::identify);
    connect(m_orders, &DesignOrders::autotuneRequested, this, &DesignPage::autotune);
    connect(m_orders, &DesignOrders::proveRequested, this, &DesignPage::prove);
    connect(m_envelope, &EnvelopePanel::changed, this, &DesignPage::follow);
    connect(m_sweep, &SweepPanel::measured, this, [this](const DesignPlace &place, const auto &response) {
        m_book.keepResponse(place, response);
        m_proposals->showChosen();
    });
}

void DesignPage::buildKeys()
{
    auto *keys = new PageKeys(*this);
    keys->add({Qt::Key_F5}, tr("writes the chosen set and proves it"), [this] { prove(); });
    keys->add({Qt::Key_F6}, tr("identifies, writes and proves in one go"), [this] { autotune(); });
    keys->add({QKeySequence(QStringLiteral("Shift+F6"))}, tr("identifies the motor"), [this] { identify(); });
    m_report = new ReportOrder(m_workbench, *this);
    keys->add({QKeySequence::Print}, tr("writes a report of what is shown"), [this] { writeReport(); });
}

PageStatus DesignPage::status() const
{
    const DeviceView *const view = m_book.device();
    if (!view)
        return {};
    const QString name = motorTitle(*view, m_book.place().axis);
    if (m_arming.isOnTrial(view->id))
        return {GlyphState::Moving, tr("Tuning"), tr("STOP ends it; what was changed is put back."), false};
    if (m_arming.isMoving())
        return {GlyphState::Moving, tr("Moving"), tr("Stop the motion before the motor is tuned."), false};
    if (!view->busy.empty())
        return {GlyphState::Busy, tr("Busy"), messageText(view->busy), false};
    if (const QString missing = m_envelope->missing(); !missing.isEmpty())
        return {GlyphState::OutOfRange, tr("No limit"), missing, false};
    if (m_arming.isArmed(view->id))
        return {GlyphState::Online, tr("Armed"), tr("%1 will turn both ways.").arg(name), true};
    return {GlyphState::Gone, tr("Not armed"), tr("Hold the Arm button for 1 s to arm %1.").arg(name), false};
}

const tuning::Proposal *DesignPage::chosen() const
{
    return m_proposals->chosen();
}

void DesignPage::chooseLoop(Mode loop)
{
    m_book.setLoop(loop);
    follow();
}

void DesignPage::chooseAim(tuning::Aim aim)
{
    m_proposals->chooseAim(aim);
}

void DesignPage::chooseOwn(double response, double ms)
{
    m_proposals->chooseOwn(response, ms);
}

/// The same model, other parameters: nothing has to be identified anew.
void DesignPage::chooseSlot(int slot)
{
    m_book.choose().slot = slot;
    m_shown.reset();
    follow();
}

void DesignPage::identify()
{
    tuning::TunePlan wanted = m_book.plan();
    wanted.propose = true;
    run(std::move(wanted));
}

/// Without a model there is nothing to write.
void DesignPage::prove()
{
    const tuning::TuneReport *const known = report();
    if (!known || !chosen())
        return;
    tuning::TunePlan wanted = m_book.plan();
    wanted.known = known->plant;
    wanted.scale = known->scale;
    wanted.taking = known->taking;
    wanted.motor = known->motor;
    wanted.gates = known->gates;
    run(std::move(wanted));
}

void DesignPage::autotune()
{
    run(m_book.plan());
}

void DesignPage::writeReport()
{
    const DeviceView *const view = m_book.device();
    if (!view)
        return;
    ReportWish wish;
    wish.tuningsOnly = true;
    if (const tuning::TuneReport *const known = report())
        wish.trials = known->trials;
    m_report->ask(*view, wish);
}

void DesignPage::run(tuning::TunePlan plan)
{
    const DeviceView *const view = m_book.device();
    if (!view || !status().mayRun || !m_book.whyNot(*view).isEmpty())
        return;
    plan.limits = m_envelope->entered();
    m_arming.runTuning(
        plan, guarded(this, [this, where = m_book.place()](const auto &report) { ended(where, report); }));
    follow();
}

void DesignPage::ended(const DesignPlace &place, const Result<tuning::TuneReport> &report)
{
    if (report) {
        m_book.keep(place, *report);
        m_shown.reset();
    }
    follow();
}

/// Thirty times a second, and only while somebody sees it.
void DesignPage::follow()
{
    if (!isVisible())
        return;
    const DeviceView *const view = m_book.device();
    const QString why = view ? m_book.whyNot(*view) : QString();
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
    followLimits(view);
    const PageStatus now
        = whyNot.isEmpty() ? status() : PageStatus{GlyphState::Warning, tr("Not by itself"), whyNot, false};
    m_status->say(now);
    const OperationView *const job = m_workbench.snapshot().operation(view.id);
    const bool works = m_arming.isOnTrial(view.id) && job && job->status.state == OperationStatus::State::Running;
    const bool stands = !works && !view.liveness.moving; // soft limits leave it a travel that changes with every count
    const Shown wanted{m_book.place(), m_book.countsPerRevolution(view)};
    if (std::exchange(m_shown, wanted) != wanted || (stands && m_proposals->isOutdated()))
        showReport();
    else if (std::exchange(m_revision, view.parameterRevision) != view.parameterRevision)
        m_proposals->showChosen(); // beside other gains
    m_course->follow(
        view, works ? job : nullptr, {chosen(), m_proposals->chosenName(), m_inForce, m_proposals->isFoundAnew()});
    m_sweep->follow({m_book.place(), view.family, report(), m_inForce, m_envelope->entered(), now.mayRun});
    m_orders->follow(m_book, *view.family, now.mayRun, chosen());
}

void DesignPage::followLimits(const DeviceView &view)
{
    ExperimentWish pushes;
    pushes.mode = Mode::Duty;
    pushes.loop = m_book.place().loop;
    pushes.axis = m_book.place().axis;
    pushes.slot = m_book.choice().slot;
    pushes.stimulus.to = checkedDuty;
    pushes.stimulus.seconds = checkedSeconds;
    m_envelope->choose(view.unit, std::exchange(m_limitsOf, view.id) == view.id);
    pushes.limits = m_envelope->entered();
    const ExperimentCheck check = checkExperiment(view, pushes, {}, m_workbench.presentOf(view.link));
    m_inForce = check.inForce;
    m_proposals->setInForce(check.inForce);
    m_envelope->setInForce(check.inForce, check.missing);
}

void DesignPage::showReport()
{
    const tuning::TuneReport *const known = report();
    m_model->setReport(known);
    m_plots->setWatermark(known && known->simulated ? tr("DEMO") : QString());
    m_proposals->showReport();
    m_column->fitSoon();
}

} // namespace mb
