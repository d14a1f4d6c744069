// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/connection/deviceactions.h"

#include "widgets/common/devicetext.h"

#include <QApplication>
#include <QClipboard>
#include <QCoreApplication>
#include <QFile>
#include <QInputDialog>
#include <QMenu>

#include <algorithm>

namespace mb {
namespace {

struct DeviceActions {
    Q_DECLARE_TR_FUNCTIONS(DeviceActions)
};

Workbench::Finished reportTo(Workbench &workbench, const QString &device, const QString &done)
{
    return [&workbench, device, done](const Result<void> &result) {
        if (result)
            workbench.report(Severity::Good, device, done);
    };
}

/// A dialog that lives until it is closed and does not block.
QInputDialog *ask(QWidget &parent, const QString &title, const QString &question)
{
    auto *dialog = new QInputDialog(&parent);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(title);
    dialog->setLabelText(question);
    return dialog;
}

/// By one of its own family: the others of its link speak past it.
bool isTaken(const Snapshot &shot, const DeviceView &device, int number)
{
    return std::ranges::any_of(shot.devices, [&](const DeviceView &d) {
        return d.link == device.link && d.family == device.family && d.identity->address == number;
    });
}

int firstFree(const Snapshot &shot, const DeviceView &device, int last)
{
    int free = 1;
    while (free < last && isTaken(shot, device, free))
        ++free;
    return free;
}

} // namespace

void addDeviceActions(QMenu &menu, Workbench &workbench, DeviceId id, QWidget &parent)
{
    const DeviceView *device = workbench.snapshot().device(id);
    if (!device)
        return;
    const Capabilities &can = device->family->capabilities;
    const QString label = titleOf(*device);
    const bool running = device->identity->state != DeviceState::Bootloader;
    QAction *identify = menu.addAction(DeviceActions::tr("Identify (blink)"), &parent, [&workbench, id, label] {
        workbench.send(orders::Identify{id}, reportTo(workbench, label, DeviceActions::tr("blinks")));
    });
    identify->setEnabled(can.identify && running);
    QAction *rename = menu.addAction(
        DeviceActions::tr("Rename…"), &parent, [&workbench, id, &parent] { askRename(workbench, id, parent); });
    rename->setEnabled(can.rename);
    QAction *renumber = menu.addAction(DeviceActions::tr("Assign another number…"), &parent,
        [&workbench, id, &parent] { askRenumber(workbench, id, parent); });
    renumber->setEnabled(can.renumber);
    QAction *clear = menu.addAction(DeviceActions::tr("Read and clear faults"), &parent, [&workbench, id, label] {
        workbench.send(
            orders::ClearFaults{id}, reportTo(workbench, label, DeviceActions::tr("faults read and cleared")));
    });
    clear->setEnabled(running);
    if (can.zeroPosition) {
        menu.addAction(DeviceActions::tr("Stop and count from 0"), &parent, [&workbench, id, label] {
            workbench.send(orders::ZeroPosition{id},
                reportTo(workbench, label, DeviceActions::tr("position 0 is here; the motor is off")));
        });
    }
    menu.addSeparator();
    const QString selector = QString::fromStdString(device->selector);
    menu.addAction(DeviceActions::tr("Copy %1").arg(selector), &parent,
        [selector] { QApplication::clipboard()->setText(selector); });
}

void askRename(Workbench &workbench, DeviceId id, QWidget &parent)
{
    const DeviceView *device = workbench.snapshot().device(id);
    if (!device || !device->family->capabilities.rename)
        return;
    const QString label = titleOf(*device);
    QInputDialog *dialog = ask(parent, DeviceActions::tr("Rename %1").arg(label),
        DeviceActions::tr("Name, 1 … 64 characters (some tools show only 28):"));
    dialog->setTextValue(QString::fromStdString(device->identity->name));
    QObject::connect(
        dialog, &QInputDialog::textValueSelected, &workbench, [&workbench, id, label](const QString &text) {
            const QString name = text.left(64);
            if (!name.isEmpty())
                workbench.send(orders::Rename{id, name.toStdString()},
                    reportTo(workbench, label, DeviceActions::tr("renamed to %1").arg(name)));
        });
    dialog->open();
}

void askRenumber(Workbench &workbench, DeviceId id, QWidget &parent)
{
    const DeviceView *device = workbench.snapshot().device(id);
    if (!device)
        return;
    const QString label = titleOf(*device);
    const int last = device->family->capabilities.lastAddress;
    const int free = firstFree(workbench.snapshot(), *device, last);
    QInputDialog *dialog = ask(parent, DeviceActions::tr("Number of %1").arg(label),
        DeviceActions::tr("New number, 1 … %1. %2 is the next free one on this link:").arg(last).arg(free));
    dialog->setInputMode(QInputDialog::IntInput);
    dialog->setIntRange(1, last);
    dialog->setIntValue(free);
    QObject::connect(
        dialog, &QInputDialog::intValueSelected, &workbench, [&workbench, id, label, own = *device](int number) {
            if (isTaken(workbench.snapshot(), own, number))
                workbench.report(Severity::Danger, label,
                    DeviceActions::tr("number %1 is taken on this link; nothing was sent").arg(number));
            else
                workbench.send(orders::Renumber{id, number},
                    reportTo(workbench, label, DeviceActions::tr("answers as number %1 now").arg(number)));
        });
    dialog->open();
}

void openAddress(Workbench &workbench, const QString &text, const std::function<void(const QString &)> &opened)
{
    const auto address = LinkAddress::parse(text.trimmed().toStdString());
    if (!address) {
        workbench.report(Severity::Danger, {}, errorText(address.error()));
        return;
    }
    workbench.send(orders::OpenLink{*address},
        [opened, whole = QString::fromStdString(address->text())](const Result<void> &done) {
            if (done && opened)
                opened(whole);
        });
}

void openRecording(Workbench &workbench, const QString &path, const std::function<void(const QString &)> &opened)
{
    const auto address = LinkAddress::parse("replay:" + QFile::encodeName(path).toStdString());
    if (!address || !address->options.empty()) {
        workbench.report(Severity::Danger, {},
            DeviceActions::tr(
                "%1 cannot be opened: a link address has no place for the question mark in it. Rename it.")
                .arg(path));
        return;
    }
    workbench.send(orders::OpenLink{*address},
        [opened, whole = QString::fromStdString(address->text())](const Result<void> &done) {
            if (done && opened)
                opened(whole);
        });
}

} // namespace mb
