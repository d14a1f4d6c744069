// SPDX-License-Identifier: GPL-3.0-or-later
#include "settings/snapshots.h"
#include "app/console/notebook.h"
#include "app/console/progressline.h"
#include "app/console/table.h"
#include "app/console/target.h"
#include "app/console/verb.h"
#include "model/unit.h"
#include "storage/unittags.h"

#include <QDateTime>
#include <QJsonArray>

#include <cmath>
#include <memory>
#include <optional>

namespace mb::console {
namespace {

using settings::ParameterSnapshot;

constexpr std::size_t longestName = 200;

QJsonObject snapshotToJson(const ParameterSnapshot &snapshot)
{
    return {
        {QStringLiteral("snapshot"), static_cast<qint64>(snapshot.number)},
        {QStringLiteral("device"), qt(snapshot.device)},
        {QStringLiteral("serial"), textOrNull(snapshot.serial)},
        {QStringLiteral("name"), qt(snapshot.name)},
        {QStringLiteral("time"), snapshot.time},
        {QStringLiteral("count"), snapshot.count},
    };
}

std::string timeOf(const ParameterSnapshot &snapshot)
{
    return QDateTime::fromMSecsSinceEpoch(std::llround(snapshot.time * 1e3)).toString(Qt::ISODate).toStdString();
}

/// What there is to say of the unit for people.
std::string whose(const ParameterSnapshot &snapshot)
{
    const std::string_view caveat = unitCaveatOf(unitByOf(snapshot.unit));
    const std::string_view tag = unitTagIn(snapshot.unit);
    if (!tag.empty())
        return std::string(tag);
    return caveat.empty() ? snapshot.serial : std::string(caveat);
}

Task<int> snapshot(Console &console, std::string device, std::string name)
{
    const auto target = co_await parseTarget(console, device);
    if (name.size() > longestName)
        co_return fail(Fault::Usage, say("--name: a name has at most %1 bytes", longestName));
    co_await checkName("a name", name);
    bool isNumber = false;
    (void)qt(name).toLongLong(&isNumber);
    if (isNumber)
        co_return fail(
            Fault::Usage, say("--name: %1 would be taken for the number of a snapshot", name), say("add a word to it"));
    Notebook notebook(console);
    if (notebook.trouble())
        co_return fail(*notebook.trouble());
    Device *const found = co_await connect(console, target);
    co_await needsApplication(*found);
    co_await noteOwed(console, *found);
    ProgressLine progress(console);
    auto taking = settings::takeSnapshot(*found, settings::Occasion::Hand, name, *notebook.settings(), progress);
    const ParameterSnapshot taken = co_await std::move(taking);
    if (console.json())
        console.out().json(snapshotToJson(taken));
    else
        console.out().line("snapshot " + std::to_string(taken.number) + ", " + taken.name + ": "
            + std::to_string(taken.count) + " values of " + taken.device
            + (whose(taken).empty() ? "" : ", " + whose(taken)));
    co_return exitDone;
}

Task<int> snapshots(Console &console, std::string device)
{
    std::optional<Target> target;
    if (!device.empty()) {
        target = co_await parseTarget(console, device);
    }
    Notebook notebook(console);
    if (notebook.trouble())
        co_return fail(*notebook.trouble());
    auto all = co_await notebook.settings()->snapshots();
    if (target) {
        const auto units = unitsAt(notebook.database(), target->selector);
        std::erase_if(all, [&units](const ParameterSnapshot &each) { return !units.contains(each.unit); });
    }
    QJsonArray rows;
    Table table({"SNAPSHOT", "TIME", "SERIAL", "DEVICE", "NAME", "VALUES"});
    for (const ParameterSnapshot &each : all) {
        rows.append(snapshotToJson(each));
        table.add({std::to_string(each.number), timeOf(each), whose(each), each.device, each.name,
            std::to_string(each.count)});
    }
    if (console.json())
        console.out().json({{QStringLiteral("snapshots"), rows}});
    else if (all.empty())
        console.out().line(target
                ? "none is kept of what was seen at " + device + "; 'motorbenchctl snapshots' lists all"
                : "none is kept; 'motorbenchctl snapshot DEVICE' takes one");
    else
        table.print(console.out());
    co_return exitDone;
}

} // namespace

Job declareSnapshot(CLI::App &arguments)
{
    const auto device = std::make_shared<std::string>();
    const auto name = std::make_shared<std::string>();
    arguments.add_option("device", *device, "LINK/FAMILY:ADDRESS")->required();
    arguments.add_option("--name", *name, "What it is called; \"by hand\" otherwise");
    return [device, name](Console &console) { return snapshot(console, *device, *name); };
}

Job declareSnapshots(CLI::App &arguments)
{
    const auto device = std::make_shared<std::string>();
    arguments.add_option("device", *device, "LINK/FAMILY:ADDRESS: units that were seen there; all otherwise");
    return [device](Console &console) { return snapshots(console, *device); };
}

} // namespace mb::console
