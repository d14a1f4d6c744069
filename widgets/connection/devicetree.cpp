// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/connection/devicetree.h"

#include "widgets/common/layoutin.h"
#include "widgets/common/wraplayout.h"

#include "widgets/common/emptystate.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/labels.h"
#include "widgets/common/searchfield.h"
#include "widgets/common/spoken.h"
#include "widgets/common/updates.h"
#include "widgets/connection/deviceactions.h"
#include "widgets/connection/devicedelegate.h"
#include "widgets/connection/scanstrip.h"

#include <QEvent>
#include <QMenu>
#include <QPainter>
#include <QTreeView>

namespace mb {
namespace {

/// What is selected is one band from edge to edge, with the branches on it.
class LinkTreeView : public QTreeView {
public:
    LinkTreeView(const ThemeSource &theme, QWidget *parent)
        : QTreeView(parent)
        , m_theme(theme)
    {
    }

protected:
    void drawRow(QPainter *painter, const QStyleOptionViewItem &option, const QModelIndex &index) const override
    {
        const bool selected = selectionModel()->isSelected(index) && index.parent().isValid();
        const Theme &theme = m_theme.theme();
        if (selected)
            painter->fillRect(option.rect, theme.sel);
        QTreeView::drawRow(painter, option, index);
        if (selected)
            painter->fillRect(QRect(0, option.rect.top(), theme.u(3), option.rect.height()), theme.accent);
    }

private:
    const ThemeSource &m_theme;
};

} // namespace

DeviceTree::DeviceTree(Workbench &workbench, Selection &selection, const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_workbench(workbench)
    , m_selection(selection)
    , m_theme(theme)
    , m_model(new DeviceModel(workbench, this))
    , m_first(selection)
{
    setObjectName(QStringLiteral("devices"));
    setAccessibleName(tr("Devices"));
    auto *column = layoutIn<QVBoxLayout>(this, 0);
    buildHead(*column);
    buildTree(*column);
    buildFoot(*column);
    connect(&workbench, &Workbench::changed, this, &DeviceTree::follow);
    connect(&selection, &Selection::changed, this, &DeviceTree::showSelection);
    follow();
}

QSize DeviceTree::sizeHint() const
{
    return {m_theme.theme().u(232), m_theme.theme().u(600)};
}

void DeviceTree::buildHead(QVBoxLayout &column)
{
    const Theme &theme = m_theme.theme();
    auto *head = new QWidget(this);
    head->setFixedHeight(theme.u(36));
    auto *row = layoutIn<QHBoxLayout>(head, 0, {theme.u(12), 0, theme.u(4), 0});
    row->addWidget(new SectionLabel(tr("Devices"), head));
    row->addStretch();
    m_rescan = new IconButton(m_theme, Symbol::Refresh, tr("Scan again"), head);
    auto *filter = new IconButton(m_theme, Symbol::Filter, tr("Filter devices"), head);
    filter->setCheckable(true);
    auto *fold = new IconButton(m_theme, Symbol::ChevronLeft, tr("Hide devices"), head);
    fold->setKeyHint(QStringLiteral("F9"));
    row->addWidget(m_rescan);
    row->addWidget(filter);
    row->addWidget(fold);
    column.addWidget(head);
    m_filter = new SearchField(m_theme, tr("Filter by name, number, serial"), this);
    m_filter->hide();
    column.addWidget(m_filter);
    connect(m_rescan, &QToolButton::clicked, this, [this] { m_workbench.send(orders::ScanLinks{}); });
    connect(fold, &QToolButton::clicked, this, &DeviceTree::collapseRequested);
    connect(filter, &QToolButton::toggled, this, [this](bool on) {
        m_filter->setVisible(on);
        if (on)
            m_filter->setFocus();
        else
            m_filter->clear();
    });
    connect(m_filter, &QLineEdit::textChanged, this, [this](const QString &text) {
        m_model->setFilter(text);
        follow();
    });
}

void DeviceTree::buildTree(QVBoxLayout &column)
{
    m_empty = new EmptyState(m_theme, Symbol::Plug, tr("No device yet"),
        tr("Devices appear here by themselves as soon as a link answers."), this);
    column.addWidget(m_empty);
    m_view = new LinkTreeView(m_theme, this);
    setFocusProxy(m_view);
    m_view->setObjectName(QStringLiteral("deviceTree"));
    m_view->setAccessibleName(tr("Links and devices"));
    m_view->setModel(m_model);
    m_view->setItemDelegate(new DeviceDelegate(m_theme, m_view));
    m_view->setHeaderHidden(true);
    m_view->setFrameShape(QFrame::NoFrame);
    m_view->setIndentation(m_theme.theme().u(14));
    m_view->setUniformRowHeights(false);
    m_view->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_view->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_view->setContextMenuPolicy(Qt::CustomContextMenu);
    m_view->setDragEnabled(true);
    m_view->setDragDropMode(QAbstractItemView::DragOnly);
    m_view->viewport()->installEventFilter(this);
    column.addWidget(m_view, 1);
    connect(m_view->selectionModel(), &QItemSelectionModel::currentChanged, this, &DeviceTree::choose);
    connect(m_view, &QAbstractItemView::activated, this, [this](const QModelIndex &index) {
        if (DeviceModel::kindOf(index) == DeviceModel::Kind::Channel)
            Q_EMIT plotRequested(m_model->signalsAt(index));
    });
    connect(m_model, &QAbstractItemModel::rowsInserted, this, &DeviceTree::expandInserted);
    connect(m_view, &QWidget::customContextMenuRequested, this, &DeviceTree::showMenu);
}

void DeviceTree::buildFoot(QVBoxLayout &column)
{
    const Theme &theme = m_theme.theme();
    m_waiting = linkButton({}, this);
    m_waiting->hide();
    column.addWidget(m_waiting);
    connect(m_waiting, &QPushButton::clicked, this, [this] {
        m_model->setHeld(false);
        follow();
    });
    column.addWidget(separatorLine(Qt::Horizontal, this));
    column.addWidget(new ScanStrip(m_workbench, m_theme, this));
    auto *foot = new QWidget(this);
    auto *row = new WrapLayout(foot);
    row->setContentsMargins(
        theme.u(6), theme.u(8), theme.u(6), theme.u(8)); // both beside each other in the usual width
    row->setSpacing(theme.u(4));
    auto *add = new CommandButton(m_theme, Symbol::Add, tr("Add link"), foot);
    auto *simulate = new CommandButton(m_theme, Symbol::Chip, tr("Simulate"), foot);
    add->setToolTip(tr("Open a CAN interface, a serial port or another link"));
    simulate->setToolTip(tr("Open the simulated bench; no real motor is connected to it"));
    row->addWidget(add);
    row->addWidget(simulate);
    column.addWidget(foot);
    connect(add, &QPushButton::clicked, this, &DeviceTree::addLinkRequested);
    connect(simulate, &QPushButton::clicked, this, &DeviceTree::simulateRequested);
}

/// A row that comes in above must not put another one under a finger that is about to press.
bool DeviceTree::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::Enter || event->type() == QEvent::Leave) {
        m_model->setHeld(event->type() == QEvent::Enter);
        follow();
    }
    return QWidget::eventFilter(watched, event);
}

