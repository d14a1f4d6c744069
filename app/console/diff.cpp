// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/namedsettings.h"
#include "app/console/notebook.h"
#include "app/console/parameterrows.h"
#include "app/console/table.h"
#include "app/console/verb.h"
#include "files/jsonlines.h"
#include "model/parameterfile.h"
#include "model/unit.h"
#include "settings/comparison.h"

#include <QJsonArray>

#include <array>
#include <memory>

namespace mb::console {
namespace {

using settings::Side;
using settings::SideDifference;
using Kind = NamedSettings::Kind;

/// One side while it is being found out.
struct Part {
    NamedSettings named;
    const Family *family = nullptr;
    std::string unit; ///< Unit::key of a device
    QByteArray file;  ///< of a file or snapshot
    std::optional<Side> side;
};

Task<void> readDevice(Console &console, Part &part)
{
    Device *const device = co_await connect(console, *part.named.target);
    console.onlyAsk();
    co_await needsApplication(*device);
    const std::vector<TransferOutcome> outcomes = co_await readKept(console, *device, readable(*device));
    if (const auto error = firstError(*device, outcomes))
        co_return fail(*error);
    part.family = &device->family();
    part.unit = unitKeyOf(*device);
    part.side = settings::sideOf(*device);
    co_return {};
}

/// A file or a snapshot, which says itself for which family it is.
Result<void> load(Console &console, Part &part, Notebook &notebook, const std::string &unit)
{
    MB_TRY(auto file, loadSettings(part.named, &notebook, unit));
    if (auto once = linesOf(file).checkKeys(); !once)
        return fail(once.error().about(part.named.text));
    const auto family = familyOf(file);
    if (!family)
        return fail(Fault::OutOfRange, say("%1 is no parameter file", part.named.text),
            say("save one with 'motorbenchctl get DEVICE --file F'"));
    const auto known = parseFamily(console.families(), *family);
    if (!known)
        return fail(known.error().about(part.named.text));
    part.family = *known;
    part.file = std::move(file);
    return {};
}

/// When both families are known.
Result<void> settle(Part &part, const Family &family)
{
    if (part.side)
        return {};
    auto side = part.named.kind == Kind::Defaults ? Result<Side>(settings::defaultsOf(family))
                                                  : settings::sideOf(part.file, family);
    if (!side)
        return fail(side.error().about(part.named.text));
    part.side = std::move(*side);
    return {};
}

QJsonValue entryToJson(const Parameter &parameter, const ParameterStore::Entry &entry)
{
    return parameterToJson(parameter, entry).value(QStringLiteral("value"));
}

std::string shown(const Parameter &parameter, const ParameterStore::Entry &entry)
{
    return shownValue(parameter, entry.raw) + (entry.state == ParameterState::Assumed ? " (assumed)" : "");
}

void show(Console &console, const Family &family, const std::vector<SideDifference> &differences)
{
    QJsonArray rows;
    Table table({"KEY", "A", "B", "NOTE"});
    for (const SideDifference &difference : differences) {
        const Parameter &parameter = family.parameters[difference.index.value];
        rows.append(QJsonObject{
            {QStringLiteral("key"), qt(parameter.key)},
            {QStringLiteral("a"), entryToJson(parameter, difference.a)},
            {QStringLiteral("b"), entryToJson(parameter, difference.b)},
            {QStringLiteral("unit"), qt(parameter.unit)},
            {QStringLiteral("belongs_to_unit"), parameter.belongsToUnit},
        });
        table.add({std::string(parameter.key), shown(parameter, difference.a), shown(parameter, difference.b),
            parameter.belongsToUnit ? "belongs to its unit" : ""});
    }
    if (console.json())
        console.out().json({{QStringLiteral("differences"), rows}});
    else if (differences.empty())
        console.out().line("no differences");
    else
        table.print(console.out());
}

Result<void> areAlike(const std::array<Part, 2> &parts)
{
    if (!parts[0].family || !parts[1].family || parts[0].family == parts[1].family)
        return {};
    return fail(Fault::Usage,
        say("%1 and %2 have different parameters", parts[0].family->title, parts[1].family->title),
        say("compare two of one family"));
}

/// What can be wrong before anything is asked: whatever is no device, in as far as no device is needed to find it.
Task<void> gather(Console &console, std::array<Part, 2> &parts, Notebook &notebook)
{
    for (Part &part : parts) {
        if (part.named.kind == Kind::Device)
            part.family = part.named.target->family;
        const Part &other = &part == parts.data() ? parts[1] : parts[0];
        if (part.named.kind == Kind::File || (part.named.kind == Kind::Snapshot && other.named.kind != Kind::Device)) {
            if (auto loaded = load(console, part, notebook, {}); !loaded)
                co_return loaded;
        }
    }
    if (auto alike = areAlike(parts); !alike)
        co_return alike;
    for (Part &part : parts) {
        if (part.named.kind == Kind::Device)
            co_await readDevice(console, part);
    }
    for (Part &part : parts) {
        const Part &other = &part == parts.data() ? parts[1] : parts[0];
        if (part.named.kind == Kind::Snapshot && other.named.kind == Kind::Device) {
            if (auto loaded = load(console, part, notebook, other.unit); !loaded)
                co_return loaded;
        }
    }
    co_return {};
}

Task<int> diff(Console &console, std::string a, std::string b)
{
    std::array<Part, 2> parts;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        auto named = parseSettings(console, i == 0 ? a : b);
        if (!named)
            co_return fail(named.error());
        parts.at(i).named = std::move(*named);
    }
    if (parts[0].named.kind == Kind::Defaults && parts[1].named.kind == Kind::Defaults)
        co_return fail(
            Fault::Usage, say("the defaults of no family cannot be compared"), say("name a device, file or snapshot"));
    Notebook notebook(console);
    co_await gather(console, parts, notebook);
    co_await areAlike(parts);
    const Family *const family = parts[0].family ? parts[0].family : parts[1].family;
    for (Part &part : parts)
        co_await settle(part, *family);
    const std::vector<SideDifference> differences = settings::compare(*parts[0].side, *parts[1].side);
    show(console, *family, differences);
    co_return differences.empty() ? exitDone : exitDevice;
}

} // namespace

Job declareDiff(CLI::App &arguments)
{
    const auto a = std::make_shared<std::string>();
    const auto b = std::make_shared<std::string>();
    arguments.add_option("A", *a, "A device, a file, snapshot:NAME, snapshot:NUMBER or defaults")->required();
    arguments.add_option("B", *b, "Another one of these")->required();
    return [a, b](Console &console) { return diff(console, *a, *b); };
}

} // namespace mb::console
