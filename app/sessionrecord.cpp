// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sessionrecord.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace mb {
namespace {

constexpr int sessionFormat = 1;

QStringList textsOf(const QJsonValue &value)
{
    QStringList texts;
    for (const QJsonValue one : value.toArray())
        texts += one.toString();
    return texts;
}

} // namespace

QByteArray SessionRecord::toJson() const
{
    const QJsonObject object{{QStringLiteral("session"), sessionFormat}, {QStringLiteral("begun"), begun},
        {QStringLiteral("changed"), changed}, {QStringLiteral("ended"), ended},
        {QStringLiteral("links"), QJsonArray::fromStringList(links)},
        {QStringLiteral("units"), QJsonArray::fromStringList(units)}, {QStringLiteral("selected"), selected},
        {QStringLiteral("axis"), axis}, {QStringLiteral("page"), page},
        {QStringLiteral("geometry"), QString::fromLatin1(geometry.toBase64())}};
    return QJsonDocument(object).toJson();
}

Result<SessionRecord> SessionRecord::fromJson(const QByteArray &json)
{
    const QJsonObject object = QJsonDocument::fromJson(json).object();
    if (object.value(QStringLiteral("session")).toInt() != sessionFormat)
        return fail(Fault::OutOfRange, say("this is no session of MotorBench"));
    SessionRecord record;
    record.begun = static_cast<qint64>(object.value(QStringLiteral("begun")).toDouble());
    record.changed = static_cast<qint64>(object.value(QStringLiteral("changed")).toDouble());
    record.ended = object.value(QStringLiteral("ended")).toBool();
    record.links = textsOf(object.value(QStringLiteral("links")));
    record.units = textsOf(object.value(QStringLiteral("units")));
    record.selected = object.value(QStringLiteral("selected")).toString();
    record.axis = object.value(QStringLiteral("axis")).toInt();
    record.page = object.value(QStringLiteral("page")).toString();
    record.geometry = QByteArray::fromBase64(object.value(QStringLiteral("geometry")).toString().toLatin1());
    return record;
}

} // namespace mb
