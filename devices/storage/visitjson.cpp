// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/visitjson.h"

#include "files/filebytes.h"
#include "files/qttext.h"
#include "model/parameter.h"

#include <QDateTime>

#include <cmath>
#include <set>

namespace mb {
namespace {

using service::TestValue;
using service::Visit;

QJsonValue jsonOrNull(const std::string &text)
{
    return text.empty() ? QJsonValue() : QJsonValue(qt(text));
}

QJsonValue jsonOrNull(const std::optional<double> &number)
{
    return number ? QJsonValue(*number) : QJsonValue();
}

std::optional<double> numberIn(const QJsonValue &value)
{
    return value.isDouble() ? std::optional(value.toDouble()) : std::nullopt;
}

/// KEY: value, as the recipe names them.
QJsonObject testLine(const Visit &visit)
{
    QJsonObject object;
    for (const TestValue &value : visit.test) {
        if (value.key == "encoder")
            object.insert(qt(value.key), value.value.value_or(0.0) != 0.0);
        else
            object.insert(qt(value.key), jsonOrNull(value.value));
    }
    return object;
}

QString evidenceOf(const Visit &visit)
{
    const Message trail = visit.evidence == visit.cause ? Message() : visit.evidence;
    return qt(joined(joined(visit.cause, visit.remedy), trail).english());
}

std::string csvCell(const std::string &text)
{
    if (text.find_first_of(",\"\n\r") == std::string::npos)
        return text;
    std::string inside;
    for (const char c : text)
        inside += c == '"' ? std::string("\"\"") : std::string(1, c);
    return '"' + inside + '"';
}

std::string isoTime(double time)
{
    return QDateTime::fromMSecsSinceEpoch(std::llround(time * 1e3), Qt::UTC).toString(Qt::ISODate).toStdString();
}

std::string csvRow(const Visit &v, const std::set<std::string> &keys)
{
    std::string row;
    const std::string number = v.number ? std::to_string(*v.number) : std::string();
    const std::string count = v.parameters ? std::to_string(*v.parameters) : std::string();
    for (const std::string &cell : {isoTime(v.time), v.station, v.person, v.recipe, v.recipeHash, v.imageHash, v.unit,
             v.serial, v.device, std::string(toString(v.outcome)), std::string(toString(v.step)), v.from, v.to, count,
             number, numberText(std::round(v.seconds * 10.0) / 10.0), v.cause.english(), v.remedy.english(),
             v.evidence.english(), v.note})
        row += (row.empty() ? "" : ",") + csvCell(cell);
    for (const std::string &key : keys) {
        row += ',';
        for (const TestValue &value : v.test)
            row += value.key == key && value.value ? numberText(*value.value) : std::string();
    }
    return row + '\n';
}

} // namespace

QJsonArray testToJson(const std::vector<TestValue> &test)
{
    QJsonArray array;
    for (const TestValue &value : test) {
        array.append(
            QJsonObject{{QStringLiteral("key"), qt(value.key)}, {QStringLiteral("value"), jsonOrNull(value.value)},
                {QStringLiteral("low"), jsonOrNull(value.low)}, {QStringLiteral("high"), jsonOrNull(value.high)},
                {QStringLiteral("passed"), value.passed}, {QStringLiteral("unusual"), value.unusual}});
    }
    return array;
}

std::vector<TestValue> testFromJson(const QJsonArray &array)
{
    std::vector<TestValue> test;
    for (const QJsonValue each : array) {
        const QJsonObject object = each.toObject();
        TestValue value;
        value.key = object.value(QStringLiteral("key")).toString().toStdString();
        value.value = numberIn(object.value(QStringLiteral("value")));
        value.low = numberIn(object.value(QStringLiteral("low")));
        value.high = numberIn(object.value(QStringLiteral("high")));
        value.passed = object.value(QStringLiteral("passed")).toBool();
        value.unusual = object.value(QStringLiteral("unusual")).toBool();
        test.push_back(std::move(value));
    }
    return test;
}

QJsonObject visitLine(const Visit &visit)
{
    return {
        {QStringLiteral("unit"), qt(visit.unit)},
        {QStringLiteral("serial"), jsonOrNull(visit.serial)},
        {QStringLiteral("device"), qt(visit.device)},
        {QStringLiteral("result"), qt(toString(visit.outcome))},
        {QStringLiteral("step"), qt(toString(visit.step))},
        {QStringLiteral("from"), jsonOrNull(visit.from)},
        {QStringLiteral("to"), jsonOrNull(visit.to)},
        {QStringLiteral("parameters"), visit.parameters ? QJsonValue(*visit.parameters) : QJsonValue()},
        {QStringLiteral("test"), testLine(visit)},
        {QStringLiteral("seconds"), std::round(visit.seconds * 1e3) / 1e3},
        {QStringLiteral("evidence"), evidenceOf(visit)},
    };
}

QJsonObject visitRow(const Visit &visit)
{
    QJsonObject row = visitLine(visit);
    row.insert(QStringLiteral("time"), visit.time);
    row.insert(QStringLiteral("station"), qt(visit.station));
    row.insert(QStringLiteral("recipe"), qt(visit.recipe));
    row.insert(QStringLiteral("note"), qt(visit.note));
    return row;
}

QJsonArray visitRows(const std::vector<Visit> &visits)
{
    QJsonArray rows;
    for (const Visit &visit : visits)
        rows.append(visitRow(visit));
    return rows;
}

Result<void> exportVisits(const std::string &path, const std::vector<Visit> &visits)
{
    std::set<std::string> keys;
    for (const Visit &visit : visits) {
        for (const TestValue &value : visit.test)
            keys.insert(value.key);
    }
    std::string text = "time,station,person,recipe,recipe_hash,image_hash,unit,serial,device,result,step,from,to,"
                       "parameters,number,seconds,cause,remedy,evidence,note";
    for (const std::string &key : keys)
        text += ',' + key;
    text += '\n';
    for (const Visit &visit : visits)
        text += csvRow(visit, keys);
    return saveFile(path, QByteArray::fromStdString(text));
}

} // namespace mb
