// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/registry.h"
#include "support/fakeworkbench.h"
#include "widgets/common/banner.h"
#include "widgets/common/selection.h"
#include "widgets/common/theme.h"
#include "widgets/parameters/parameterspage.h"

#include <QAbstractButton>
#include <QApplication>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QTemporaryDir>
#include <QTest>

namespace mb::test {

inline const Family &dmc60c()
{
    return *findFamily(families(), "dmc60c");
}

inline ParameterIndex named(const char *key)
{
    return findParameter(dmc60c().parameters, key).value();
}

inline std::int64_t rawOf(const char *key, double value)
{
    return toRaw(dmc60c().parameters[named(key).value], value).value();
}

/// One drive as it is after a complete read: everything at its default.
inline DeviceView readDrive(std::uint32_t id = 1, int address = 5)
{
    DeviceView device;
    device.id = {id};
    device.family = &dmc60c();
    device.identity.edit().family = "dmc60c";
    device.identity.edit().address = address;
    device.identity.edit().serial = "2103343A79F2";
    device.identity.edit().firmware = "1.23";
    device.selector = "can:can0/dmc60c:" + std::to_string(address);
    device.liveness.heard = true;
    for (const Parameter &p : dmc60c().parameters)
        device.parameters.edit().push_back(
            {toRaw(p, p.fallback).value_or(0), p.persistent ? ParameterState::Stored : ParameterState::Volatile});
    device.parameterRevision = 1;
    return device;
}

/// The same on a link, with telemetry of its own.
inline DeviceView driveAt(std::uint32_t id, int address, const char *link)
{
    DeviceView device = readDrive(id, address);
    device.link = link;
    device.telemetry = std::make_shared<Telemetry>(dmc60c().channels);
    return device;
}

inline void addLink(Snapshot &shot, const char *address)
{
    LinkView link;
    link.address = address;
    link.name = address;
    shot.links.push_back(link);
}

/// A page over a workbench with one drive that was read, shown.
struct ParameterBench {
    FakeWorkbench workbench;
    Selection selection;
    ThemeSource theme{lightTheme()};
    BannerStack banners{theme};
    std::unique_ptr<ParametersPage> page;

    explicit ParameterBench(const DeviceView &device = readDrive(), QSize size = {1208, 760})
    {
        workbench.shot.devices.push_back(device);
        selection.select(device.id);
        page = std::make_unique<ParametersPage>(workbench, selection, theme, banners, nullptr);
        page->resize(size);
        page->show();
        banners.show();
        QApplication::setActiveWindow(page.get());
    }
    [[nodiscard]] ParameterModel &model() { return page->model(); }
    [[nodiscard]] ParameterView &view() { return page->view(); }
    [[nodiscard]] StagedEdits &edits() { return *page->model().edits(); }
    [[nodiscard]] QString shown(const char *key, int column)
    {
        return model().indexOf(named(key), column).data().toString();
    }

    void stage(const char *key, const char *text) { edits().stage(named(key), QString::fromUtf8(text)); }
    /// The device says so now.
    void set(const char *key, double value, ParameterState state)
    {
        DeviceView &device = workbench.device(0);
        ParameterStore::Entry &entry = device.parameters.edit()[named(key).value];
        entry = entry.with(rawOf(key, value), state);
        ++device.parameterRevision;
        if (state == ParameterState::Ram)
            device.lastWrite = workbench.time;
        workbench.publish();
    }
};

/// The field that is open in the table.
inline QLineEdit *field(ParameterBench &bench)
{
    return bench.view().viewport()->findChild<QLineEdit *>();
}

inline void open(ParameterBench &bench, const char *key)
{
    bench.view().setFocus();
    bench.view().goTo(named(key));
    QTest::keyClick(&bench.view(), Qt::Key_Return);
    QVERIFY(field(bench));
}

inline QAbstractButton *button(ParameterBench &bench, const QString &text)
{
    for (auto *candidate :
        bench.page->findChildren<QAbstractButton *>() + bench.banners.findChildren<QAbstractButton *>()) {
        if (candidate->isVisible() && candidate->text().startsWith(text))
            return candidate;
    }
    return nullptr;
}

inline bool says(ParameterBench &bench, const QString &part)
{
    for (const auto *label : bench.page->findChildren<QLabel *>() + bench.banners.findChildren<QLabel *>()) {
        if (label->isVisible() && label->text().replace(QChar(QChar::Nbsp), QLatin1Char(' ')).contains(part))
            return true;
    }
    return false;
}

inline QString write(const QTemporaryDir &folder, const QString &name, const QByteArray &text)
{
    QString path = folder.filePath(name);
    QFile file(path);
    [[maybe_unused]] const bool open = file.open(QIODevice::WriteOnly);
    file.write(text);
    return path;
}

} // namespace mb::test
