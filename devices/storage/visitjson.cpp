// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/visitjson.h"

#include "files/csvtext.h"
#include "files/filebytes.h"
#include "files/jsonfields.h"
#include "files/qttext.h"
#include "model/parameter.h"
#include "service/recipe.h"

#include <algorithm>
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
        if (value.key == service::figure::encoder)
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

std::string rowOf(const Visit &v, const std::set<std::string> &keys)
{
    std::vector<std::string> cells{csvTime(v.time), v.station, v.person, v.recipe, v.recipeHash, v.imageHash, v.unit,
        v.serial, v.device, std::string(toString(v.outcome)), std::string(toString(v.step)), v.from, v.to,
        v.parameters ? std::to_string(*v.parameters) : "", v.number ? std::to_string(*v.number) : "",
        numberText(std::round(v.seconds * 10.0) / 10.0), v.cause.english(), v.remedy.english(), v.evidence.english(),
        v.note};
    for (const std::string &key : keys) {
        const auto measured = std::ranges::find(v.test, key, &TestValue::key);
        cells.push_back(measured != v.test.end() && measured->value ? numberText(*measured->value) : "");
    }
    return csvRow(cells);
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
        text += rowOf(visit, keys);
    return saveFile(path, QByteArray::fromStdString(text));
}

} // namespace mb