/// Where the current row goes Qt makes its neighbour the current one. That chooses nothing: somebody works with what is selected.
/// Neither does the tree when it shows what is.
void DeviceTree::choose(const QModelIndex &current)
{
    m_moved = m_moved || m_model->isChanging();
    const DeviceId id = m_model->deviceAt(current);
    if (id.value != 0 && !m_model->isChanging() && !isSelected(current))
        m_selection.select(id, m_model->axisAt(current));
}

/// Or belongs to that, as a channel does.
bool DeviceTree::isSelected(const QModelIndex &row) const
{
    return m_model->deviceAt(row) == m_selection.device() && m_model->axisAt(row) == m_selection.axis();
}

void DeviceTree::follow()
{
    const int waiting = m_model->waiting();
    m_waiting->setVisible(waiting > 0);
    m_waiting->setText(waiting == 1 ? tr("Show 1 new device") : tr("Show %1 new devices").arg(waiting));
    setSpoken(*m_waiting, m_waiting->text(), {});
    const bool none = m_model->rowCount() == 0;
    m_empty->setVisible(none);
    m_view->setVisible(!none);
    m_first.follow(m_workbench.snapshot());
    if (std::exchange(m_moved, false) || !m_view->selectionModel()->hasSelection())
        showSelection();
}

/// Links and axes are open to begin with, channels are not.
void DeviceTree::expandInserted(const QModelIndex &parent, int first, int last)
{
    if (!parent.isValid())
        return;
    m_view->expand(parent);
    for (int row = first; row <= last; ++row) {
        const QModelIndex inserted = m_model->index(row, 0, parent);
        if (DeviceModel::kindOf(m_model->index(0, 0, inserted)) == DeviceModel::Kind::Axis)
            m_view->expand(inserted);
    }
}

void DeviceTree::showSelection()
{
    if (isSelected(m_view->currentIndex()))
        return;
    m_view->setCurrentIndex(m_model->indexOf(m_selection.device(), m_selection.axis())); // none, where it has no row
}

/// On a serial line a usual scan leaves out what would take long.
void DeviceTree::addSearch(QMenu &menu, const LinkView &link)
{
    const std::string address = link.address;
    QAction *search = menu.addAction(tr("Search every rate and address (takes minutes)"), this,
        [this, address] { m_workbench.send(orders::ScanEverything{address}); });
    search->setObjectName(QStringLiteral("searchEverything"));
    QAction *cancel = menu.addAction(
        tr("Cancel the scan"), this, [this, address] { m_workbench.send(orders::CancelScan{address}); });
    cancel->setEnabled(link.scanning);
}

void DeviceTree::showMenu(const QPoint &position)
{
    const QModelIndex index = m_view->indexAt(position);
    const DeviceId id = m_model->deviceAt(index);
    auto *menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    if (id.value != 0) {
        if (const std::vector<Signal> wanted = m_model->signalsAt(index); !wanted.empty()) {
            const QString what = index.data(Qt::DisplayRole).toString();
            menu->addAction(tr("Plot %1").arg(what), this, [this, wanted] { Q_EMIT plotRequested(wanted); });
            menu->addSeparator();
        }
        addDeviceActions(*menu, m_workbench, id, *this);
    } else {
        menu->addAction(tr("Scan again"), this, [this] { m_workbench.send(orders::ScanLinks{}); });
        if (const LinkView *link = m_model->linkAt(index)) {
            const QString address = QString::fromStdString(link->address);
            if (link->kind == LinkKind::Serial)
                addSearch(*menu, *link);
            if (m_isKept && !link->replay) {
                QAction *keep = menu->addAction(tr("Open it at every start"), this,
                    [this, address](bool on) { Q_EMIT keepLinkRequested(address, on); });
                keep->setObjectName(QStringLiteral("keepLink"));
                keep->setCheckable(true);
                keep->setChecked(m_isKept(address));
            }
            QAction *close
                = menu->addAction(tr("Close this link"), this, [this, address] { Q_EMIT closeLinkRequested(address); });
            close->setEnabled(!updateOn(m_workbench, link->address) // a unit may lose its firmware
                && !isServed(m_workbench, link->address));
        }
    }
    menu->popup(m_view->viewport()->mapToGlobal(position));
}

} // namespace mb
