// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/tuneframe.h"

#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/segmented.h"
#include "widgets/control/trialsview.h"

#include <QFrame>

#include <algorithm>

namespace mb {
namespace {

constexpr int columnWidth = 336;
constexpr int narrowColumn = 322; ///< where the plot would get too little beside it
constexpr int narrowFrame = 1120;
constexpr int leastWork = 440;   ///< beside the column
constexpr int leastHeight = 440; ///< for stimulus, plot and trials below each other
enum TuneFrameRow { CommandsAt, CommandsLineAt, TabsAt, StimulusAt, StimulusLineAt, WorkAt };

} // namespace

TuneFrame::TuneFrame(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
{
    m_grid = layoutIn<QGridLayout>(this, 0);
    m_tabsRow = new QWidget(this);
    auto *row = layoutIn<QHBoxLayout>(
        m_tabsRow, -1, {theme.theme().u(12), theme.theme().u(4), theme.theme().u(12), theme.theme().u(4)});
    m_tabs = new Segmented(
        tr("Part of the page"), {tr("Set-up"), tr("Plot"), tr("Metrics"), tr("Trials"), tr("Live")}, m_tabsRow);
    m_tabs->setCurrent(static_cast<int>(Part::Response));
    row->addWidget(m_tabs);
    row->addStretch(1);
    connect(m_tabs, &Segmented::currentChanged, this, &TuneFrame::chosen);
    connect(&theme, &ThemeSource::changed, this, &TuneFrame::arrange);
}

void TuneFrame::setParts(const Parts &parts)
{
    m_parts = parts;
    m_stimulusLine = separatorLine(Qt::Horizontal, this);
    m_columnLine = separatorLine(Qt::Vertical, this);
    m_grid->addWidget(parts.commands, CommandsAt, 0, 1, 3);
    m_grid->addWidget(separatorLine(Qt::Horizontal, this), CommandsLineAt, 0, 1, 3);
    m_grid->addWidget(m_tabsRow, TabsAt, 0, 1, 3);
    m_grid->addWidget(parts.stimulus, StimulusAt, 0, 1, 3);
    m_grid->addWidget(m_stimulusLine, StimulusLineAt, 0, 1, 3);
    m_grid->addWidget(parts.column, WorkAt, 0);
    m_grid->addWidget(m_columnLine, WorkAt, 1);
    m_grid->addWidget(parts.work, WorkAt, 2);
    m_grid->setColumnStretch(2, 1);
    m_grid->setRowStretch(WorkAt, 1);
    arrange();
}

QSize TuneFrame::minimumSizeHint() const
{
    const bool strips = m_compact && m_tabs->current() == static_cast<int>(Part::Live); // would lie over each other
    return {m_theme.theme().u(300), std::max(m_theme.theme().u(160), strips ? m_grid->minimumSize().height() : 0)};
}

void TuneFrame::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    const Theme &theme = m_theme.theme();
    const bool compact = width() < theme.u(columnWidth + leastWork) || height() < theme.u(leastHeight);
    if (compact == m_compact)
        return fitColumn();
    m_compact = compact;
    arrange();
    Q_EMIT compactChanged(compact);
}

void TuneFrame::setLive(bool live)
{
    if (live == m_live)
        return;
    m_live = live;
    const bool setUp = m_tabs->current() == static_cast<int>(Part::Setup);
    if (!setUp || !m_compact) {
        const QSignalBlocker quiet(m_tabs);
        m_tabs->setCurrent(static_cast<int>(live ? Part::Live : Part::Response));
    }
    arrange();
}

void TuneFrame::show(Part part)
{
    m_tabs->setCurrent(static_cast<int>(part));
}

void TuneFrame::chosen(int tab)
{
    const auto part = static_cast<Part>(tab);
    if (part != Part::Setup && (part == Part::Live) != m_live)
        Q_EMIT liveChosen(part == Part::Live);
    arrange();
}

void TuneFrame::fitColumn()
{
    if (!m_parts.column)
        return;
    const Theme &theme = m_theme.theme();
    const int wide = theme.u(width() < theme.u(narrowFrame) ? narrowColumn : columnWidth);
    m_parts.column->setMinimumWidth(m_compact ? 0 : wide);
    m_parts.column->setMaximumWidth(m_compact ? QWIDGETSIZE_MAX : wide);
}

/// The parts stay where they are in the grid; which of them are seen is all that changes.
void TuneFrame::arrange()
{
    if (!m_parts.work)
        return;
    const auto part = static_cast<Part>(m_tabs->current());
    const bool setUp = !m_compact || part == Part::Setup;
    m_tabsRow->setVisible(m_compact);
    m_parts.stimulus->setVisible(setUp && !m_live);
    m_stimulusLine->setVisible(setUp && !m_live);
    m_parts.column->setVisible(setUp);
    fitColumn();
    m_columnLine->setVisible(!m_compact);
    m_parts.work->setVisible(!m_compact || part != Part::Setup);
    m_grid->setColumnStretch(0, m_compact && setUp ? 1 : 0);
    m_grid->setColumnStretch(2, m_compact && setUp ? 0 : 1);
    m_parts.trials->setShown(!m_compact ? TrialsView::Shown::All
            : part == Part::Metrics     ? TrialsView::Shown::Metrics
            : part == Part::Trials      ? TrialsView::Shown::Trials
                                        : TrialsView::Shown::Plot);
    updateGeometry();
}

} // namespace mb
