// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/table.h"
#include "app/console/target.h"
#include "app/console/verb.h"

#include <QJsonArray>

#include <memory>

namespace mb::console {
namespace {

std::string_view accessName(Access access)
{
    switch (access) {
    case Access::ReadOnly: return "ro";
    case Access::ReadWrite: return "rw";
    case Access::WriteOnly: return "wo";
    }
    return "";
}

QJsonValue number(const Parameter &parameter, double value)
{
    return parameter.type == WireType::Boolean ? QJsonValue(value != 0.0) : QJsonValue(value);
}

QJsonObject parameterToJson(const Parameter &p)
{
    return {
        {QStringLiteral("key"), qt(p.key)},
        {QStringLiteral("id"), int{p.id}},
        {QStringLiteral("label"), qt(p.label)},
        {QStringLiteral("group"), qt(p.group)},
        {QStringLiteral("type"), qt(typeName(p))},
        {QStringLiteral("unit"), qt(p.unit)},
        {QStringLiteral("min"), number(p, p.minimum)},
        {QStringLiteral("max"), number(p, p.maximum)},
        {QStringLiteral("default"), number(p, p.fallback)},
        {QStringLiteral("access"), qt(accessName(p.access))},
        {QStringLiteral("persistent"), p.persistent},
    };
}

std::string text(const Parameter &p, double value)
{
    if (p.type == WireType::Boolean)
        return value != 0.0 ? "on" : "off";
    return numberText(value);
}

Task<int> parameters(Console &console, std::string key)
{
    const auto family = co_await parseFamily(console.families(), key);
    if (console.json()) {
        QJsonArray rows;
        for (const Parameter &parameter : family->parameters)
            rows.append(parameterToJson(parameter));
        console.out().json({{QStringLiteral("parameters"), rows}});
        co_return exitDone;
    }
    Table table({"KEY", "ID", "TYPE", "MIN", "MAX", "DEFAULT", "UNIT", "ACCESS", "STORED", "LABEL"});
    for (const Parameter &p : family->parameters)
        table.add({std::string(p.key), std::to_string(p.id), std::string(typeName(p)), text(p, p.minimum),
            text(p, p.maximum), text(p, p.fallback), std::string(p.unit), std::string(accessName(p.access)),
            p.persistent ? "yes" : "no", std::string(p.label)});
    table.print(console.out());
    co_return exitDone;
}

} // namespace

Job declareParameters(CLI::App &arguments)
{
    const auto family = std::make_shared<std::string>();
    arguments.add_option("family", *family, "Such as dmc60c")->required();
    return [family](Console &console) { return parameters(console, *family); };
}

} // namespace mb::console
