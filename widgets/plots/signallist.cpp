// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/signallist.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/displayunits.h"
#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"

#include <QListWidget>
#include <QMenu>
#include <QMimeData>
#include <QPainter>
#include <QPushButton>
#include <QScrollBar>
#include <QStyledItemDelegate>

#include <algorithm>
#include <optional>

namespace mb {
namespace {

enum SignalRole { DeviceRole = Qt::UserRole, ChannelRole };

constexpr Qt::ItemFlags tickable
    = Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable | Qt::ItemIsDragEnabled;

Signal signalOf(const QListWidgetItem &item)
{
    return {{item.data(DeviceRole).toUInt()}, {static_cast<std::uint16_t>(item.data(ChannelRole).toUInt())}};
}

/// The unit stands dim at the right edge.
class SignalDelegate : public QStyledItemDelegate {
public:
    SignalDelegate(const ThemeSource &theme, QObject *parent)
        : QStyledItemDelegate(parent)
        , m_theme(theme)
    {
    }
    void paint(QPainter *painter, const QStyleOptionViewItem &option, const QModelIndex &index) const override
    {
        QStyledItemDelegate::paint(painter, option, index);
        const Theme &theme = m_theme.theme();
        painter->save();
        painter->setFont(theme.font(TextRole::Caption, option.font));
        painter->setPen(theme.dim);
        painter->drawText(option.rect.adjusted(0, 0, -theme.u(8), 0), Qt::AlignRight | Qt::AlignVCenter,
            index.data(SignalList::UnitRole).toString());
        painter->restore();
    }
    QSize sizeHint(const QStyleOptionViewItem &option, const QModelIndex &index) const override
    {
        const QSize hint = QStyledItemDelegate::sizeHint(option, index);
        return {hint.width(), std::max(hint.height(), m_theme.theme().u(28))};
    }

private:
    const ThemeSource &m_theme;
};

/// Items travel as signals.
class DragList : public QListWidget {
public:
    using QListWidget::QListWidget;

protected:
    QStringList mimeTypes() const override { return {QLatin1String(signalMimeType)}; }
    QMimeData *mimeData(const QList<QListWidgetItem *> items) const override
    {
        return items.isEmpty() ? nullptr : carry({signalOf(*items.first())});
    }
};

} // namespace

SignalList::SignalList(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
{
    auto *column = layoutIn<QVBoxLayout>(this, 0);
    auto *head = new QHBoxLayout;
    head->setContentsMargins(theme.theme().u(12), theme.theme().u(8), theme.theme().u(12), theme.theme().u(4));
    head->addWidget(new SectionLabel(tr("Add a signal"), this));
    auto *hint = textLabel(tr("double click or drag"), TextRole::Caption, Tone::Dim, this);
    hint->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    head->addWidget(hint, 1);
    column->addLayout(head);
    m_list = new DragList(this);
    m_list->setDragEnabled(true);
    m_list->setDragDropMode(QAbstractItemView::DragOnly);
    m_list->setContextMenuPolicy(Qt::CustomContextMenu);
    m_list->setAccessibleName(tr("Signals that can be plotted"));
    m_list->setItemDelegate(new SignalDelegate(theme, m_list));
    m_list->setProperty("surface", QStringLiteral("window"));
    m_list->setProperty("rows", QStringLiteral("plain"));
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->setTextElideMode(Qt::ElideRight);
    m_list->viewport()->installEventFilter(this);
    column->addWidget(m_list, 1);
    auto *derived = linkButton(tr("Derived signal…"), this);
    derived->setToolTip(tr("A formula over signals: derivative, moving average, difference …"));
    column->addWidget(derived, 0, Qt::AlignLeft);
    connect(derived, &QPushButton::clicked, this, &SignalList::newDerivedRequested);
    connect(m_list, &QListWidget::customContextMenuRequested, this, &SignalList::showMenu);
    connect(m_list, &QListWidget::itemChanged, this, &SignalList::itemChanged);
    connect(m_list, &QListWidget::itemActivated, this, [](QListWidgetItem *item) {
        if (item->flags() == tickable)
            item->setCheckState(item->checkState() == Qt::Checked ? Qt::Unchecked : Qt::Checked);
    });
}

void SignalList::setDevices(const std::vector<DeviceView> &devices)
{
    QString shown;
    for (const DeviceView &device : devices)
        shown += QStringLiteral("%1#%2@%3 ")
                     .arg(device.id.value)
                     .arg(device.identity->address)
                     .arg(reinterpret_cast<quintptr>(device.channels().data())); // of other units
    if (shown == m_shown)
        return;
    m_shown = shown;
    m_devices = devices;
    m_isBehind = m_list->viewport()->underMouse();
    m_isBehind ? extend() : fill();
}

bool SignalList::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::Leave && m_isBehind)
        fill();
    return QWidget::eventFilter(watched, event);
}

