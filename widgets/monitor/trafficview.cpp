// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/trafficview.h"

#include "widgets/monitor/trafficdelegate.h"

#include <QHeaderView>
#include <QScrollBar>

#include <algorithm>

namespace mb {
namespace {

constexpr int aroundHead = 12; ///< units

} // namespace

TrafficView::TrafficView(
    const ThemeSource &theme, const QString &name, std::vector<int> widths, int stretching, QWidget *parent)
    : QTableView(parent)
    , m_theme(theme)
    , m_widths(std::move(widths))
    , m_stretching(stretching)
{
    setAccessibleName(name);
    horizontalHeader()->setAccessibleName(tr("Columns of %1").arg(name));
    setItemDelegate(new TrafficDelegate(theme, this));
    verticalHeader()->hide();
    verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setShowGrid(false);
    setFrameShape(QFrame::NoFrame);
    setWordWrap(false);
    setTabKeyNavigation(false);
    setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    connect(&theme, &ThemeSource::changed, this, &TrafficView::layOut);
}

void TrafficView::setModel(QAbstractItemModel *model)
{
    QTableView::setModel(model);
    layOut();
}

bool TrafficView::isAtEnd() const
{
    return verticalScrollBar()->value() >= verticalScrollBar()->maximum();
}

void TrafficView::resizeEvent(QResizeEvent *event)
{
    QTableView::resizeEvent(event);
    layOut();
}

void TrafficView::layOut()
{
    if (!model())
        return;
    const Theme &theme = m_theme.theme();
    verticalHeader()->setMinimumSectionSize(theme.u(18));
    verticalHeader()->setDefaultSectionSize(theme.u(25));
    const QFontMetrics head(horizontalHeader()->font());
    const auto widthOf = [&](std::size_t i) { // a head in another language may be longer than what is below it
        const QString text = model()->headerData(static_cast<int>(i), Qt::Horizontal).toString();
        return std::max(theme.u(m_widths[i]), head.horizontalAdvance(text) + theme.u(aroundHead));
    };
    int rest = viewport()->width();
    for (std::size_t i = 0; i < m_widths.size(); ++i)
        rest -= static_cast<int>(i) == m_stretching ? 0 : widthOf(i);
    const int least = theme.u(m_widths[static_cast<std::size_t>(m_stretching)]);
    for (const int column : m_spare) {
        const bool spared = rest < least;
        setColumnHidden(column, spared);
        rest += spared ? widthOf(static_cast<std::size_t>(column)) : 0;
    }
    const int shared = m_sharing >= 0 ? std::max(0, rest - least) / 2 : 0;
    for (std::size_t i = 0; i < m_widths.size(); ++i) {
        const int column = static_cast<int>(i);
        const int own = widthOf(i) + (column == m_sharing ? shared : 0);
        setColumnWidth(column, column == m_stretching ? std::max(rest - shared, least) : own);
    }
}

} // namespace mb
