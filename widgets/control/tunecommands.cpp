// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/tunecommands.h"

#include "widgets/common/iconbutton.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/segmented.h"
#include "widgets/common/spoken.h"
#include "widgets/control/tunesteps.h"

namespace mb {
namespace {

constexpr int leastSentence = 200;

} // namespace

TuneCommands::TuneCommands(const ThemeSource &source, QWidget *parent)
    : QWidget(parent)
    , m_theme(source)
{
    const Theme &theme = source.theme();
    auto *row = layoutIn<QHBoxLayout>(this, theme.u(8), {theme.u(12), theme.u(6), theme.u(12), theme.u(6)});
    m_steps = new TuneSteps(source, this);
    m_status = new StatusLine(source, this);
    m_stop = new CommandButton(source, Symbol::Stop, tr("Stop motion"), this);
    m_stop->setToolTip(tr("Ends the motion and stays armed. STOP, Esc and Pause stop everything."));
    m_run = new CommandButton(source, Symbol::Play, tr("Run"), this);
    m_run->setPrimary(true);
    m_run->setKeyHint(QStringLiteral("F5"));
    m_run->setTextVariants({tr("Run"), tr("Write and run"), tr("Apply"), tr("Run %1 axes").arg(8)});
    m_run->setObjectName(QStringLiteral("run"));
    m_view = new Segmented(tr("View"), {tr("Experiment"), tr("Live")}, this);
    row->addWidget(m_steps);
    row->addWidget(m_status, 1);
    row->addStretch();
    row->addWidget(m_view);
    row->addWidget(m_stop);
    row->addWidget(m_run);
    setFolded(false);
    connect(m_run, &QPushButton::clicked, this, &TuneCommands::runRequested);
    connect(m_stop, &QPushButton::clicked, this, &TuneCommands::stopRequested);
    connect(m_view, &Segmented::currentChanged, this, [this](int view) { Q_EMIT liveChosen(view == 1); });
}

/// All words where the sentence beside them keeps its room.
void TuneCommands::fitSteps()
{
    int others = m_theme.theme().u(6 * 8);
    for (const QWidget *const beside :
        {static_cast<QWidget *>(m_view), static_cast<QWidget *>(m_stop), static_cast<QWidget *>(m_run)})
        others += beside->isHidden() ? 0 : beside->sizeHint().width();
    m_steps->setFolded(
        m_steps->unfoldedWidth() > width() - others - m_theme.theme().u(m_status->isHidden() ? 0 : leastSentence));
    // Where there is no room for its discs either it goes, before a button is cut; else the sentence beside it gives way.
    const int steps = m_steps->sizeHint().width();
    m_steps->setFixedWidth(steps > width() - others ? 0 : steps);
}

void TuneCommands::setFolded(bool folded)
{
    m_folded = folded;
    m_view->setVisible(!folded);
    m_stop->setTextVariants(folded ? QStringList() : QStringList{tr("Stop motion"), tr("Stop axis %1").arg(8)});
}

void TuneCommands::setLive(bool live)
{
    const QSignalBlocker quiet(m_view);
    m_view->setCurrent(live ? 1 : 0);
}

bool TuneCommands::isLive() const
{
    return m_view->current() == 1;
}

void TuneCommands::show(const State &state)
{
    const PageStatus &now = state.status;
    m_status->say(now, m_folded);
    // The lamp of the window says ARMED, and the steps say what comes next.
    m_status->setHidden(now.glyph == GlyphState::Online && now.mayRun && !isLive() && !m_steps->isHidden());
    fitSteps();
    m_run->setText(state.writes        ? tr("Write and run")
            : state.together > 1       ? tr("Run %1 axes").arg(state.together)
            : state.moving && isLive() ? tr("Apply")
                                       : tr("Run"));
    m_run->setEnabled(now.mayRun);
    m_run->setToolTip(now.mayRun ? QString() : now.cause + QStringLiteral(": ") + now.remedy);
    setSpoken(*m_run, m_run->text(), m_run->toolTip());
    m_stop->setEnabled(state.mayStop);
    const QString stop = state.stopsAxis > 0 ? tr("Stop axis %1").arg(state.stopsAxis) : tr("Stop motion");
    m_stop->setText(m_folded ? QString() : stop);
    setSpoken(*m_stop, stop, m_stop->accessibleDescription());
}

} // namespace mb
