// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/visitjson.h"

#include "files/filebytes.h"
#include "files/jsonfields.h"
#include "files/qttext.h"
#include "model/parameter.h"

#include <QDateTime>

#include <cmath>
#include <set>

namespace mb {
namespace {

using service::TestValue;
using service::Visit;

/// KEY: value, as the recipe names them.
QJsonObject testLine(const Visit &visit)
{
    QJsonObject object;
    for (const TestValue &value : visit.test) {
        if (value.key == "encoder")
            object.insert(qt(value.key), value.value.value_or(0.0) != 0.0);
        else
            object.insert(qt(value.key), toJson(value.value));
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

template <>
const JsonFields<TestValue> jsonFields<TestValue>{{"key", &TestValue::key}, {"value", &TestValue::value},
    {"low", &TestValue::low}, {"high", &TestValue::high}, {"passed", &TestValue::passed},
    {"unusual", &TestValue::unusual}};

QJsonArray testToJson(const std::vector<TestValue> &test)
{
    return toJson(test);
}

std::vector<TestValue> testFromJson(const QJsonArray &array)
{
    std::vector<TestValue> test;
    fromJson(array, test);
    return test;
}

QJsonObject visitLine(const Visit &visit)
{
    return {
        {QStringLiteral("unit"), qt(visit.unit)},
        {QStringLiteral("serial"), textOrNull(visit.serial)},
        {QStringLiteral("device"), qt(visit.device)},
        {QStringLiteral("result"), qt(toString(visit.outcome))},
        {QStringLiteral("step"), qt(toString(visit.step))},
        {QStringLiteral("from"), textOrNull(visit.from)},
        {QStringLiteral("to"), textOrNull(visit.to)},
        {QStringLiteral("parameters"), toJson(visit.parameters)},
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