void SignalList::setDerived(const QStringList &names)
{
    if (names == m_derived)
        return;
    m_derived = names;
    fill();
}

void SignalList::add(const Row &row)
{
    auto *item = new QListWidgetItem(row.name, m_list);
    item->setFlags(tickable);
    item->setData(DeviceRole, row.signal.device.value);
    item->setData(ChannelRole, row.signal.channel.value);
    item->setData(UnitRole, row.unit);
    item->setToolTip(row.hint);
    item->setCheckState(m_chosen.contains(row.signal) ? Qt::Checked : Qt::Unchecked);
}

/// What is the first in sight stays that, and what is current.
void SignalList::fill()
{
    const auto signalAt
        = [](const QListWidgetItem *item) { return item ? std::optional(signalOf(*item)) : std::nullopt; };
    const auto current = signalAt(m_list->currentItem());
    const auto top = signalAt(m_list->verticalScrollBar()->value() > 0 ? m_list->itemAt({}) : nullptr);
    const QSignalBlocker quiet(m_list);
    m_isBehind = false;
    m_list->clear();
    for (const Row &row : rows())
        add(row);
    QListWidgetItem *first = nullptr;
    for (int i = 0; i < m_list->count(); ++i) {
        QListWidgetItem *const item = m_list->item(i);
        if (signalOf(*item) == current)
            m_list->setCurrentItem(item);
        if (signalOf(*item) == top)
            first = item;
    }
    if (first)
        m_list->scrollToItem(first, QAbstractItemView::PositionAtTop);
}

void SignalList::extend()
{
    const QSignalBlocker quiet(m_list);
    const std::vector<Row> wanted = rows();
    std::set<Signal> listed;
    for (int i = 0; i < m_list->count(); ++i) {
        QListWidgetItem *const item = m_list->item(i);
        const Signal signal = signalOf(*item);
        listed.insert(signal);
        item->setFlags(std::ranges::find(wanted, signal, &Row::signal) == wanted.end() ? Qt::NoItemFlags : tickable);
    }
    const auto last = std::find_if(
        wanted.rbegin(), wanted.rend(), [&listed](const Row &row) { return listed.contains(row.signal); });
    std::for_each(last.base(), wanted.end(), [this](const Row &row) { add(row); });
}

std::vector<SignalList::Row> SignalList::rows() const
{
    std::vector<Row> rows;
    for (int i = 0; i < m_derived.size(); ++i) {
        if (!m_derived.at(i).isEmpty())
            rows.push_back({{derivedDevice, {static_cast<std::uint16_t>(i)}}, m_derived.at(i), tr("derived"),
                tr("%1\nright click removes the signal").arg(m_derived.at(i))});
    }
    for (const DeviceView &device : m_devices) {
        if (device.identity->state == DeviceState::Bootloader)
            continue;
        for (std::uint16_t i = 0; i < device.channels().size(); ++i) {
            const Channel &row = device.channels()[i];
            const QString name = signalName(device, {i}, m_devices);
            rows.push_back({{device.id, {i}}, name, shownUnit(row, {}).text,
                tr("%1\ndouble click plots it, drag it to a pane or below them").arg(name)});
        }
    }
    return rows;
}

void SignalList::showMenu(const QPoint &at)
{
    const QListWidgetItem *item = m_list->itemAt(at);
    if (!item || signalOf(*item).device != derivedDevice)
        return;
    const int place = signalOf(*item).channel.value;
    auto *menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addAction(tr("Remove this derived signal"), this, [this, place] { Q_EMIT removeDerivedRequested(place); });
    menu->popup(m_list->viewport()->mapToGlobal(at));
}

void SignalList::setChosen(const std::set<Signal> &chosen)
{
    m_chosen = chosen;
    const QSignalBlocker quiet(m_list);
    for (int i = 0; i < m_list->count(); ++i)
        m_list->item(i)->setCheckState(m_chosen.contains(signalOf(*m_list->item(i))) ? Qt::Checked : Qt::Unchecked);
}

void SignalList::itemChanged(QListWidgetItem *item)
{
    const Signal signal = signalOf(*item);
    const bool on = item->checkState() == Qt::Checked;
    if (on != m_chosen.contains(signal))
        Q_EMIT toggled(signal, on);
}

} // namespace mb
