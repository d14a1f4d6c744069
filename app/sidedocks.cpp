// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sidedocks.h"

#include "transport/linkaddress.h"
#include "widgets/common/guarded.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/labels.h"
#include "widgets/common/pagekeys.h"
#include "widgets/connection/devicetree.h"
#include "widgets/connection/inspector.h"

#include <QApplication>
#include <QDockWidget>
#include <QEvent>
#include <QMainWindow>
#include <QScrollArea>
#include <QScrollBar>

#include <algorithm>
#include <utility>

namespace mb {
namespace {

constexpr int widestInspector = 248; ///< at first
constexpr int roomyWidth = 1024;     ///< for devices, a page and the inspector beside each other
constexpr int dockedFrom = 760;      ///< for devices and a page

} // namespace

SideDocks::SideDocks(
    Workbench &workbench, Selection &selection, const ThemeSource &theme, Settings &settings, QMainWindow &window)
    : QObject(&window)
    , m_workbench(workbench)
    , m_theme(theme)
    , m_settings(settings)
    , m_window(window)
    , m_tree(new DeviceTree(workbench, selection, theme, &window))
{
    buildDevices();
    buildInspector(selection, theme);
    qApp->installEventFilter(this);
}

QWidget *SideDocks::makeButton(QWidget *parent)
{
    auto *button = new IconButton(m_theme, Symbol::ChevronRight, tr("Show devices"), parent);
    button->setObjectName(QStringLiteral("showDevices"));
    button->setKeyHint(QStringLiteral("F9"));
    connect(button, &QToolButton::clicked, this, [this] { flip(*m_devices); });
    const auto follow = [this, button] { button->setVisible(m_overlaid || m_devices->isHidden()); };
    connect(m_devices, &QDockWidget::visibilityChanged, button, follow);
    connect(this, &SideDocks::overlaidChanged, button, follow);
    follow();
    return button;
}

QDockWidget *SideDocks::addDock(const QString &name, const QString &title, QWidget *content, Qt::DockWidgetArea area)
{
    auto *dock = new QDockWidget(title, &m_window);
    dock->setObjectName(name);
    dock->setTitleBarWidget(new QWidget(dock)); // the content has its own head
    dock->setWidget(content);
    content->setMinimumSize(1, 1); // on a small screen it is cut before the Arm button and STOP are
    dock->setFeatures(QDockWidget::DockWidgetClosable);
    QWidget *edge = separatorLine(Qt::Vertical, dock);
    edge->setObjectName(QStringLiteral("dockEdge"));
    edge->hide();
    m_window.addDockWidget(area, dock);
    return dock;
}

void SideDocks::buildDevices()
{
    m_devices = addDock(QStringLiteral("devicesDock"), tr("Devices"), m_tree, Qt::LeftDockWidgetArea);
    connect(m_tree, &DeviceTree::collapseRequested, m_devices, &QWidget::hide);
    m_tree->setKept([this](const QString &address) { return m_settings.links().contains(address); });
    connect(m_tree, &DeviceTree::keepLinkRequested, this, [this](const QString &address, bool keep) {
        keep ? m_settings.addLink(address) : m_settings.removeLink(address);
    });
    connect(m_tree, &DeviceTree::closeLinkRequested, this, [this](const QString &address) {
        m_workbench.send(
            orders::CloseLink{address.toStdString()}, guarded(this, [this, address](const Result<void> &closed) {
                if (closed)
                    forgetLink(address);
            }));
    });
}

void SideDocks::forgetLink(const QString &address)
{
    m_settings.removeLink(address);
    if (isSimulatedLink(address.toStdString()))
        m_settings.removeLink(QStringLiteral("sim:")); // which stood for this one too
}

void SideDocks::buildInspector(Selection &selection, const ThemeSource &theme)
{
    auto *scroll = new QScrollArea(&m_window); // what only the user knows of a device may be long
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setSizeAdjustPolicy(QAbstractScrollArea::AdjustToContents);
    auto *inspector = new Inspector(m_workbench, selection, theme, scroll);
    scroll->setWidget(inspector);
    m_inspector = addDock(QStringLiteral("inspectorDock"), tr("Inspector"), scroll, Qt::RightDockWidgetArea);
    m_inspector->hide();
    m_window.resizeDocks(
        {m_devices}, {m_devices->widget()->sizeHint().width()}, Qt::Horizontal); // whatever is in the list
    for (QWidget *part : inspector->findChildren<QWidget *>())
        part->ensurePolished();    // what a button needs depends on the style sheet
    inspector->setMinimumWidth(1); // long words of one device are elided, and hold nothing wide
    scroll->setMinimumWidth(std::min(inspector->sizeHint().width(), theme.theme().u(widestInspector))
        + scroll->verticalScrollBar()->sizeHint().width());
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
}

void SideDocks::addTo(PageKeys &keys)
{
    keys.add({Qt::Key_F9}, tr("shows or hides the devices"), [this] { flip(*m_devices); });
    keys.add({Qt::Key_F10}, tr("shows or hides the inspector"), [this] { flip(*m_inspector); });
}

void SideDocks::flip(QDockWidget &dock)
{
    dock.setVisible(!dock.isVisible() && !m_away);
    if (!m_overlaid || !dock.isVisible())
        return;
    layOver();
    dock.raise();
    dock.widget()->setFocus(Qt::ShortcutFocusReason);
}

/// Over the page at its side, which keeps its width.
void SideDocks::layOver()
{
    const QRect page = m_window.centralWidget()->geometry();
    for (QDockWidget *dock : {m_devices, m_inspector}) {
        const int width
            = std::min(std::max(dock->widget()->sizeHint().width(), dock->minimumSizeHint().width()), page.width());
        const int left = dock == m_devices ? page.left() : page.right() + 1 - width;
        dock->setGeometry(left, page.top(), width, page.height());
        auto *edge = dock->findChild<QWidget *>(QStringLiteral("dockEdge"), Qt::FindDirectChildrenOnly);
        edge->setGeometry(dock == m_devices ? width - 1 : 0, 0, 1, page.height());
        edge->raise();
    }
}

void SideDocks::setOverlaid(bool overlaid)
{
    if (overlaid)
        m_hadDevices = m_devices->isVisibleTo(&m_window);
    m_overlaid = overlaid;
    for (QDockWidget *dock : {m_devices, m_inspector}) {
        dock->setAutoFillBackground(overlaid);
        dock->findChild<QWidget *>(QStringLiteral("dockEdge"), Qt::FindDirectChildrenOnly)->setVisible(overlaid);
        dock->hide();
        if (overlaid)
            m_window.removeDockWidget(dock);
        else
            m_window.addDockWidget(dock == m_devices ? Qt::LeftDockWidgetArea : Qt::RightDockWidgetArea, dock);
    }
    m_devices->setVisible(!overlaid && m_hadDevices);
    Q_EMIT overlaidChanged();
}

/// Whoever works in the page has found what was looked for beside it.
bool SideDocks::eventFilter(QObject *watched, QEvent *event)
{
    if (m_overlaid && event->type() == QEvent::MouseButtonPress && watched->isWidgetType()
        && m_window.centralWidget()->isAncestorOf(static_cast<QWidget *>(watched))) {
        m_devices->hide();
        m_inspector->hide();
    }
    return false;
}

void SideDocks::putAway(bool away)
{
    m_away = away;
    if (!away) {
        for (QDockWidget *dock : std::exchange(m_before, {}))
            dock->show();
        return;
    }
    for (QDockWidget *dock : {m_devices, m_inspector}) {
        if (dock->isVisibleTo(&m_window))
            m_before.push_back(dock);
        dock->hide();
    }
}

void SideDocks::follow(bool overview)
{
    if (m_away)
        return;
    if (const bool overlaid = m_window.width() < m_theme.theme().u(dockedFrom); overlaid != m_overlaid)
        setOverlaid(overlaid);
    if (m_overlaid)
        layOver();
    const bool room = m_window.width() >= m_theme.theme().u(roomyWidth);
    if (room && m_room)
        m_width = m_devices->width();
    else if (room && m_width > 0) // they were squeezed meanwhile
        m_window.resizeDocks({m_devices}, {m_width}, Qt::Horizontal);
    m_room = room;
    const bool useful = overview && room && !m_workbench.snapshot().devices.empty();
    if (std::exchange(m_useful, useful) != useful)
        m_inspector->setVisible(useful);
}

} // namespace mb
