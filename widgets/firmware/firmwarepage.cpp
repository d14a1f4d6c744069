// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/firmware/firmwarepage.h"

#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/pagekeys.h"
#include "widgets/common/segmented.h"
#include "widgets/firmware/queueboard.h"
#include "widgets/firmware/unitupdate.h"

#include <QDragEnterEvent>
#include <QMimeData>
#include <QStackedWidget>
#include <QUrl>

namespace mb {

FirmwarePage::FirmwarePage(Workbench &workbench, Selection &selection, const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_workbench(workbench)
    , m_selection(selection)
    , m_theme(theme)
{
    setObjectName(QStringLiteral("firmwarePage"));
    setAccessibleName(tr("Firmware"));
    setAcceptDrops(true);
    auto *column = layoutIn<QVBoxLayout>(this, 0);
    m_faces = new QStackedWidget(this);
    m_unit = new UnitUpdate(workbench, selection, theme, m_faces);
    m_faces->addWidget(m_unit);
    column->addWidget(m_faces, 1);
    auto *keys = new PageKeys(*this);
    keys->add({Qt::Key_F5}, tr("starts the update"), [this] { startUpdate(); });
}

void FirmwarePage::setService(ServiceDesk &desk, std::span<const Family *const> families)
{
    const Theme &theme = m_theme.theme();
    auto *head = new QWidget(this);
    auto *row = layoutIn<QHBoxLayout>(head, -1, {theme.u(16), theme.u(8), theme.u(16), 0});
    m_which = new Segmented(tr("What is updated"), {tr("Selected unit"), tr("Queue of units")}, head);
    row->addWidget(m_which);
    row->addStretch(1);
    static_cast<QVBoxLayout *>(layout())->insertWidget(0, head);
    m_queue = new QueueBoard(desk, m_workbench, m_selection, families, m_theme, m_faces);
    m_faces->addWidget(m_queue);
    connect(m_which, &Segmented::currentChanged, m_faces, &QStackedWidget::setCurrentIndex);
}

void FirmwarePage::showQueue(bool on)
{
    if (m_which)
        m_which->setCurrent(on ? 1 : 0);
}

bool FirmwarePage::isQueueShown() const
{
    return m_queue && m_faces->currentWidget() == m_queue;
}

void FirmwarePage::loadImage(const QString &path)
{
    if (isQueueShown())
        (void)m_queue->openImage(path);
    else
        m_unit->loadImage(path);
}

void FirmwarePage::startUpdate()
{
    isQueueShown() ? m_queue->start() : m_unit->start();
}

bool FirmwarePage::canStart() const
{
    return isQueueShown() ? m_queue->canStart() : m_unit->canStart();
}

void FirmwarePage::dragEnterEvent(QDragEnterEvent *event)
{
    if (event->mimeData()->hasUrls())
        event->acceptProposedAction();
}

void FirmwarePage::dropEvent(QDropEvent *event)
{
    const QList<QUrl> urls = event->mimeData()->urls();
    if (!urls.isEmpty() && urls.constFirst().isLocalFile())
        loadImage(urls.constFirst().toLocalFile());
}

} // namespace mb
