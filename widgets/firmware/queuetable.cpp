// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/firmware/queuetable.h"

#include "widgets/common/layoutin.h"
#include "widgets/common/theme.h"
#include "widgets/firmware/queuemodel.h"

#include <QCheckBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QSignalBlocker>
#include <QStyledItemDelegate>
#include <QTableView>
#include <QVBoxLayout>

#include <algorithm>

namespace mb {
namespace {

constexpr int edges = 22; ///< units around a text
constexpr int boxAndShape = 48;
constexpr int bar = 34;
constexpr int leastStep = 60;
constexpr int leastRows = 26 + 3 * 30; ///< its head and three units

/// Whatever it says, its row stays as high; of a serial number or an address the end tells more than the middle.
class OneLine : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

protected:
    void initStyleOption(QStyleOptionViewItem *option, const QModelIndex &index) const override
    {
        QStyledItemDelegate::initStyleOption(option, index);
        option->features &= ~QStyleOptionViewItem::WrapText;
        if (index.column() == QueueModel::Serial)
            option->textElideMode = Qt::ElideMiddle;
    }
};

} // namespace

QueueTable::QueueTable(const ThemeSource &source, QWidget *parent)
    : QWidget(parent)
    , m_theme(source)
{
    const Theme &theme = source.theme();
    auto *column = layoutIn<QVBoxLayout>(this, 0);
    m_every = new QCheckBox(this);
    m_every->setAccessibleName(tr("Every unit of this family"));
    m_every->setContentsMargins(theme.u(16), 0, 0, 0);
    m_every->hide();
    auto *head = new QHBoxLayout;
    head->setContentsMargins(theme.u(6), theme.u(6), theme.u(16), theme.u(6));
    head->addWidget(m_every);
    head->addStretch(1);
    column->addLayout(head);
    m_model = new QueueModel(source, this);
    m_view = new QTableView(this);
    buildView(source);
    column->addWidget(m_view, 1);
    connect(m_every, &QCheckBox::clicked, this, [this](bool on) { m_model->tickAll(on); });
    connect(m_view->selectionModel(), &QItemSelectionModel::selectionChanged, this, &QueueTable::chosenChanged);
}

void QueueTable::buildView(const ThemeSource &source)
{
    const Theme &theme = source.theme();
    m_view->setAccessibleName(tr("Units of the queue"));
    m_view->setMinimumHeight(theme.u(leastRows));
    m_view->setModel(m_model);
    m_view->setItemDelegate(new OneLine(m_view));
    m_view->setItemDelegateForColumn(QueueModel::Outcome, new QStyledItemDelegate(m_view)); // a cause is read whole
    m_view->setItemDelegateForColumn(QueueModel::Share, new ShareDelegate(source, m_view));
    m_view->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_view->setSelectionMode(QAbstractItemView::SingleSelection);
    m_view->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_view->setShowGrid(false);
    m_view->setWordWrap(true);
    m_view->setFrameShape(QFrame::NoFrame);
    m_view->verticalHeader()->hide();
    m_view->verticalHeader()->setMinimumSectionSize(theme.u(30));
    m_view->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    auto *titles = m_view->horizontalHeader();
    titles->setHighlightSections(false);
    titles->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    titles->setStretchLastSection(true);
    // A cause has as many lines as it needs in the room that there is now.
    connect(titles, &QHeaderView::sectionResized, m_view, &QTableView::resizeRowsToContents);
    connect(m_model, &QAbstractItemModel::dataChanged, this, &QueueTable::fitColumns);
    connect(m_model, &QAbstractItemModel::modelAboutToBeReset, this,
        [this] { m_chosen = chosen() ? std::optional(*chosen()) : std::nullopt; });
    connect(m_model, &QAbstractItemModel::modelReset, this, [this] {
        fitColumns();
        if (m_chosen)
            m_view->selectRow(m_model->placeOf(*m_chosen));
    });
    m_view->viewport()->installEventFilter(this);
    fitColumns();
}

bool QueueTable::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::Resize || event->type() == QEvent::FontChange)
        fitColumns();
    return QWidget::eventFilter(watched, event);
}

/// Every column has what its texts have needed so far; where that is too much, the step gives way to what is to be done.
void QueueTable::fitColumns()
{
    const Theme &theme = m_theme.theme();
    int rest = m_view->viewport()->width();
    for (int column = 0; column < QueueModel::Columns; ++column) {
        int &needed = m_needed.at(static_cast<std::size_t>(column));
        const auto widen = [&](const QString &text, const QFont &font, int around) {
            needed = std::max(needed, QFontMetrics(font).horizontalAdvance(text) + theme.u(around));
        };
        const QHeaderView &titles = *m_view->horizontalHeader();
        widen(m_model->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString(), titles.font(), edges);
        for (int row = 0; row < m_model->rowCount(); ++row) {
            const QModelIndex index = m_model->index(row, column);
            const QVariant own = index.data(Qt::FontRole);
            widen(index.data().toString(), own.isValid() ? own.value<QFont>() : m_view->font(),
                column == QueueModel::Serial      ? edges + boxAndShape
                    : column == QueueModel::Share ? edges + bar
                                                  : edges);
        }
        rest -= column == QueueModel::Outcome || column == QueueModel::StepNow ? 0 : needed;
    }
    const int outcome = m_needed[QueueModel::Outcome];
    for (int column = 0; column < QueueModel::Outcome; ++column) {
        const int needed = m_needed.at(static_cast<std::size_t>(column));
        const int step = std::min(needed, std::max(rest - outcome, rest / 2));
        m_view->setColumnWidth(column, column == QueueModel::StepNow ? std::max(step, theme.u(leastStep)) : needed);
    }
}

const QueueLine *QueueTable::chosen() const
{
    const QModelIndexList selected = m_view->selectionModel()->selectedRows();
    return selected.isEmpty() ? nullptr : &m_model->lines().at(static_cast<std::size_t>(selected.front().row()));
}

void QueueTable::setKind(const QString &title)
{
    m_every->setText(tr("Every %1").arg(title));
    m_every->setVisible(!title.isEmpty());
}

void QueueTable::followTicks(bool running)
{
    const QSignalBlocker quiet(m_every);
    const auto count = static_cast<int>(m_model->ticked().size());
    m_every->setEnabled(!running && m_model->rowCount() > 0);
    m_every->setTristate(false);
    m_every->setChecked(count > 0 && count == m_model->rowCount());
}

} // namespace mb
