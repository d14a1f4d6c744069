// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/tunepage.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/emptystate.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/layoutin.h"
#include "widgets/control/axespanel.h"
#include "widgets/control/envelopepanel.h"
#include "widgets/control/gainspanel.h"
#include "widgets/control/gainswriterow.h"
#include "widgets/control/gainunits.h"
#include "widgets/control/jogkeys.h"
#include "widgets/control/jogpanel.h"
#include "widgets/control/movespanel.h"
#include "widgets/control/setpointpanel.h"
#include "widgets/control/triallist.h"
#include "widgets/control/trialsview.h"
#include "widgets/control/tuneaxes.h"
#include "widgets/control/tunecolumn.h"
#include "widgets/control/tunecommands.h"
#include "widgets/control/tuneexperiments.h"
#include "widgets/control/tuneform.h"
#include "widgets/control/tuneframe.h"
#include "widgets/control/tunekeys.h"
#include "widgets/control/tuneplot.h"
#include "widgets/control/tunesteps.h"
#include "widgets/parameters/editdesk.h"

#include <QStackedWidget>

namespace mb {

TunePage::TunePage(
    Workbench &workbench, Selection &selection, Arming &arming, const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_workbench(workbench)
    , m_selection(selection)
    , m_arming(arming)
{
    setObjectName(QStringLiteral("tunePage"));
    buildParts(theme);
    makeParts(theme);
    connectOrders();
    connectChanges();
    makeTuneKeys(*this, {m_parts, m_form.get(), m_motion.get(), m_gains.get(), m_experiments.get(), [this] { run(); }});
    showLive(m_choices->isLive());
    selectionChanged();
}

TunePage::~TunePage()
{
    column().gainsPanel().clear(); // before the edits that it shows
}

/// Tab goes through them in this order.
void TunePage::buildParts(const ThemeSource &theme)
{
    m_stack = new QStackedWidget(this);
    m_empty = new EmptyState(theme, Symbol::Wave, {}, {}, m_stack);
    m_frame = new TuneFrame(theme, m_stack);
    m_parts.stimulus = new StimulusBar(theme, m_frame);
    m_parts.commands = new TuneCommands(theme, m_frame);
    auto *const jog = new JogKeys(m_arming, *this, [this](bool forwards) { return m_motion->jog(forwards); });
    m_parts.column = new TuneColumn(m_workbench, m_arming, *jog, theme, m_frame);
    m_work = new QStackedWidget(m_frame);
    m_parts.trials = new TrialsView(m_workbench, theme, m_work);
    m_parts.plot = new TunePlot(m_workbench, theme, m_work);
    m_work->addWidget(m_parts.trials);
    m_work->addWidget(m_parts.plot);
    m_frame->setParts({m_parts.commands, m_parts.stimulus, m_parts.column, m_work, m_parts.trials});
    m_stack->addWidget(m_empty);
    m_stack->addWidget(m_frame);
    auto *all = layoutIn<QVBoxLayout>(this);
    all->addWidget(m_stack);
}

void TunePage::makeParts(const ThemeSource &theme)
{
    m_choices = std::make_unique<TuneChoices>(m_workbench, m_selection);
    m_motion = std::make_unique<TuneMotion>(m_workbench, m_arming, *m_choices, column());
    m_axes = std::make_unique<TuneAxes>(m_workbench, *m_choices, *m_motion, column());
    m_gains = std::make_unique<TuneGains>(m_workbench, m_arming, *m_choices, column());
    m_experiments = std::make_unique<TuneExperiments>(
        TuneExperiments::Surroundings{m_workbench, m_arming, *m_choices, *m_motion, *m_gains}, m_parts, theme, *this);
    m_form = std::make_unique<TuneForm>(*m_choices, *m_motion, m_parts, m_arming);
}

/// What somebody orders in a panel, and who does it.
void TunePage::connectOrders()
{
    connect(m_parts.commands, &TuneCommands::runRequested, this, &TunePage::run);
    connect(m_parts.commands, &TuneCommands::stopRequested, this, &TunePage::halt);
    connect(m_parts.commands, &TuneCommands::liveChosen, this, &TunePage::showLive);
    connect(m_frame, &TuneFrame::liveChosen, this, &TunePage::showLive);
    connect(&column().writeRow(), &GainsWriteRow::writeRequested, this, &TunePage::write);
    connect(&column().setPointPanel(), &SetPointPanel::zeroRequested, this, &TunePage::zero);
    connect(&column().setPointPanel(), &SetPointPanel::targetChosen, this, [this] {
        if (m_arming.isMoving() && status().mayRun)
            m_motion->start();
    });
    const AxesPanel *const panel = &column().axesPanel();
    connect(
        panel, &AxesPanel::axisChosen, this, [this](int axis) { m_selection.select(m_choices->shown().device, axis); });
    connect(panel, &AxesPanel::spreadRequested, m_axes.get(), &TuneAxes::spread);
    connect(panel, &AxesPanel::copyGainsRequested, m_gains.get(), &TuneGains::stageAxis);
    connect(m_parts.trials, &TrialsView::useRequested, m_gains.get(), &TuneGains::stageTrial);
    connect(m_parts.trials, &TrialsView::stageRequested, m_gains.get(), &TuneGains::stageAdvice);
    // no set-point of this page comes between the moves that a device was given
    connect(&column().movesPanel(), &MovesPanel::taken, m_choices.get(), &TuneChoices::forgetMotion);
}

void TunePage::connectChanges()
{
    connect(m_frame, &TuneFrame::compactChanged, m_parts.commands, &TuneCommands::setFolded);
    connect(m_frame, &TuneFrame::compactChanged, this, &TunePage::showCommands);
    connect(&column().setPointPanel(), &SetPointPanel::changed, this, &TunePage::showCommands);
    connect(&column().axesPanel(), &AxesPanel::togetherChanged, this, &TunePage::follow);
    connect(m_choices.get(), &TuneChoices::edited, this, &TunePage::follow);
    connect(m_axes.get(), &TuneAxes::changed, this, &TunePage::follow);
    connect(m_gains.get(), &TuneGains::changed, this, &TunePage::follow);
    connect(m_experiments.get(), &TuneExperiments::changed, this, &TunePage::follow);
    connect(m_form.get(), &TuneForm::changed, this, &TunePage::follow);
    connect(&m_workbench, &Workbench::changed, this, &TunePage::follow);
    connect(&m_arming, &Arming::changed, this, &TunePage::follow);
    connect(&m_selection, &Selection::changed, this, &TunePage::selectionChanged);
}

void TunePage::showLive(bool live)
{
    m_choices->setLive(live);
    m_parts.commands->setLive(live);
    m_work->setCurrentWidget(live ? static_cast<QWidget *>(m_parts.plot) : m_parts.trials);
    m_frame->setLive(live);
    column().setLive(live);
    follow();
}

bool TunePage::isLive() const
{
    return m_choices->isLive();
}

void TunePage::selectionChanged()
{
    if (m_arming.isArmed(m_arming.device()) && m_arming.device() != m_selection.device()) {
        m_workbench.report(Severity::Info, {}, tr("disarmed: another device is selected"));
        m_arming.disarm();
    }
    follow();
}

void TunePage::follow()
{
    if (!m_arming.isMoving())
        m_choices->forgetMotion();
    const DeviceView *const view = m_choices->device();
    const bool usable = view && view->identity->state != DeviceState::Bootloader;
    wishRates(usable ? view : nullptr);
    if (usable)
        followDevice(*view);
    else
        showEmpty(view);
    m_stack->setCurrentIndex(usable ? 1 : 0);
}

void TunePage::wishRates(const DeviceView *view)
{
    std::vector<RateWish> wishes;
    if (view && isVisible() && isLive() && (m_arming.isArmed(view->id) || PageRates::isFree(*view))) {
        for (const ChannelRate &rate : view->family->watched) {
            if (const auto channel = findChannel(view->family->channels, rate.channel))
                wishes.push_back({view->id, *channel, rate.hertz});
        }
    }
    m_rates.wish(std::move(wishes));
}

void TunePage::followDevice(const DeviceView &view)
{
    const int axis = m_choices->axisOf(view);
    m_choices->make(view);
    if (m_choices->shown() != TuneMotor{view.id, axis}) {
        m_form->show(view, axis);
        column().chainAfter(m_parts.commands->runButton());
    }
    m_form->followProfile(view);
    m_parts.plot->choose(view, m_choices->current()->mode, axis, m_axes->beside());
    m_parts.plot->follow(view);
    m_motion->follow(view);
    m_axes->follow(view);
    if (isVisible())
        EditDesk::of(m_workbench).readOnce(view);
    m_gains->follow(view);
    column().movesPanel().follow(view);
    if (!isLive())
        column().movesPanel().hide();
    m_experiments->follow(view);
    showCommands();
}

void TunePage::showCommands()
{
    const DeviceView *const view = m_choices->device();
    if (!view || view->id != m_choices->shown().device)
        return;
    column().jogPanel().setPossible(m_arming.state() == LampState::Armed && m_motion->jog(true),
        m_arming.isArmed(view->id) ? tr("Something moves") : tr("Hold the Arm button for 1 s to arm it first."));
    const TuneChoice &chosen = *m_choices->current();
    TuneCommands::State orders;
    orders.status = status();
    orders.writes = chosen.editedSlot == chosen.runningSlot && !column().gainsPanel().stagedNames().isEmpty();
    orders.together = static_cast<int>(column().motorsToRun().size());
    orders.moving = m_motion->isMoving(*view, m_choices->axis());
    orders.mayStop = orders.moving || m_arming.isOnTrial(view->id);
    const bool others = view->motion.setPoints.size() > 1 && orders.together < 2;
    orders.stopsAxis = orders.moving && others ? m_choices->axis() : 0;
    m_parts.commands->show(orders);
    showSteps(*view, chosen);
    m_gains->showWriteRow(*view);
}

void TunePage::showSteps(const DeviceView &view, const TuneChoice &chosen)
{
    TuneKnowledge known;
    known.device = &view;
    known.axis = m_choices->axis();
    if (isClosedLoop(chosen.mode))
        known.gains = gainSet(*view.family, chosen.mode, chosen.runningSlot, known.axis).gains;
    known.missing = column().envelope().missing();
    known.identified = m_parts.trials->list().identified();
    known.staged = !column().gainsPanel().stagedNames().isEmpty();
    const std::vector<KeptTrial> &trials = m_parts.trials->list().model().trials();
    known.newest = trials.empty() ? nullptr : &trials.back();
    m_parts.commands->steps().show(known);
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
    const DeviceView *const view = m_choices->device();
    if (!view)
        return {GlyphState::Gone, tr("No device"), {}, false};
    const QString name = QStringLiteral("#%1").arg(view->identity->address);
    if (!view->liveness.heard)
        return {GlyphState::Gone, tr("No answer from %1").arg(name), tr("The plot keeps what it has."), false};
    if (m_arming.state() == LampState::Stopped)
        return {m_arming.isStoppedByHand() ? GlyphState::Gone : GlyphState::Fault,
            tr("Stopped: %1").arg(m_arming.reason()), tr("Hold the Arm button for 1 s to arm again."), false};
    if (!view->mayNotMove.empty())
        return {GlyphState::Warning, tr("%1 cannot be armed").arg(name), messageText(view->mayNotMove), false};
    if (const QString fault = m_parts.column->setPointPanel().fault(); isLive() && !fault.isEmpty())
        return {GlyphState::OutOfRange, tr("The set-point cannot be sent"), fault, false};
    if (const auto obstacle = m_gains->obstacle(*view))
        return *obstacle;
    const bool byHand = isLive() && !m_arming.isOnTrial(view->id);
    return byHand ? m_motion->status(*view, name) : m_experiments->status(*view, name);
}

void TunePage::run()
{
    const PageStatus now = status();
    if (!now.mayRun) {
        m_workbench.report(Severity::Caution, {}, tr("not run: %1. %2").arg(now.cause, now.remedy));
        return;
    }
    const TuneChoice &chosen = *m_choices->current();
    if (!isLive())
        m_experiments->run();
    else if (chosen.editedSlot == chosen.runningSlot && !column().gainsPanel().toWrite().empty())
        m_gains->write([this] { m_motion->start(); });
    else
        m_motion->start();
    showCommands();
}

void TunePage::write()
{
    if (!column().writeRow().mayWrite())
        return;
    m_gains->write();
    showCommands();
}

void TunePage::halt()
{
    m_experiments->endTurns();
    m_motion->halt();
}

void TunePage::zero()
{
    halt();
    m_motion->zero();
}

} // namespace mb
