// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/firmware/muteunits.h"

#include "files/qttext.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/guarded.h"

#include <QCoreApplication>
#include <QInputDialog>
#include <QMenu>

#include <algorithm>

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

} // namespace

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

} // namespace mb
