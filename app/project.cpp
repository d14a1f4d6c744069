// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/project.h"

#include "experiment/envelope.h"
#include "files/filebytes.h"
#include "files/jsonfields.h"
#include "model/parameterfile.h"
#include "widgets/common/devicetext.h"
#include "widgets/control/envelopebook.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>

#include <algorithm>

namespace mb {

template <>
const JsonFields<ProjectUnit> jsonFields<ProjectUnit>{{"device", &ProjectUnit::selector}, {"unit", &ProjectUnit::unit},
    {"title", &ProjectUnit::title}, {"name", &ProjectUnit::name}, {"serial", &ProjectUnit::serial},
    {"dialect", &ProjectUnit::dialect}, {"calibration", &ProjectUnit::calibration},
    {"limits", [](const ProjectUnit &unit) { return tuning::limitsToJson(unit.limits); },
        [](const QJsonValue &json, ProjectUnit &unit) {
            unit.limits = tuning::limitsFrom(json.toObject());
            return json.isObject();
        }}};

namespace {

constexpr int projectFormat = 1;
constexpr std::int64_t largestProject = 8 << 20;
constexpr const char *projectFile = "project.json";

Result<void> writeIfNew(const QString &file, const QByteArray &bytes)
{
    const auto before = loadFile(file.toStdString(), largestProject);
    return before && *before == bytes ? Result<void>{} : saveFile(file.toStdString(), bytes);
}

QString parametersFile(const ProjectUnit &unit)
{
    const std::string who = unit.serial.empty() ? unit.selector : unit.serial;
    return QStringLiteral("parameters/%1.json").arg(QString::fromStdString(fileNameOf(who)));
}

/// Its settings; live values would make a difference each time.
QJsonObject settingsOf(const DeviceView &device)
{
    std::vector<ParameterIndex> indices;
    for (std::size_t i = 0; i < device.parameters->size(); ++i) {
        if (device.family->parameters[i].persistent && (*device.parameters)[i].raw)
            indices.push_back(ParameterIndex{static_cast<std::uint16_t>(i)});
    }
    return indices.empty()
        ? QJsonObject()
        : parametersToJson({*device.family, device.identity, device.selector, *device.parameters}, indices);
}

Result<void> makeFolder(const QString &folder)
{
    return QDir().mkpath(folder)
        ? Result<void>()
        : fail(Fault::OutOfRange, mb::say("the folder %1 cannot be written", folder.toStdString()));
}

} // namespace

Result<void> copyLayouts(const QString &from, const QString &to, bool over)
{
    MB_TRY_VOID(makeFolder(to));
    for (const QString &name : QDir(from).entryList({QStringLiteral("*.json")}, QDir::Files)) {
        const QString copy = to + QLatin1Char('/') + name;
        if (!over && QFile::exists(copy))
            continue;
        MB_TRY(const auto bytes, loadFile((from + QLatin1Char('/') + name).toStdString(), largestProject));
        MB_TRY_VOID(writeIfNew(copy, bytes));
    }
    return {};
}

Project Project::of(const Snapshot &shot, const EnvelopeBook &limits)
{
    Project project;
    for (const LinkView &link : shot.links)
        project.links += qt(link.address);
    for (const DeviceView &device : shot.devices) {
        ProjectUnit unit;
        unit.selector = device.selector;
        unit.unit = device.unit;
        unit.title = titleOf(device).toStdString();
        unit.name = device.identity->name;
        unit.serial = device.identity->serial;
        unit.dialect = device.profile->dialect;
        unit.calibration = device.profile->calibration;
        unit.limits = limits.entered(unit.unit);
        unit.parameters = settingsOf(device);
        project.units.push_back(std::move(unit));
    }
    return project;
}

Result<void> Project::save(const QString &folder) const
{
    for (const char *name : {"/parameters", "/plots"})
        MB_TRY_VOID(makeFolder(folder + QLatin1String(name)));
    QJsonArray rows;
    for (const ProjectUnit &unit : units) {
        QJsonObject row = toJson(unit);
        if (!unit.parameters.isEmpty()) {
            row.insert(QStringLiteral("parameters"), parametersFile(unit));
            const QString file = folder + QLatin1Char('/') + parametersFile(unit);
            MB_TRY_VOID(writeIfNew(file, QJsonDocument(unit.parameters).toJson()));
        }
        rows.append(row);
    }
    const QJsonObject object{{QStringLiteral("project"), projectFormat},
        {QStringLiteral("links"), QJsonArray::fromStringList(links)}, {QStringLiteral("units"), rows}};
    if (!layouts.isEmpty())
        MB_TRY_VOID(copyLayouts(layouts, folder + QStringLiteral("/plots"), true));
    return writeIfNew(folder + QLatin1Char('/') + QLatin1String(projectFile), QJsonDocument(object).toJson());
}

Result<Project> Project::load(const QString &folder)
{
    const QString file = folder + QLatin1Char('/') + QLatin1String(projectFile);
    MB_TRY(const auto bytes, loadFile(file.toStdString(), largestProject));
    QJsonParseError error;
    const QJsonObject object = QJsonDocument::fromJson(bytes, &error).object();
    if (error.error != QJsonParseError::NoError)
        return fail(Fault::OutOfRange, say("%1: %2", file.toStdString(), error.errorString().toStdString()));
    if (object.value(QStringLiteral("project")).toInt() != projectFormat)
        return fail(Fault::OutOfRange, say("%1 is no project of this version", file.toStdString()));
    Project project;
    for (const QJsonValue link : object.value(QStringLiteral("links")).toArray()) {
        if (const auto address = LinkAddress::parse(link.toString().toStdString()); !address)
            return fail(Fault::OutOfRange, say("%1: %2", file.toStdString(), address.error().message()));
        project.links += link.toString();
    }
    for (const QJsonValue row : object.value(QStringLiteral("units")).toArray()) {
        ProjectUnit unit;
        fromJson(row, unit);
        const QString parameters = row.toObject().value(QStringLiteral("parameters")).toString();
        if (!parameters.isEmpty() && parameters == parametersFile(unit)) { // and no other file of this computer
            const auto values = loadFile((folder + QLatin1Char('/') + parameters).toStdString(), largestProject);
            if (values)
                unit.parameters = QJsonDocument::fromJson(*values).object();
        }
        project.units.push_back(std::move(unit));
    }
    project.layouts = QDir(folder).exists(QStringLiteral("plots")) ? folder + QStringLiteral("/plots") : QString();
    return project;
}

const ProjectUnit *Project::unitOf(const DeviceView &device) const
{
    const auto bySerial = std::ranges::find_if(units,
        [&device](const ProjectUnit &unit) { return !unit.serial.empty() && unit.serial == device.identity->serial; });
    if (bySerial != units.end())
        return &*bySerial;
    const auto byPlace = std::ranges::find_if(
        units, [&device](const ProjectUnit &unit) { return unit.serial.empty() && unit.selector == device.selector; });
    return byPlace == units.end() ? nullptr : &*byPlace;
}

} // namespace mb
