// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/tunepage.h"

#include "widgets/common/calmwheel.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/emptystate.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/labels.h"
#include "widgets/common/segmented.h"
#include "widgets/control/axespanel.h"
#include "widgets/control/driveoptions.h"
#include "widgets/control/envelopepanel.h"
#include "widgets/control/gainspanel.h"
#include "widgets/control/jogkeys.h"
#include "widgets/control/jogpanel.h"
#include "widgets/control/modepanel.h"
#include "widgets/control/movespanel.h"
#include "widgets/control/setpointpanel.h"
#include "widgets/control/stimulusbar.h"
#include "widgets/control/trialsview.h"
#include "widgets/control/tuneframe.h"
#include "widgets/control/tunekeys.h"
#include "widgets/control/tuneplot.h"
#include "widgets/control/wrappedlabel.h"

#include <QHBoxLayout>
#include <QScrollArea>
#include <QScrollBar>
#include <QStackedWidget>
#include <QUndoStack>

namespace mb {
namespace {

} // namespace

TunePage::TunePage(
    Workbench &workbench, Selection &selection, Arming &arming, const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_workbench(workbench)
    , m_desk(EditDesk::of(workbench))
    , m_selection(selection)
    , m_arming(arming)
    , m_theme(theme)
{
    setObjectName(QStringLiteral("tunePage"));
    m_stack = new QStackedWidget(this);
    m_empty = new EmptyState(theme, Symbol::Wave, {}, {}, m_stack);
    m_frame = new TuneFrame(theme, m_stack);
    m_stimulus = new StimulusBar(m_theme, m_frame);
    QWidget *const commands = buildCommands();
    QWidget *const column = buildColumn();
    QWidget *const work = buildWork();
    m_frame->setParts({commands, m_stimulus, column, work, m_trials});
    m_stack->addWidget(m_empty);
    m_stack->addWidget(m_frame);
    auto *all = new QVBoxLayout(this);
    all->setContentsMargins(0, 0, 0, 0);
    all->addWidget(m_stack);
    connectPanels();
    makeTuneKeys(*this);
    showLive(false);
    selectionChanged();
}

TunePage::~TunePage()
{
    m_gains->clear(); // before the edits that it shows
}

QWidget *TunePage::buildWork()
{
    m_work = new QStackedWidget(this);
    m_trials = new TrialsView(m_workbench, m_theme, m_work);
    m_work->addWidget(m_trials);
    m_work->addWidget(buildLive());
    connect(m_trials, &TrialsView::useRequested, this, &TunePage::useGains);
    connect(m_trials, &TrialsView::stageRequested, this, &TunePage::stageAdvice);
    return m_work;
}

QWidget *TunePage::buildLive()
{
    m_plot = new TunePlot(m_workbench, m_theme, m_work);
    return m_plot;
}

QWidget *TunePage::buildCommands()
{
    const Theme &theme = m_theme.theme();
    auto *bar = new QWidget(this);
    auto *row = new QHBoxLayout(bar);
    row->setContentsMargins(theme.u(12), theme.u(6), theme.u(12), theme.u(6));
    row->setSpacing(theme.u(8));
    m_status = new StatusLine(m_theme, bar);
    m_halt = new CommandButton(m_theme, Symbol::Stop, tr("Stop motion"), bar);
    m_halt->setTextVariants({tr("Stop motion"), tr("Stop axis %1").arg(8)});
    m_halt->setToolTip(tr("Ends the motion and stays armed. STOP, Esc and Pause stop everything."));
    m_run = new CommandButton(m_theme, Symbol::Play, tr("Run"), bar);
    m_run->setPrimary(true);
    m_run->setKeyHint(QStringLiteral("F5"));
    m_run->setTextVariants({tr("Run"), tr("Write and run"), tr("Apply"), tr("Run %1 axes").arg(8)});
    m_run->setObjectName(QStringLiteral("run"));
    m_view = new Segmented(tr("View"), {tr("Experiment"), tr("Live")}, bar);
    row->addWidget(m_status, 1);
    row->addWidget(m_view);
    row->addWidget(m_halt);
    row->addWidget(m_run);
    return bar;
}

/// Without room the tabs below have the views, and the button that stops is its sign.
void TunePage::foldCommands(bool folded)
{
    m_view->setVisible(!folded);
    m_halt->setTextVariants(folded ? QStringList() : QStringList{tr("Stop motion"), tr("Stop axis %1").arg(8)});
    showCommands();
}

QWidget *TunePage::buildColumn()
{
    const Theme &theme = m_theme.theme();
    auto *column = new QWidget(this);
    auto *all = new QVBoxLayout(column);
    all->setContentsMargins(0, 0, 0, 0);
    all->setSpacing(0);
    auto *scroll = new QScrollArea(column);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setFocusPolicy(Qt::NoFocus);
    auto *panels = new QWidget(scroll);
    panels->setProperty("transparent", true);
    auto *inner = new QVBoxLayout(panels);
    inner->setContentsMargins(theme.u(12), theme.u(10), theme.u(12), theme.u(10));
    inner->setSpacing(theme.u(8));
    m_axes = new AxesPanel(m_theme, panels);
    m_axesLine = separatorLine(Qt::Horizontal, panels);
    m_axesLine->hide();
    inner->addWidget(m_axes);
    inner->addWidget(m_axesLine);
    m_modes = new ModePanel(m_theme, panels);
    m_setPoint = new SetPointPanel(m_theme, panels);
    m_gains = new GainsPanel(m_theme, panels);
    inner->addWidget(m_modes);
    m_jog = new JogKeys(m_arming, *this, [this](bool forwards) { return jogSetPoint(forwards); });
    m_jogPanel = new JogPanel(*m_jog, m_theme, panels);
    inner->addWidget(separatorLine(Qt::Horizontal, panels));
    m_envelope = new EnvelopePanel(m_theme, panels);
    inner->addWidget(m_envelope);
    m_liveColumn = new QWidget(panels);
    auto *byHand = new QVBoxLayout(m_liveColumn);
    byHand->setContentsMargins(0, 0, 0, 0);
    byHand->setSpacing(theme.u(8));
    byHand->addWidget(m_setPoint);
    byHand->addWidget(m_jogPanel);
    m_firstPower = wrappedLabel({}, TextRole::Caption, Tone::Dim, panels);
    m_firstPower->hide();
    byHand->addWidget(m_firstPower);
    inner->addWidget(m_liveColumn);
    inner->addWidget(separatorLine(Qt::Horizontal, panels));
    inner->addWidget(m_gains);
    m_moves = new MovesPanel(m_workbench, m_arming, m_theme, panels);
    m_moves->hide();
    inner->addWidget(m_moves);
    inner->addStretch(1);
    (new CalmWheel(panels))->watch(*m_setPoint);
    scroll->setWidget(panels);
    connect(scroll->verticalScrollBar(), &QScrollBar::rangeChanged, inner,
        [inner](int, int last) { // the bar takes the place of the margin
            const QMargins now = inner->contentsMargins();
            inner->setContentsMargins(now.left(), now.top(), last > 0 ? 0 : now.left(), now.bottom());
        });
    all->addWidget(scroll, 1);
    all->addWidget(separatorLine(Qt::Horizontal, column));
    all->addWidget(buildWriteRow());
    return column;
}

QWidget *TunePage::buildWriteRow()
{
    const Theme &theme = m_theme.theme();
    auto *box = new QWidget(this);
    auto *row = new QHBoxLayout(box);
    row->setContentsMargins(theme.u(12), theme.u(8), theme.u(12), theme.u(8));
    row->setSpacing(theme.u(8));
    m_write = new CommandButton(m_theme, tr("Write gains"), box);
    m_write->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    m_write->setObjectName(QStringLiteral("writeGains"));
    m_revert = new CommandButton(m_theme, Symbol::Undo, tr("Revert"), box);
    m_revert->setAccessibleName(tr("Revert all staged gains"));
    row->addWidget(m_write, 1);
    row->addWidget(m_revert);
    connect(m_write, &QPushButton::clicked, this, &TunePage::write);
    connect(m_revert, &QPushButton::clicked, m_gains, &GainsPanel::revertAll);
    return box;
}

void TunePage::connectPanels()
{
    connect(m_run, &QPushButton::clicked, this, &TunePage::run);
    connect(m_halt, &QPushButton::clicked, this, &TunePage::halt);
    connect(m_modes, &ModePanel::modeChanged, this, &TunePage::modeChosen);
    connect(m_modes, &ModePanel::editedSlotChanged, this, &TunePage::slotsChosen);
    connect(m_modes, &ModePanel::runningSlotChanged, this, [this] {
        disarmBecause(tr("the running slot"));
        slotsChosen();
    });
    connect(m_axes, &AxesPanel::axisChosen, this, [this](int axis) { m_selection.select(m_shown, axis); });
    connect(m_axes, &AxesPanel::togetherChanged, this, &TunePage::follow);
    connect(m_axes, &AxesPanel::spreadRequested, this, &TunePage::spread);
    connect(m_axes, &AxesPanel::copyGainsRequested, this, &TunePage::copyGains);
    connect(m_setPoint, &SetPointPanel::targetChosen, this, &TunePage::applyTarget);
    connect(m_setPoint, &SetPointPanel::changed, this, &TunePage::showCommands);
    connect(m_setPoint, &SetPointPanel::polarityChanged, this, [this] { disarmBecause(tr("a direction or a limit")); });
    connect(m_setPoint, &SetPointPanel::zeroRequested, this, &TunePage::zero);
    connect(m_moves, &MovesPanel::taken, this, [this] { // no set-point of this page comes between
        forgetMotion();
    });
    connect(m_view, &Segmented::currentChanged, this, &TunePage::viewChosen);
    connect(m_frame, &TuneFrame::liveChosen, this, &TunePage::showLive);
    connect(m_frame, &TuneFrame::compactChanged, this, &TunePage::foldCommands);
    connect(m_stimulus, &StimulusBar::changed, this, &TunePage::stimulusChosen);
    connect(m_envelope, &EnvelopePanel::changed, this, &TunePage::stimulusChosen);
    connect(m_envelope, &EnvelopePanel::failed, this, [this](const QString &cause) {
        m_workbench.report(Severity::Caution, {}, tr("the limits were not kept: %1").arg(cause));
    });
    connect(m_plot, &TunePlot::unitsChanged, this, &TunePage::unitsChosen);
    connect(&m_workbench, &Workbench::changed, this, &TunePage::follow);
    connect(&m_arming, &Arming::changed, this, &TunePage::follow);
    connect(&m_selection, &Selection::changed, this, &TunePage::selectionChanged);
}

void TunePage::undo(bool again)
{
    const Choice *const chosen = choice();
    const DeviceView *view = device();
    if (!chosen || !chosen->edits || !view)
        return;
    QUndoStack &stack = chosen->edits->undoStack();
    if (again ? stack.canRedo() : stack.canUndo() && !stack.isClean()) {
        again ? stack.redo() : stack.undo();
        return;
    }
    if (!view->liveness.heard)
        return;
    m_workbench.send(orders::UndoWrite{view->id, again},
        [self = QPointer<TunePage>(this), name = titleOf(*view)](const Result<void> &result) {
            if (self && !result)
                self->m_workbench.report(Severity::Danger, name, errorText(result.error()));
        });
}

} // namespace mb
