// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/bustables.h"

#include "widgets/common/devicetext.h"
#include "widgets/monitor/framemodel.h"
#include "widgets/monitor/idmodel.h"
#include "widgets/monitor/trafficview.h"

#include <QHeaderView>
#include <QMenu>
#include <QScrollBar>
#include <QShortcut>

#include <algorithm>

namespace mb {
namespace {

constexpr int leastFrames = 176; ///< units

} // namespace

BusTables::BusTables(const ThemeSource &theme, FrameModel &frames, IdModel &ids, QWidget *parent)
    : QSplitter(Qt::Vertical, parent)
    , m_theme(theme)
    , m_model(frames)
    , m_ids(ids)
{
    // heard before the table hears it and moves its cursor
    connect(&frames, &FrameModel::rowsAboutToBeRemoved, this, [this] { m_isTrimmed = true; });
    connect(&frames, &FrameModel::rowsRemoved, this, [this] { m_isTrimmed = false; });
    build();
    auto *copy = new QShortcut(QKeySequence::Copy, m_frames);
    copy->setContext(Qt::WidgetShortcut);
    connect(copy, &QShortcut::activated, this, &BusTables::copyRequested);
    connect(m_frames->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this] {
        if (!m_isTrimmed)
            Q_EMIT currentChanged();
    });
    connect(m_idTable, &QWidget::customContextMenuRequested, this, &BusTables::chooseField);
    connect(m_frames->verticalScrollBar(), &QScrollBar::actionTriggered, this, [this] {
        const QScrollBar *bar = m_frames->verticalScrollBar();
        Q_EMIT scrolled(bar->sliderPosition() < bar->maximum());
    });
}

void BusTables::build()
{
    m_lower = new QSplitter(Qt::Horizontal, this);
    m_frames = new TrafficView(m_theme, tr("Frames"), {88, 66, 54, 88, 132, 42, 200, 208}, FrameModel::Decoded, this);
    m_frames->setSpare({FrameModel::Delta, FrameModel::Data});
    m_frames->setMinimumHeight(m_theme.theme().u(leastFrames)); // some lines, before the page scrolls
    m_frames->setModel(&m_model);
    m_frames->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_idTable = new TrafficView(
        m_theme, tr("Identifiers"), {88, 44, 132, 42, 72, 72, 66, 208, 118, 80}, IdModel::Value, m_lower);
    m_idTable->setSpare({IdModel::Data});
    m_idTable->setSharing(IdModel::Spark);
    m_idTable->setModel(&m_ids);
    m_idTable->setSelectionMode(QAbstractItemView::SingleSelection);
    m_idTable->setContextMenuPolicy(Qt::CustomContextMenu);
    m_idTable->horizontalHeader()->setSortIndicator(IdModel::Rate, Qt::DescendingOrder);
    m_idTable->setSortingEnabled(true);
    addWidget(m_frames);
    addWidget(m_lower);
    setStretchFactor(0, 3);
    setStretchFactor(1, 2);
    setChildrenCollapsible(true);
}

/// While somebody looks no row moves by itself; who comes finds the busiest first.
void BusTables::showEvent(QShowEvent *event)
{
    QSplitter::showEvent(event);
    const QHeaderView &heads = *m_idTable->horizontalHeader();
    m_ids.sort(heads.sortIndicatorSection(), heads.sortIndicatorOrder());
}

void BusTables::setIdentifiersShown(bool shown)
{
    m_idTable->setVisible(shown);
    m_lower->setVisible(shown || m_lower->count() > 1);
}

void BusTables::toEnd()
{
    m_frames->scrollToBottom();
}

void BusTables::goTo(int frame)
{
    m_frames->setCurrentIndex(m_model.index(frame, 0));
    m_frames->scrollTo(m_model.index(frame, 0));
}

std::optional<int> BusTables::current() const
{
    const QModelIndex current = m_frames->currentIndex();
    return current.isValid() && current.row() < m_model.rowCount() ? std::optional(current.row()) : std::nullopt;
}

std::vector<int> BusTables::selected() const
{
    std::vector<int> rows;
    for (const QModelIndex &index : m_frames->selectionModel()->selectedRows())
        rows.push_back(index.row());
    std::ranges::sort(rows);
    return rows;
}

void BusTables::chooseField(const QPoint &at)
{
    const QModelIndex index = m_idTable->indexAt(at);
    const FrameMeaning *known = index.isValid() ? m_ids.meaning(index.row()) : nullptr;
    if (!known || known->frame.fields.empty())
        return;
    auto *menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    const int shown = m_ids.field(index.row());
    const QPersistentModelIndex row(index);
    for (std::size_t i = 0; i < known->frame.fields.size(); ++i) {
        const QString name = qt(known->frame.fields[i].name);
        QAction *action = menu->addAction(name, this, [this, row, name] {
            if (row.isValid())
                m_ids.chooseField(row.row(), name);
        });
        action->setCheckable(true);
        action->setChecked(static_cast<int>(i) == shown);
    }
    menu->popup(m_idTable->viewport()->mapToGlobal(at));
}

} // namespace mb
