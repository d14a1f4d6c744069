// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/tunecolumn.h"

#include "model/loopparameters.h"
#include "widgets/common/calmwheel.h"
#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/numberformat.h"
#include "widgets/control/axespanel.h"
#include "widgets/control/driveoptions.h"
#include "widgets/control/envelopepanel.h"
#include "widgets/control/gainspanel.h"
#include "widgets/control/gainswriterow.h"
#include "widgets/control/jogpanel.h"
#include "widgets/control/modepanel.h"
#include "widgets/control/movespanel.h"
#include "widgets/control/setpointpanel.h"
#include "widgets/control/wrappedlabel.h"

#include <QScrollArea>
#include <QScrollBar>

namespace mb {

TuneColumn::TuneColumn(Workbench &workbench, Arming &arming, JogKeys &jog, const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
{
    auto *all = layoutIn<QVBoxLayout>(this, 0);
    auto *scroll = new QScrollArea(this);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setFocusPolicy(Qt::NoFocus);
    auto *panels = new QWidget(scroll);
    panels->setProperty("transparent", true);
    buildPanels(workbench, arming, jog, *panels);
    layOut(*panels, *scroll->verticalScrollBar());
    scroll->setWidget(panels);
    all->addWidget(scroll, 1);
    all->addWidget(separatorLine(Qt::Horizontal, this));
    m_writeRow = new GainsWriteRow(m_theme, this);
    all->addWidget(m_writeRow);
    connect(m_writeRow, &GainsWriteRow::revertRequested, m_gains, &GainsPanel::revertAll);
}

/// Tab goes through them in this order.
void TuneColumn::buildPanels(Workbench &workbench, Arming &arming, JogKeys &jog, QWidget &panels)
{
    m_axes = new AxesPanel(m_theme, &panels);
    m_axesLine = separatorLine(Qt::Horizontal, &panels);
    m_axesLine->hide();
    m_modes = new ModePanel(m_theme, &panels);
    m_setPoint = new SetPointPanel(m_theme, &panels);
    m_gains = new GainsPanel(m_theme, &panels);
    m_jog = new JogPanel(jog, m_theme, &panels);
    m_envelope = new EnvelopePanel(m_theme, &panels);
    m_live = new QWidget(&panels);
    m_firstPower = wrappedLabel({}, TextRole::Caption, Tone::Dim, m_live);
    m_firstPower->hide();
    m_moves = new MovesPanel(workbench, arming, m_theme, &panels);
    m_moves->hide();
    (new CalmWheel(&panels))->watch(*m_setPoint);
}

void TuneColumn::layOut(QWidget &panels, const QScrollBar &bar)
{
    const Theme &theme = m_theme.theme();
    auto *live = layoutIn<QVBoxLayout>(m_live, theme.u(8));
    for (QWidget *const part :
        {static_cast<QWidget *>(m_setPoint), static_cast<QWidget *>(m_jog), static_cast<QWidget *>(m_firstPower)})
        live->addWidget(part);
    auto *column = layoutIn<QVBoxLayout>(&panels, theme.u(8), {theme.u(12), theme.u(10), theme.u(12), theme.u(10)});
    column->addWidget(m_axes);
    column->addWidget(m_axesLine);
    column->addWidget(m_modes);
    column->addWidget(separatorLine(Qt::Horizontal, &panels));
    column->addWidget(m_envelope);
    column->addWidget(m_live);
    column->addWidget(separatorLine(Qt::Horizontal, &panels));
    column->addWidget(m_gains);
    column->addWidget(m_moves);
    column->addStretch(1);
    connect(&bar, &QScrollBar::rangeChanged, column, [column](int, int last) { // the bar takes the place of the margin
        const QMargins now = column->contentsMargins();
        column->setContentsMargins(now.left(), now.top(), last > 0 ? 0 : now.left(), now.bottom());
    });
}

void TuneColumn::setLive(bool live)
{
    m_envelope->setVisible(!live);
    m_live->setVisible(live);
}

void TuneColumn::setAxis(int axis)
{
    m_axes->setAxis(axis);
    m_axesLine->setVisible(axis > 0);
}

std::vector<int> TuneColumn::motorsToRun() const
{
    return m_axes->axis() > 0 ? m_axes->together() : std::vector{0};
}

void TuneColumn::showFirstPower(const DeviceView &view, int axis)
{
    const auto limit = parameterOfAxis(*view.family, axis, Role::PowerLimit);
    const double first = view.family->capabilities.firstPower;
    const bool unknown = axis > 0 && first > 0.0 && limit && limit->value < view.parameters->size()
        && !(*view.parameters)[limit->value].raw;
    m_firstPower->setVisible(unknown);
    if (unknown)
        m_firstPower->setText(tr("The power limit of axis %1 is unknown: its first motion sets it to %2. Write another "
                                 "under Limits of the axis.")
                                  .arg(axis)
                                  .arg(formatValue(first * 100.0, 0, tr("%"))));
}

void TuneColumn::chainAfter(QWidget *before)
{
    m_modes->chainAfter(m_axes->chainAfter(before));
}

} // namespace mb
