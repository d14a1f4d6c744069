// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/parameterfile.h"

#include "files/jsonlines.h"
#include "files/qttext.h"
#include "model/family.h"

#include <QJsonDocument>

#include <algorithm>
#include <array>
#include <cmath>

namespace mb {
namespace {

using OptionalRaw = std::optional<std::int64_t>;

Result<OptionalRaw> rawOf(const Parameter &parameter, const QJsonValue &raw)
{
    if (raw.isNull() || raw.isUndefined())
        return OptionalRaw();
    const std::string key(parameter.key);
    const double number = raw.toDouble();
    if (!raw.isDouble() || number != std::floor(number))
        return fail(
            Fault::OutOfRange, say("%1: raw is not a whole number", key), say("delete it, the value says the same"));
    const RawRange wire = rangeOf(parameter.type); // what does not fit cannot be cast either
    if (number < static_cast<double>(wire.low) || number > static_cast<double>(wire.high)
        || !isLegal(parameter, static_cast<std::int64_t>(number)))
        return fail(Fault::OutOfRange, say("%1: raw value %2 is out of range", key, number));
    return OptionalRaw(static_cast<std::int64_t>(number));
}

Result<OptionalRaw> valueOf(const Parameter &parameter, const QJsonValue &value)
{
    if (value.isNull() || value.isUndefined())
        return OptionalRaw();
    const bool isFlag = parameter.type == WireType::Boolean;
    if (isFlag && value.isBool())
        return OptionalRaw(value.toBool() ? 1 : 0);
    if (isFlag || !value.isDouble())
        return fail(Fault::OutOfRange, say("%1: its value is of the wrong kind", parameter.key),
            isFlag ? say("write true or false") : say("write a number"));
    MB_TRY(const auto raw, toRaw(parameter, value.toDouble()));
    return OptionalRaw(raw);
}

/// Of a row that has both, one may have been edited and the other forgotten: which one nobody can know.
Result<OptionalRaw> rawFrom(const Parameter &parameter, const QJsonObject &row)
{
    MB_TRY(const OptionalRaw raw, rawOf(parameter, row.value(QLatin1String("raw"))));
    MB_TRY(const OptionalRaw value, valueOf(parameter, row.value(QLatin1String("value"))));
    if (raw && value && *raw != *value)
        return fail(Fault::OutOfRange,
            say("%1: its value says %2, its raw value %3", parameter.key, toText(parameter, *value),
                toText(parameter, *raw)),
            say("delete the one of the two that is old"));
    const QString unit = row.value(QLatin1String("unit")).toString(qt(parameter.unit));
    if (!raw && value && unit != qt(parameter.unit))
        return fail(Fault::OutOfRange,
            say("%1: its value is in '%2', its unit is '%3'", parameter.key, unit.toStdString(), parameter.unit),
            say("write it in that unit"));
    return raw ? raw : value;
}

/// One that is spelt otherwise would be taken for a value that nobody knew.
Result<void> checkMembers(const QString &key, const QJsonObject &row)
{
    constexpr std::array<std::string_view, 5> members{"value", "raw", "unit", "state", "verified"};
    for (auto member = row.begin(); member != row.end(); ++member) {
        const std::string name = member.key().toStdString();
        if (std::ranges::find(members, name) == members.end())
            return fail(Fault::OutOfRange, say("%1: unknown key %2", key.toStdString(), name),
                say("write \"value\" or \"raw\""));
    }
    return {};
}

Result<void> takeRow(const Family &family, const QString &key, const QJsonValue &row, ParameterFile &file)
{
    const auto index = findParameter(family.parameters, key.toStdString());
    if (!index)
        return fail(Fault::OutOfRange, say("unknown key %1", key.toStdString()), say("correct it, or delete its row"));
    if (!row.isObject())
        return fail(Fault::OutOfRange, say("%1 is not an object", key.toStdString()));
    MB_TRY_VOID(checkMembers(key, row.toObject()));
    MB_TRY(const auto raw, rawFrom(family.parameters[index->value], row.toObject()));
    if (raw)
        file.values.push_back({*index, *raw});
    else
        file.notes.push_back(say("%1 was unknown when the file was written", key.toStdString()));
    return {};
}

} // namespace

QJsonObject parameterToJson(const Parameter &parameter, const ParameterStore::Entry &entry)
{
    QJsonObject row;
    row.insert(QLatin1String("unit"), qt(parameter.unit));
    row.insert(QLatin1String("state"), qt(toString(entry.state)));
    row.insert(QLatin1String("raw"), QJsonValue());
    row.insert(QLatin1String("value"), QJsonValue());
    if (!entry.raw || entry.state == ParameterState::Failed)
        return row;
    row.insert(QLatin1String("raw"), static_cast<double>(*entry.raw));
    const Value value = toValue(parameter, *entry.raw);
    if (const bool *flag = std::get_if<bool>(&value))
        row.insert(QLatin1String("value"), *flag);
    else if (const double *number = std::get_if<double>(&value))
        row.insert(QLatin1String("value"), *number);
    return row;
}

ParameterSource sourceOf(const Device &device)
{
    return {device.family(), device.identity(), device.selector(), device.parameters().entries()};
}

QJsonObject parametersToJson(const ParameterSource &source, std::span<const ParameterIndex> indices)
{
    QJsonObject rows;
    for (const ParameterIndex index : indices) {
        const Parameter &parameter = source.family.parameters[index.value];
        rows.insert(qt(parameter.key), parameterToJson(parameter, source.entries[index.value]));
    }
    QJsonObject object;
    object.insert(QLatin1String("device"), qt(source.selector));
    object.insert(QLatin1String("family"), qt(source.family.key));
    object.insert(QLatin1String("serial"), textOrNull(source.identity.serial));
    object.insert(QLatin1String("firmware"), textOrNull(source.identity.firmware));
    object.insert(QLatin1String("parameters"), rows);
    return object;
}

QJsonObject parametersToJson(const Device &device, std::span<const ParameterIndex> indices)
{
    return parametersToJson(sourceOf(device), indices);
}

std::optional<std::string> familyOf(const QByteArray &bytes)
{
    if (!linesOf(bytes).checkKeys())
        return std::nullopt;
    const QJsonValue family = QJsonDocument::fromJson(bytes).object().value(QLatin1String("family"));
    return family.isString() ? std::optional(family.toString().toStdString()) : std::nullopt;
}

Result<ParameterFile> parseParameterFile(const QByteArray &bytes, const Family &family)
{
    MB_TRY_VOID(linesOf(bytes).checkKeys());
    QJsonParseError error{};
    const QJsonDocument document = QJsonDocument::fromJson(bytes, &error);
    if (!document.isObject()) {
        const Message why = document.isNull() ? say("%1 at byte %2", error.errorString().toStdString(), error.offset)
                                              : say("no object at the top");
        return fail(Fault::OutOfRange, say("not a parameter file: %1", why));
    }
    const QJsonObject object = document.object();
    ParameterFile file;
    file.family = object.value(QLatin1String("family")).toString().toStdString();
    file.device = object.value(QLatin1String("device")).toString().toStdString();
    file.serial = object.value(QLatin1String("serial")).toString().toStdString();
    file.firmware = object.value(QLatin1String("firmware")).toString().toStdString();
    if (file.family != family.key)
        return fail(
            Fault::OutOfRange, say("the file is for family '%1', the device is of '%2'", file.family, family.key));
    const QJsonValue rows = object.value(QLatin1String("parameters"));
    if (!rows.isObject())
        return fail(Fault::OutOfRange, say("not a parameter file: it has no \"parameters\""));
    const QJsonObject parameters = rows.toObject();
    for (auto row = parameters.begin(); row != parameters.end(); ++row)
        MB_TRY_VOID(takeRow(family, row.key(), row.value(), file));
    std::ranges::sort(
        file.values, [](const ParameterChange &a, const ParameterChange &b) { return a.index < b.index; });
    return file;
}

bool isOfSameUnit(const ParameterSource &source, const ParameterFile &file)
{
    return !file.serial.empty() && file.serial == source.identity.serial;
}

std::vector<ParameterDifference> toRestore(const ParameterSource &source, const ParameterFile &file)
{
    const bool same = isOfSameUnit(source, file);
    std::vector<ParameterDifference> out;
    for (const ParameterChange &change : file.values) {
        const Parameter &parameter = source.family.parameters[change.index.value];
        if (parameter.access == Access::ReadOnly || parameter.nature != Nature::Setting)
            continue;
        if (!parameter.persistent && source.family.capabilities.keepsSettings)
            continue;
        const auto &entry = source.entries[change.index.value];
        const auto known = entry.state == ParameterState::Failed ? std::nullopt : entry.raw;
        if (known != change.raw || parameter.access == Access::WriteOnly)
            out.push_back({change.index, known, change.raw, parameter.belongsToUnit && !same});
    }
    return out;
}

std::vector<ParameterDifference> toRestore(const Device &device, const ParameterFile &file)
{
    return toRestore(sourceOf(device), file);
}

std::vector<ParameterDifference> differences(const ParameterSource &source, const ParameterFile &file)
{
    std::vector<ParameterDifference> out = toRestore(source, file);
    std::erase_if(out, [](const ParameterDifference &each) { return each.from == each.to; });
    return out;
}

std::vector<ParameterDifference> differences(const Device &device, const ParameterFile &file)
{
    return differences(sourceOf(device), file);
}

} // namespace mb
