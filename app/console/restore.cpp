// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/parameterrows.h"
#include "app/console/progressline.h"
#include "app/console/table.h"
#include "app/console/target.h"
#include "app/console/verb.h"

#include <QJsonArray>

#include <algorithm>
#include <memory>

namespace mb::console {
namespace {

constexpr std::int64_t mostBytes = 1 << 20;

struct Arguments {
    std::string device;
    std::string file;
    bool dryRun = false;
    bool unitValues = false;
};

struct Change {
    ParameterDifference difference;
    std::string_view result = "would write";
};

Result<ParameterFile> load(const std::string &path, const Family &family)
{
    const auto bytes = loadFile(path, mostBytes);
    if (!bytes)
        return fail(bytes.error());
    auto file = parseParameterFile(*bytes, family);
    if (!file)
        return fail(
            Fault::OutOfRange, path + ": " + file.error().text(), "save one with 'motorbenchctl get DEVICE --file F'");
    return file;
}

/// What must be known before the difference is: everything in the file that can be read and would be written.
std::vector<ParameterIndex> toRead(const Family &family, const ParameterFile &file)
{
    std::vector<ParameterIndex> indices;
    for (const ParameterChange &change : file.values) {
        const Parameter &p = family.parameters[change.index.value];
        const bool restored = p.persistent || !family.capabilities.keepsSettings;
        if (p.access == Access::ReadWrite && restored && p.nature == Nature::Setting)
            indices.push_back(change.index);
    }
    return indices;
}

QJsonValue toJson(const Parameter &parameter, std::optional<std::int64_t> raw)
{
    if (!raw)
        return {};
    const Value value = toValue(parameter, *raw);
    if (const bool *flag = std::get_if<bool>(&value))
        return *flag;
    return std::get<double>(value);
}

void show(Console &console, const Device &device, const std::vector<Change> &changes)
{
    QJsonArray rows;
    Table table({"KEY", "FROM", "TO", "RESULT"});
    for (const Change &change : changes) {
        const Parameter &parameter = device.parameters().parameter(change.difference.index);
        rows.append(QJsonObject{
            {QStringLiteral("key"), qt(parameter.key)},
            {QStringLiteral("from"), toJson(parameter, change.difference.from)},
            {QStringLiteral("to"), toJson(parameter, change.difference.to)},
            {QStringLiteral("result"), qt(change.result)},
        });
        table.add({std::string(parameter.key), shownValue(parameter, change.difference.from),
            shownValue(parameter, change.difference.to), std::string(change.result)});
    }
    if (console.json())
        console.out().json({{QStringLiteral("changes"), rows}});
    else if (changes.empty())
        console.out().line("nothing to change: " + device.selector() + " has the values already");
    else
        table.print(console.out());
}

/// Of a board that keeps nothing: what was written to it last and a reset has taken.
std::vector<Change> lostChanges(const Device &device)
{
    std::vector<Change> changes;
    for (const ParameterChange &lost : lostSettings(device.family(), device.profile()))
        changes.push_back({{lost.index, std::nullopt, lost.raw}});
    return changes;
}

/// Nothing where no file was named, which only boards that keep nothing allow.
Result<std::optional<ParameterFile>> loadNamed(const std::string &path, const Family &family)
{
    if (path.empty() && family.capabilities.keepsSettings)
        return fail(Fault::Usage, "a " + std::string(family.title) + " keeps its settings itself",
            "name a FILE that 'motorbenchctl get DEVICE --file F' saved");
    if (path.empty())
        return std::optional<ParameterFile>();
    auto file = load(path, family);
    if (!file)
        return fail(file.error());
    return std::optional<ParameterFile>(std::move(*file));
}

/// Writes what differs; yields the first error, after which the rest stays unchanged.
Task<std::optional<Error>> write(Console &console, Device &device, std::vector<Change> &changes)
{
    std::vector<ParameterChange> writes;
    for (const Change &change : changes)
        writes.push_back({change.difference.index, change.difference.to});
    ProgressLine progress(console);
    auto writing = writeParameters(device, writes, progress);
    const std::vector<TransferOutcome> outcomes = co_await std::move(writing);
    for (std::size_t i = 0; i < changes.size(); ++i)
        changes[i].result = i >= outcomes.size() ? "unchanged" : outcomes[i].raw ? "written" : "failed";
    co_return firstError(device, outcomes);
}

Task<void> readCurrent(Console &console, Device &device, std::vector<ParameterIndex> indices)
{
    ProgressLine progress(console);
    auto reading = readParameters(device, std::move(indices), progress);
    const std::vector<TransferOutcome> outcomes = co_await std::move(reading);
    if (const auto error = firstError(device, outcomes))
        co_return fail(*error);
    co_return {};
}

Task<std::vector<Change>> changesOf(Console &console, Device &device, ParameterFile file, Arguments arguments)
{
    for (const std::string &note : file.notes)
        console.note(arguments.file + ": " + note + ", left out");
    auto reading = readCurrent(console, device, toRead(device.family(), file));
    co_await std::move(reading);
    if (!file.serial.empty() && !isOfSameUnit(sourceOf(device), file))
        console.note(arguments.file + " was saved from unit " + file.serial + ", this one is "
            + (device.identity().serial.empty() ? "without a serial number" : device.identity().serial));
    std::vector<Change> changes;
    for (const ParameterDifference &difference : differences(device, file)) {
        if (!difference.ofAnotherUnit || arguments.unitValues)
            changes.push_back({difference});
        else
            console.note(std::string(device.parameters().parameter(difference.index).key)
                + " belongs to the unit that the file was saved from, left out; --unit-values writes it as well");
    }
    co_return changes;
}

Task<int> restore(Console &console, Arguments arguments)
{
    const auto target = parseTarget(console, arguments.device);
    if (!target)
        co_return fail(target.error());
    const auto file = loadNamed(arguments.file, *target->family);
    if (!file)
        co_return fail(file.error());
    auto connecting = connect(console, *target);
    Device *const device = co_await std::move(connecting);
    if (auto ready = needsApplication(*device); !ready)
        co_return fail(ready.error());
    std::vector<Change> changes = *file ? std::vector<Change>() : lostChanges(*device);
    if (*file) {
        auto comparing = changesOf(console, *device, **file, arguments);
        changes = co_await std::move(comparing);
    }
    std::optional<Error> error;
    if (!arguments.dryRun && !changes.empty()) {
        auto writing = write(console, *device, changes);
        error = co_await std::move(writing);
    }
    show(console, *device, changes);
    if (!error)
        co_return exitDone;
    co_return console.fails(*error);
}

} // namespace

Job declareRestore(CLI::App &arguments)
{
    const auto a = std::make_shared<Arguments>();
    arguments.add_option("device", a->device, "LINK/FAMILY:ADDRESS")->required();
    arguments.add_option("file", a->file,
        "A file that 'get --file' saved; without it, on boards that keep nothing, what was last written to them");
    arguments.add_flag("--dry-run", a->dryRun, "Show the difference, write nothing");
    arguments.add_flag("--unit-values", a->unitValues,
        "Also what belongs to the one unit that the file was saved from, such as its calibration or node id");
    return [a](Console &console) { return restore(console, *a); };
}

} // namespace mb::console
