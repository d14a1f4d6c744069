// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sessionrecord.h"

#include "files/jsonfields.h"

#include <QJsonDocument>
#include <QJsonObject>

namespace mb {
namespace {

constexpr int sessionFormat = 1;

QJsonValue geometryToJson(const SessionRecord &record)
{
    return QString::fromLatin1(record.geometry.toBase64());
}

bool readGeometry(const QJsonValue &json, SessionRecord &record)
{
    record.geometry = QByteArray::fromBase64(json.toString().toLatin1());
    return json.isString();
}

} // namespace

template <>
const JsonFields<SessionRecord> jsonFields<SessionRecord>{{"begun", &SessionRecord::begun},
    {"changed", &SessionRecord::changed}, {"ended", &SessionRecord::ended}, {"links", &SessionRecord::links},
    {"units", &SessionRecord::units}, {"selected", &SessionRecord::selected}, {"axis", &SessionRecord::axis},
    {"page", &SessionRecord::page}, {"geometry", geometryToJson, readGeometry}};

QByteArray SessionRecord::toJson() const
{
    QJsonObject object = mb::toJson(*this);
    object.insert(QStringLiteral("session"), sessionFormat);
    return QJsonDocument(object).toJson();
}

Result<SessionRecord> SessionRecord::fromJson(const QByteArray &json)
{
    const QJsonObject object = QJsonDocument::fromJson(json).object();
    if (object.value(QStringLiteral("session")).toInt() != sessionFormat)
        return fail(Fault::OutOfRange, say("this is no session of MotorBench"));
    SessionRecord record;
    mb::fromJson(object, record);
    return record;
}

} // namespace mb
