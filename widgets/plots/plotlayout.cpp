// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/plotlayout.h"

#include "files/filebytes.h"
#include "files/jsonfields.h"

#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QUrl>

namespace mb {
namespace {

constexpr qint64 largestLayout = 1'000'000;
constexpr std::size_t mostTraces = 500;
constexpr double shortestWindow = 1e-3;
constexpr double longestWindow = 86400.0;

const QLatin1String layoutKey("motorbench");
const QLatin1String layoutMark("plot layout");

} // namespace

template <>
const JsonFields<PlotLayout::Trace> jsonFields<PlotLayout::Trace>{{"device", &PlotLayout::Trace::device},
    {"key", &PlotLayout::Trace::key}, {"pane", &PlotLayout::Trace::pane}, {"second", &PlotLayout::Trace::second}};
template <>
const JsonFields<PlotLayout::Meaning> jsonFields<PlotLayout::Meaning>{
    {"name", &PlotLayout::Meaning::name}, {"device", &PlotLayout::Meaning::device}, {"key", &PlotLayout::Meaning::key}};
template <>
const JsonFields<PlotLayout::Derived> jsonFields<PlotLayout::Derived>{{"name", &PlotLayout::Derived::name},
    {"unit", &PlotLayout::Derived::unit}, {"formula", &PlotLayout::Derived::formula},
    {"meanings", &PlotLayout::Derived::meanings}};
template <>
const JsonFields<PlotLayout> jsonFields<PlotLayout>{
    {"window", &PlotLayout::window}, {"traces", &PlotLayout::traces}, {"derived", &PlotLayout::derived}};

QByteArray PlotLayout::toJson() const
{
    QJsonObject object = mb::toJson(*this);
    object.insert(layoutKey, layoutMark);
    return QJsonDocument(object).toJson();
}

Result<PlotLayout> PlotLayout::fromJson(const QByteArray &json)
{
    const QJsonObject object = QJsonDocument::fromJson(json).object();
    if (object.value(layoutKey).toString() != layoutMark)
        return fail(Fault::OutOfRange, say("this is no layout of plots"));
    PlotLayout layout;
    mb::fromJson(object, layout);
    if (!(layout.window >= shortestWindow && layout.window <= longestWindow))
        return fail(Fault::OutOfRange, say("the window of the layout is out of range"));
    if (layout.traces.size() > mostTraces)
        return fail(Fault::OutOfRange, say("the layout has more than 500 traces"));
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
        if (!isOwn(name))
            names << name;
    }
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
