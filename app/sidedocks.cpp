// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sidedocks.h"

#include "transport/linkaddress.h"
#include "widgets/common/guarded.h"
#include "widgets/common/pagekeys.h"
#include "widgets/connection/devicetree.h"
#include "widgets/connection/inspector.h"

#include <QDockWidget>
#include <QMainWindow>
#include <QScrollArea>
#include <QScrollBar>

#include <algorithm>
#include <utility>

namespace mb {
namespace {

constexpr int widestInspector = 248; ///< at first
constexpr int roomyWidth = 1024;     ///< for devices, a page and the inspector beside each other

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
}

QDockWidget *SideDocks::addDock(const QString &name, const QString &title, QWidget *content, Qt::DockWidgetArea area)
{
    auto *dock = new QDockWidget(title, &m_window);
    dock->setObjectName(name);
    dock->setTitleBarWidget(new QWidget(dock)); // the content has its own head
    dock->setWidget(content);
    content->setMinimumSize(1, 1); // on a small screen it is cut before the Arm button and STOP are
    dock->setFeatures(QDockWidget::DockWidgetClosable);
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
    const auto flip
        = [this](QDockWidget *dock) { return [this, dock] { dock->setVisible(!dock->isVisible() && !m_away); }; };
    keys.add({Qt::Key_F9}, tr("shows or hides the devices"), flip(m_devices));
    keys.add({Qt::Key_F10}, tr("shows or hides the inspector"), flip(m_inspector));
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
