// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/design/designframe.h"

#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/segmented.h"
#include "widgets/design/designcourse.h"
#include "widgets/design/designorders.h"

#include <QEvent>
#include <QFrame>
#include <QScrollArea>

#include <algorithm>

namespace mb {
namespace {

constexpr int modelWidth = 368;
constexpr int courseWidth = 264;
constexpr int mostCourse = 312;
constexpr double courseShare = 0.25; ///< of the page, between the two
constexpr int leastCurves = 350;     ///< between the two
constexpr int leastStatus = 260;     ///< beside the orders
constexpr int curvesHeight = 470;
enum FrameRow { Commands, CommandsLine, Tabs, Work };

} // namespace

DesignFrame::DesignFrame(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
{
    const Theme &look = theme.theme();
    m_grid = layoutIn<QGridLayout>(this, 0);
    m_commands = new QGridLayout;
    m_commands->setContentsMargins(look.u(12), look.u(6), look.u(12), look.u(6));
    m_commands->setSpacing(look.u(8));
    m_commands->setColumnStretch(0, 1);
    m_tabsRow = new QWidget(this);
    auto *row = layoutIn<QHBoxLayout>(m_tabsRow, look.u(8), {look.u(12), look.u(4), look.u(12), look.u(4)});
    m_tabs = new Segmented(tr("Part of the page"), {tr("Model"), tr("Curves"), tr("Course")}, m_tabsRow);
    row->addWidget(m_tabs);
    row->addStretch(1);
    m_tabsRow->hide();
    connect(m_tabs, &Segmented::currentChanged, this, &DesignFrame::arrange);
    connect(&theme, &ThemeSource::changed, this, &DesignFrame::arrange);
}

void DesignFrame::setParts(const Parts &parts)
{
    m_parts = parts;
    m_curvesArea = new QScrollArea(this);
    m_curvesArea->setWidgetResizable(true);
    m_curvesArea->setFrameShape(QFrame::NoFrame);
    m_curvesArea->setFocusPolicy(Qt::NoFocus);
    m_curvesArea->setWidget(parts.curves);
    m_lineBefore = separatorLine(Qt::Vertical, this);
    m_lineBehind = separatorLine(Qt::Vertical, this);
    m_grid->addLayout(m_commands, Commands, 0, 1, 5);
    m_grid->addWidget(separatorLine(Qt::Horizontal, this), CommandsLine, 0, 1, 5);
    m_grid->addWidget(m_tabsRow, Tabs, 0, 1, 5);
    int column = 0;
    for (QWidget *part :
        std::initializer_list<QWidget *>{parts.model, m_lineBefore, m_curvesArea, m_lineBehind, parts.course})
        m_grid->addWidget(part, Work, column++);
    m_grid->setRowStretch(Work, 1);
    arrange();
}

QSize DesignFrame::minimumSizeHint() const
{
    return {m_theme.theme().u(300), m_theme.theme().u(160)};
}

bool DesignFrame::event(QEvent *event)
{
    if (event->type() == QEvent::LayoutRequest) // other words on the orders
        fold();
    return QWidget::event(event);
}

/// One part at a time where there is no room for three; the status above the orders where there is none beside them.
void DesignFrame::fold()
{
    if (!m_parts.orders)
        return;
    const Theme &look = m_theme.theme();
    const bool compact = width() < look.u(modelWidth + leastCurves + courseWidth);
    const bool stacked = compact || width() < m_parts.orders->sizeHint().width() + look.u(leastStatus);
    const bool changed = compact != m_compact || stacked != m_stacked;
    if (!compact && !changed)
        setWidth(*m_parts.course, courseNow());
    m_compact = compact;
    m_stacked = stacked;
    if (changed) {
        m_parts.orders->setCompact(compact); // a line less
        arrange();
    }
    foldTabs();
}

void DesignFrame::foldTabs()
{
    const QMargins margins = m_tabsRow->layout()->contentsMargins();
    const int needed = margins.left() + m_tabs->leastUnfoldedWidth() + m_tabsRow->layout()->spacing()
        + m_parts.orders->proveButton()->sizeHint().width() + margins.right();
    m_tabs->setFolded(m_compact && needed > width());
}

/// Units of the right column: what is said there takes fewer lines where there is room.
int DesignFrame::courseNow() const
{
    const int share = static_cast<int>(courseShare * width() / m_theme.theme().u(100) * 100.0);
    return std::clamp(share, courseWidth, mostCourse);
}

void DesignFrame::setWidth(QWidget &column, int width) const
{
    column.setMinimumWidth(m_compact ? 0 : m_theme.theme().u(width));
    column.setMaximumWidth(m_compact ? QWIDGETSIZE_MAX : m_theme.theme().u(width));
}

/// The parts stay where they are in the grid; which of them are seen is all that changes.
void DesignFrame::arrange()
{
    if (!m_parts.model)
        return;
    const auto part = static_cast<Part>(m_tabs->current());
    m_commands->addWidget(m_parts.status, 0, 0);
    m_commands->addWidget(m_parts.orders, m_stacked ? 1 : 0, m_stacked ? 0 : 1);
    const int above = m_theme.theme().u(m_compact ? 4 : 6);
    m_commands->setContentsMargins(m_theme.theme().u(12), above, m_theme.theme().u(12), above);
    m_commands->setVerticalSpacing(m_theme.theme().u(m_compact ? 4 : 8));
    m_parts.course->setOrder(m_compact ? nullptr : m_parts.orders->proveButton());
    if (m_compact)
        m_tabsRow->layout()->addWidget(m_parts.orders->proveButton());
    m_tabsRow->setVisible(m_compact);
    m_lineBefore->setVisible(!m_compact);
    m_lineBehind->setVisible(!m_compact);
    m_parts.model->setVisible(!m_compact || part == Part::Model);
    m_curvesArea->setVisible(!m_compact || part == Part::Curves);
    m_parts.course->setVisible(!m_compact || part == Part::Course);
    setWidth(*m_parts.model, modelWidth);
    setWidth(*m_parts.course, courseNow());
    m_parts.curves->setMinimumHeight(m_theme.theme().u(curvesHeight));
    m_grid->setColumnStretch(0, m_compact && part == Part::Model ? 1 : 0);
    m_grid->setColumnStretch(2, !m_compact || part == Part::Curves ? 1 : 0);
    m_grid->setColumnStretch(4, m_compact && part == Part::Course ? 1 : 0);
}

} // namespace mb
