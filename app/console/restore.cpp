// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/namedsettings.h"
#include "app/console/notebook.h"
#include "app/console/parameterrows.h"
#include "app/console/progressline.h"
#include "app/console/question.h"
#include "app/console/table.h"
#include "app/console/target.h"
#include "app/console/verb.h"
#include "model/unit.h"
#include "settings/writing.h"

#include <QJsonArray>

#include <algorithm>
#include <memory>

namespace mb::console {
namespace {

struct RestoreArguments {
    std::string device;
    std::string file;
    bool dryRun = false;
    std::vector<std::string> unitValues; ///< keys
    bool yes = false;
};

struct Change {
    ParameterDifference difference;
    std::string_view result = "would write";
};

Result<ParameterFile> parsed(const std::string &name, const Result<QByteArray> &bytes, const Family &family)
{
    if (!bytes)
        return fail(bytes.error());
    auto file = parseParameterFile(*bytes, family);
    if (!file)
        return fail(Fault::OutOfRange, say("%1: %2", name, file.error().detail),
            file.error().help().empty() ? say("save one with 'motorbenchctl get DEVICE --file F'")
                                        : file.error().help());
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

QJsonValue valueToJson(const Parameter &parameter, std::optional<std::int64_t> raw)
{
    if (!raw)
        return {};
    const Value value = toValue(parameter, *raw);
    if (const bool *flag = std::get_if<bool>(&value))
        return *flag;
    return std::get<double>(value);
}

/// `otherwise`: of the device, where nothing is to be changed.
void show(Console &console, const Device &device, const std::vector<Change> &changes, std::string_view otherwise)
{
    QJsonArray rows;
    Table table({"KEY", "FROM", "TO", "RESULT"});
    for (const Change &change : changes) {
        const Parameter &parameter = device.parameters().parameter(change.difference.index);
        rows.append(QJsonObject{
            {QStringLiteral("key"), qt(parameter.key)},
            {QStringLiteral("from"), valueToJson(parameter, change.difference.from)},
            {QStringLiteral("to"), valueToJson(parameter, change.difference.to)},
            {QStringLiteral("result"), qt(change.result)},
        });
        table.add({std::string(parameter.key), shownValue(parameter, change.difference.from),
            shownValue(parameter, change.difference.to), std::string(change.result)});
    }
    if (console.json())
        console.out().json({{QStringLiteral("changes"), rows}});
    else if (changes.empty())
        console.out().line("nothing to change: " + device.selector() + ' ' + std::string(otherwise));
    else
        table.print(console.out());
}

/// Of a board that keeps nothing: what was written to it last and a reset has taken.
std::vector<Change> lostChanges(const Device &device)
{
    std::vector<Change> changes;
    for (const ParameterChange &lost : lostSettings(device.family(), device.knowledge().profile()))
        changes.push_back({{lost.index, std::nullopt, lost.raw}});
    return changes;
}

/// What can be said of it before the device is asked. Nothing where no file was named, which only boards that keep nothing allow.
Result<std::optional<NamedSettings>> nameSource(
    const Console &console, const RestoreArguments &arguments, const Family &family)
{
    for (const std::string &key : arguments.unitValues) {
        MB_TRY(const auto index, parseKey(family, key));
        if (!family.parameters[index.value].belongsToUnit)
            return fail(Fault::Usage, say("--unit-values: %1 belongs to no unit, and is written anyway", key),
                say("leave it out"));
    }
    if (arguments.file.empty() && family.capabilities.keepsSettings)
        return fail(Fault::Usage, say("settings of %1 are kept by the unit itself", family.title),
            say("name a FILE that 'motorbenchctl get DEVICE --file F' saved"));
    if (arguments.file.empty())
        return std::optional<NamedSettings>();
    MB_TRY(auto named, parseSettings(console, arguments.file));
    if (named.kind != NamedSettings::Kind::File && named.kind != NamedSettings::Kind::Snapshot)
        return fail(Fault::Usage, say("'%1' is neither a file nor a snapshot", arguments.file),
            say("save what is there first, 'motorbenchctl snapshot DEVICE'"));
    return std::optional(std::move(named));
}

/// A snapshot of a place may be of another unit, which nobody can know but the user.
Task<void> mayPutBack(Console &console, const Device &device, SettingsBook &book, const NamedSettings &named,
    const RestoreArguments &arguments)
{
    const UnitBy by = unitByOf(book.resolved(unitKeyOf(device)));
    if (named.kind != NamedSettings::Kind::Snapshot || by != UnitBy::Place || arguments.dryRun || arguments.yes)
        co_return {};
    const Message cause = say("%1 has no serial number: the snapshot is of %2", device.selector(), unitCaveatOf(by));
    if (const bool agreed = co_await isAgreedTo(console, cause.english() + "; write it?"); agreed)
        co_return {};
    co_return fail(Fault::Usage, cause,
        say("look at --dry-run first; --yes writes it, and 'motorbenchctl rename' gives the unit a name of its own"));
}

/// Writes what differs; yields the first error, after which the rest stays unchanged.
Task<std::optional<Error>> write(Console &console, Device &device, Notebook &notebook, std::vector<Change> &changes)
{
    co_await notebook.keepOrRefuse(device, settings::Occasion::Restore);
    std::vector<ParameterChange> writes;
    for (const Change &change : changes)
        writes.push_back({change.difference.index, change.difference.to});
    WriteProgress progress(console);
    auto writing = settings::writeKept(
        device, writes, {settings::Origin::Console, settings::Purpose::Restore}, notebook.settings(), progress);
    const std::vector<TransferOutcome> outcomes = co_await std::move(writing);
    for (Change &change : changes) { // they were written in the order that is never livelier in between
        const auto outcome = std::ranges::find(outcomes, change.difference.index, &TransferOutcome::index);
        change.result = outcome == outcomes.end() ? "unchanged" : outcome->raw ? "written" : "failed";
    }
    co_return firstError(device, outcomes);
}

Task<void> readCurrent(Console &console, Device &device, std::vector<ParameterIndex> indices)
{
    ProgressLine progress(console);
    const std::vector<TransferOutcome> outcomes = co_await readParameters(device, std::move(indices), progress);
    if (const auto error = firstError(device, outcomes))
        co_return fail(*error);
    co_return {};
}

/// What this unit's dialect does not have: the file may be of a unit of another one. Unsupported where the dialect is not known.
Result<void> leaveOut(const Device &device, ParameterFile &file)
{
    const auto absent = std::stable_partition(file.values.begin(), file.values.end(),
        [&device](const ParameterChange &change) { return device.offers(change.index); });
    if (absent != file.values.end() && device.identity().dialect.empty())
        return fail(Fault::Unsupported, device.identity().detail);
    for (auto change = absent; change != file.values.end(); ++change)
        file.notes.push_back(
            say("%1 does not exist in this device's dialect", device.parameters().parameter(change->index).key));
    file.values.erase(absent, file.values.end());
    return {};
}

Task<std::vector<Change>> changesOf(Console &console, Device &device, ParameterFile file, RestoreArguments arguments)
{
    for (const Message &note : file.notes)
        console.note(arguments.file + ": " + note.english() + ", left out");
    co_await readCurrent(console, device, toRead(device.family(), file));
    if (!file.serial.empty() && !isOfSameUnit(sourceOf(device), file))
        console.note(arguments.file + " was saved from unit " + file.serial + ", this one is "
            + (device.identity().serial.empty() ? "without a serial number" : device.identity().serial));
    std::vector<Change> changes;
    for (const ParameterDifference &difference : toRestore(device, file)) {
        const std::string key(device.parameters().parameter(difference.index).key);
        if (!difference.ofAnotherUnit || std::ranges::find(arguments.unitValues, key) != arguments.unitValues.end())
            changes.push_back({difference});
        else
            console.note(key + " belongs to the unit that the file was saved from, left out; --unit-values " + key
                + " writes it as well");
    }
    co_return changes;
}

Task<int> restore(Console &console, RestoreArguments arguments)
{
    const auto target = co_await parseTarget(console, arguments.device);
    const auto source = co_await nameSource(console, arguments, *target.family);
    if (arguments.yes && (!source || source->kind != NamedSettings::Kind::Snapshot))
        co_return fail(Fault::Usage, say("--yes means a snapshot"), say("leave it out"));
    std::optional<ParameterFile> file;
    if (source && source->kind == NamedSettings::Kind::File) {
        auto loaded = parsed(arguments.file, loadSettings(*source, nullptr, {}), *target.family);
        if (!loaded)
            co_return fail(loaded.error());
        file = std::move(*loaded);
    }
    Device *const device = co_await connect(console, target);
    co_await needsApplication(*device);
    console.onlyAsk();
    Notebook notebook(console);
    if (source && !file) {
        const std::string unit = unitKeyOf(*device);
        file = co_await parsed(arguments.file, loadSettings(*source, &notebook, unit), *target.family);
        co_await mayPutBack(console, *device, *notebook.settings(), *source, arguments);
    }
    console.begin();
    std::vector<Change> changes = file ? std::vector<Change>() : lostChanges(*device);
    if (file) {
        co_await leaveOut(*device, *file);
        changes = co_await changesOf(console, *device, *file, arguments);
    }
    std::optional<Error> error;
    if (arguments.dryRun || changes.empty()) {
        co_await noteOwed(console, *device);
    } else {
        error = co_await write(console, *device, notebook, changes);
    }
    show(console, *device, changes,
        !file                      ? "has lost nothing that was written to it from here"
            : !file->notes.empty() ? "has the other values already"
                                   : "has the values already");
    if (!error)
        co_return exitDone;
    co_return console.fails(*error);
}

} // namespace

Job declareRestore(CLI::App &arguments)
{
    const auto a = std::make_shared<RestoreArguments>();
    arguments.add_option("device", a->device, "LINK/FAMILY:ADDRESS")->required();
    arguments.add_option("file", a->file,
        "A file that 'get --file' saved, or snapshot:NAME, snapshot:NUMBER; without it, on boards that keep nothing, "
        "what was last written to them");
    arguments.add_flag("--dry-run", a->dryRun, "Show the difference, write nothing");
    arguments
        .add_option("--unit-values", a->unitValues,
            "Also these keys, which belong to the one unit that the file was saved from: its calibration, its number")
        ->delimiter(',')
        ->expected(1)
        ->allow_extra_args(false);
    arguments.add_flag("--yes", a->yes, "Write a snapshot of this place although it may be of another unit");
    return [a](Console &console) { return restore(console, *a); };
}

} // namespace mb::console
