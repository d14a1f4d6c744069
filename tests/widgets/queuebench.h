// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/registry.h"
#include "parameterbench.h"
#include "widgets/firmware/firmwarepage.h"
#include "widgets/firmware/queueboard.h"
#include "widgets/firmware/queuemodel.h"
#include "widgets/service/recipeeditor.h"

#include <QFile>
#include <QLabel>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

namespace mb::test {

using service::QueueRow;
using service::RowState;

inline const QString demoImage = QStringLiteral(":/firmware/dmc60c-demo.hex");

/// The queue of the page Firmware over three units that are only told of, on a workbench that only notes what is ordered.
struct QueueBench {
    FakeWorkbench workbench;
    Selection selection;
    ThemeSource theme{darkTheme()};
    QTemporaryDir folder;
    std::unique_ptr<FirmwarePage> page;

    QueueBench()
    {
        addLink("sim:can", LinkKind::Can);
        addLink("socketcan:can1", LinkKind::Can);
        addLink("sim:serial", LinkKind::Serial);
        add(1, 5, "sim:can", "2103343A79F2");
        add(2, 7, "sim:can", "2103343A7A44");
        add(3, 9, "socketcan:can1", "2103343A79E0");
        page = std::make_unique<FirmwarePage>(workbench, selection, families(), theme);
        page->showQueue(true);
        page->resize(1072, 640);
        page->show();
        QApplication::setActiveWindow(page.get());
    }
    [[nodiscard]] QueueBoard &board() const { return page->queue(); }
    [[nodiscard]] QueueModel &model() const { return board().model(); }
    void addLink(const std::string &address, LinkKind kind)
    {
        LinkView link;
        link.address = address;
        link.kind = kind;
        link.state = LinkState::Open;
        workbench.shot.links.push_back(link);
    }
    void add(std::uint32_t id, int address, const std::string &link, const std::string &serial)
    {
        DeviceView device = readDrive(id, address);
        device.link = link;
        device.identity.edit().serial = serial;
        device.telemetry = std::make_shared<Telemetry>(dmc60c().channels);
        workbench.shot.devices.push_back(device);
    }
    [[nodiscard]] QueueRow row(std::uint32_t id, std::uint32_t device, RowState state) const
    {
        QueueRow row;
        row.id = id;
        row.device = {device};
        row.state = state;
        row.link = "sim:can";
        row.visit.id = "visit " + std::to_string(id);
        row.visit.serial = "SERIAL" + std::to_string(id);
        row.visit.from = "1.23";
        row.startedAt = workbench.time;
        return row;
    }
    [[nodiscard]] QString cell(int row, QueueModel::Column column) const
    {
        return model().index(row, column).data().toString();
    }
    [[nodiscard]] QString write(const QByteArray &recipe) const
    {
        QFile file(folder.filePath(QStringLiteral("recipe.json")));
        return file.open(QIODevice::WriteOnly) && file.write(recipe) > 0 ? file.fileName() : QString();
    }
    /// By the pencil beside the recipe.
    [[nodiscard]] RecipeEditor *openEditor() const
    {
        for (auto *button : board().findChildren<QToolButton *>()) {
            if (button->isVisible() && button->accessibleName() == QLatin1String("Write a recipe"))
                QTest::mouseClick(button, Qt::LeftButton);
        }
        const auto editors = board().findChildren<RecipeEditor *>();
        return editors.size() == 1 && editors.front()->isVisible() ? editors.front() : nullptr;
    }
    [[nodiscard]] bool says(const QString &part) const
    {
        const auto labels = page->findChildren<QLabel *>();
        return std::any_of(labels.begin(), labels.end(),
            [&](const QLabel *label) { return label->isVisible() && label->text().contains(part); });
    }
};

} // namespace mb::test
