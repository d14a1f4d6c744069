// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plotlayout.h"

#include "files/filebytes.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QUrl>

namespace mb {
namespace {

constexpr qint64 largestLayout = 1'000'000;
constexpr int mostTraces = 500;
constexpr double shortestWindow = 1e-3;
constexpr double longestWindow = 86400.0;

QString key(const char *name)
{
    return QString::fromLatin1(name);
}

} // namespace

QByteArray PlotLayout::toJson() const
{
    QJsonArray shown;
    for (const Trace &trace : traces)
        shown.append(QJsonObject{{key("device"), trace.device}, {key("key"), trace.key}, {key("pane"), trace.pane},
            {key("second"), trace.second}});
    QJsonArray formulas;
    for (const Derived &signal : derived) {
        QJsonArray meanings;
        for (const Meaning &meaning : signal.meanings)
            meanings.append(
                QJsonObject{{key("name"), meaning.name}, {key("device"), meaning.device}, {key("key"), meaning.key}});
        formulas.append(QJsonObject{{key("name"), signal.name}, {key("unit"), signal.unit},
            {key("formula"), signal.formula}, {key("meanings"), meanings}});
    }
    return QJsonDocument(QJsonObject{{key("motorbench"), key("plot layout")}, {key("window"), window},
                             {key("traces"), shown}, {key("derived"), formulas}})
        .toJson();
}

Result<PlotLayout> PlotLayout::fromJson(const QByteArray &json)
{
    const QJsonObject object = QJsonDocument::fromJson(json).object();
    if (object.value(key("motorbench")).toString() != key("plot layout"))
        return fail(Fault::OutOfRange, say("this is no layout of plots"));
    PlotLayout layout;
    layout.window = object.value(key("window")).toDouble(layout.window);
    if (!(layout.window >= shortestWindow && layout.window <= longestWindow))
        return fail(Fault::OutOfRange, say("the window of the layout is out of range"));
    for (const QJsonValue value : object.value(key("traces")).toArray()) {
        const QJsonObject trace = value.toObject();
        layout.traces.push_back({trace.value(key("device")).toString(), trace.value(key("key")).toString(),
            trace.value(key("pane")).toString(), trace.value(key("second")).toBool()});
        if (layout.traces.size() > mostTraces)
            return fail(Fault::OutOfRange, say("the layout has more than 500 traces"));
    }
    for (const QJsonValue value : object.value(key("derived")).toArray()) {
        const QJsonObject signal = value.toObject();
        layout.derived.push_back({signal.value(key("name")).toString(), signal.value(key("unit")).toString(),
            signal.value(key("formula")).toString()});
        for (const QJsonValue said : signal.value(key("meanings")).toArray()) {
            const QJsonObject meaning = said.toObject();
            layout.derived.back().meanings.push_back({meaning.value(key("name")).toString(),
                meaning.value(key("device")).toString(), meaning.value(key("key")).toString()});
        }
    }
    return layout;
}

QString PlotLayouts::fileOf(const QString &name) const
{
    return QDir(m_folder).filePath(QString::fromLatin1(QUrl::toPercentEncoding(name)) + QStringLiteral(".json"));
}

QStringList PlotLayouts::names() const
{
    QStringList names;
    if (m_folder.isEmpty())
        return names;
    for (const QString &file : QDir(m_folder).entryList({QStringLiteral("*.json")}, QDir::Files)) {
        const QString name = QUrl::fromPercentEncoding(file.left(file.size() - 5).toLatin1());
        if (!name.startsWith(QLatin1Char('@')))
            names << name;
    }
    names.sort(Qt::CaseInsensitive);
    return names;
}

Result<PlotLayout> PlotLayouts::load(const QString &name) const
{
    QFile file(fileOf(name));
    if (m_folder.isEmpty() || !file.open(QIODevice::ReadOnly) || file.size() > largestLayout)
        return fail(Fault::OutOfRange, say("there is no layout of this name"));
    return PlotLayout::fromJson(file.readAll());
}

Result<void> PlotLayouts::save(const QString &name, const PlotLayout &layout) const
{
    if (m_folder.isEmpty())
        return fail(Fault::Unsupported, say("a demo remembers no layouts"));
    QDir().mkpath(m_folder);
    return saveFile(fileOf(name).toStdString(), layout.toJson());
}

void PlotLayouts::remove(const QString &name) const
{
    if (!m_folder.isEmpty())
        QFile::remove(fileOf(name));
}

} // namespace mb
