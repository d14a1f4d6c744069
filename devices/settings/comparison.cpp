// SPDX-License-Identifier: GPL-3.0-or-later
#include "settings/comparison.h"

#include "files/qttext.h"
#include "model/family.h"

#include <QJsonDocument>

#include <cmath>

namespace mb::settings {
namespace {

using Entry = ParameterStore::Entry;

ParameterState stateFrom(const QString &text)
{
    for (const ParameterState state : {ParameterState::Stored, ParameterState::Ram, ParameterState::Volatile,
             ParameterState::Assumed, ParameterState::Failed}) {
        if (text == qt(toString(state)))
            return state;
    }
    return ParameterState::Unknown;
}

} // namespace

Side sideOf(const Device &device)
{
    Side side = sideOf(sourceOf(device));
    for (std::uint16_t i = 0; i < side.entries.size(); ++i) {
        if (!device.offers({i}))
            side.entries[i].reset();
    }
    return side;
}

Side sideOf(const ParameterSource &source)
{
    Side side{&source.family, source.identity.serial, {}};
    for (const Entry &entry : source.entries)
        side.entries.emplace_back(
            entry.state == ParameterState::Failed ? Entry{std::nullopt, ParameterState::Failed} : entry);
    return side;
}

Result<Side> sideOf(const QByteArray &file, const Family &family)
{
    MB_TRY(const auto parsed, parseParameterFile(file, family));
    Side side{&family, parsed.serial, {}};
    const QJsonObject rows = QJsonDocument::fromJson(file).object().value(QLatin1String("parameters")).toObject();
    for (const Parameter &parameter : family.parameters) {
        const QJsonValue row = rows.value(qt(parameter.key));
        side.entries.emplace_back();
        if (row.isObject())
            side.entries.back().emplace(
                Entry{std::nullopt, stateFrom(row.toObject().value(QLatin1String("state")).toString())});
    }
    for (const ParameterChange &value : parsed.values)
        side.entries[value.index.value]->raw = value.raw;
    return side;
}

Side defaultsOf(const Family &family)
{
    Side side{&family, {}, {}};
    for (const Parameter &parameter : family.parameters)
        side.entries.emplace_back(Entry{std::llround(parameter.fallback * parameter.one), ParameterState::Stored});
    return side;
}

bool isSetting(const Parameter &parameter)
{
    return parameter.nature == Nature::Setting && parameter.access != Access::ReadOnly;
}

std::vector<SideDifference> compare(const Side &a, const Side &b)
{
    std::vector<SideDifference> differences;
    for (std::uint16_t i = 0; i < a.family->parameters.size(); ++i) {
        const auto &one = a.entries[i];
        const auto &other = b.entries[i];
        if (one && other && isSetting(a.family->parameters[i]) && one->raw != other->raw)
            differences.push_back({{i}, *one, *other});
    }
    return differences;
}

} // namespace mb::settings
