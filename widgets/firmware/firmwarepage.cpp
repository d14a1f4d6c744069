// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/firmware/firmwarepage.h"

#include "files/qttext.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/guarded.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/pagekeys.h"
#include "widgets/common/segmented.h"
#include "widgets/common/wraplayout.h"
#include "widgets/firmware/queueboard.h"
#include "widgets/firmware/unitupdate.h"

#include <QCoreApplication>
#include <QDragEnterEvent>
#include <QInputDialog>
#include <QMenu>
#include <QMimeData>
#include <QStackedWidget>
#include <QUrl>

#include <algorithm>
#include <functional>

namespace mb {
namespace {

struct MuteUnits {
    Q_DECLARE_TR_FUNCTIONS(MuteUnits)
};

/// One that alone is on its link is found without its number (Scans).
bool mayHaveMute(const Family &family, const LinkView &link)
{
    return link.state == LinkState::Open && !link.replay && family.update && !family.routes.empty()
        && family.capabilities.firstAddress < family.capabilities.lastAddress
        && std::ranges::find(family.links, link.kind) != family.links.end();
}

/// A line for each open link and family on it whose firmware takes another way in (Family::routes). It asks for the number of a unit
/// that does not answer there, above `parent`; `found` gets that one once it is in the list, where it can be updated. Why it cannot is
/// reported.
void addMuteUnits(QMenu &menu, Workbench &workbench, std::span<const Family *const> families, QWidget &parent,
    const std::function<void(DeviceId)> &found)
{
    const auto ask = [&workbench, &parent, found](const Family &family, const std::string &link, const QString &where) {
        const Capabilities &can = family.capabilities;
        auto *dialog = new QInputDialog(&parent);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
        dialog->setWindowTitle(where);
        dialog->setLabelText(
            MuteUnits::tr("Number of the unit that does not answer, %1 … %2. No other one of its family "
                          "may answer there: a programmer would not tell them apart.")
                .arg(can.firstAddress)
                .arg(can.lastAddress));
        dialog->setInputMode(QInputDialog::IntInput);
        dialog->setIntRange(can.firstAddress, can.lastAddress);
        const auto named = guarded(&parent, [&workbench, where, found](const Result<DeviceId> &unit) {
            if (unit)
                found(*unit);
            else if (unit.error().fault != Fault::Cancelled) // whoever ended the search knows
                workbench.report(Severity::Danger, where, errorText(unit.error()));
        });
        QObject::connect(
            dialog, &QInputDialog::intValueSelected, &workbench, [&workbench, &family, link, named](int number) {
                workbench.send(orders::FindMute{link, std::string(family.key), number}, named);
            });
        dialog->open();
    };
    for (const LinkView &link : workbench.snapshot().links) {
        for (const Family *family : families) {
            const QString where = MuteUnits::tr("%1 on %2").arg(qt(family->title), qt(link.name));
            if (mayHaveMute(*family, link))
                menu.addAction(where + QStringLiteral("…"), &parent,
                    [ask, family, address = link.address, where] { ask(*family, address, where); });
        }
    }
    if (menu.isEmpty())
        menu.addAction(MuteUnits::tr("No link is open whose units a programmer writes"))->setEnabled(false);
}

} // namespace

FirmwarePage::FirmwarePage(Workbench &workbench, Selection &selection, std::span<const Family *const> families,
    const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
{
    setObjectName(QStringLiteral("firmwarePage"));
    setAccessibleName(tr("Firmware"));
    setAcceptDrops(true);
    auto *column = layoutIn<QVBoxLayout>(this, 0);
    column->addWidget(buildHead(workbench, selection, families, theme));
    m_faces = new QStackedWidget(this);
    m_faces->addWidget(m_unit = new UnitUpdate(workbench, selection, theme, m_faces));
    m_faces->addWidget(m_queue = new QueueBoard(workbench, selection, families, theme, m_faces));
    column->addWidget(m_faces, 1);
    connect(m_which, &Segmented::currentChanged, m_faces, &QStackedWidget::setCurrentIndex);
    auto *keys = new PageKeys(*this);
    keys->add({Qt::Key_F5}, tr("starts the update"), [this] { startUpdate(); });
}

QWidget *FirmwarePage::buildHead(
    Workbench &workbench, Selection &selection, std::span<const Family *const> families, const ThemeSource &theme)
{
    auto *head = new QWidget(this);
    const Theme &now = theme.theme();
    auto *row = new WrapLayout(head);
    row->setContentsMargins(now.u(16), now.u(8), now.u(16), 0);
    row->addWidget(m_which = new Segmented(tr("What is updated"), {tr("Selected unit"), tr("Queue of units")}, head));
    row->addSpring();
    auto *mute = new CommandButton(theme, Symbol::Plug, tr("Unit that does not answer"), head);
    mute->setToolTip(tr("A unit whose update was cut may be mute: say where it is, and it can be written again"));
    auto *menu = new QMenu(mute);
    mute->setMenu(menu);
    row->addWidget(mute);
    connect(menu, &QMenu::aboutToShow, this, [this, menu, &workbench, &selection, families] {
        menu->clear();
        addMuteUnits(*menu, workbench, families, *this, [this, &selection](DeviceId unit) {
            showQueue(false);
            selection.select(unit);
        });
    });
    return head;
}

void FirmwarePage::showQueue(bool on)
{
    m_which->setCurrent(on ? 1 : 0);
}

bool FirmwarePage::isQueueShown() const
{
    return m_faces->currentWidget() == m_queue;
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
