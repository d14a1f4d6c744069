// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/notebook.h"
#include "app/console/pace.h"
#include "app/console/table.h"
#include "app/console/target.h"
#include "app/console/verb.h"
#include "app/folders/userfolders.h"
#include "async/sleep.h"
#include "transport/canlink.h"
#include "transport/linkcatalog.h"

#include <QFile>

#include <algorithm>
#include <cmath>
#include <memory>

namespace mb::console {
namespace {

using namespace std::chrono_literals;

constexpr Duration statesLimit = 300ms;

using Faults = std::optional<std::vector<FaultRecord>>;

QJsonObject faultsToJson(const std::vector<FaultRecord> &faults)
{
    QJsonObject object;
    for (const FaultRecord &fault : faults) {
        object.insert(qt(fault.key),
            QJsonObject{
                {QStringLiteral("active"), fault.active},
                {QStringLiteral("sticky"), fault.sticky},
                {QStringLiteral("count"), fault.count ? QJsonValue(static_cast<qint64>(*fault.count)) : QJsonValue()},
            });
    }
    return object;
}

QJsonObject countersToJson(const LinkCounters &counters)
{
    return {
        {QStringLiteral("rx"), static_cast<qint64>(counters.rx)},
        {QStringLiteral("tx"), static_cast<qint64>(counters.tx)},
        {QStringLiteral("lost"), static_cast<qint64>(counters.lost)},
        {QStringLiteral("errors"), static_cast<qint64>(counters.errors)},
    };
}

/// What the device tells of itself, by the rows of its family.
QJsonObject statesOf(const Device &device)
{
    QJsonObject object;
    for (std::size_t i = 0; i < device.family().states.size(); ++i) {
        const auto on = device.states()[{static_cast<std::uint16_t>(i)}];
        object.insert(qt(device.family().states[i].key), on ? QJsonValue(*on) : QJsonValue());
    }
    return object;
}

bool areAllTold(const Device &device)
{
    for (std::size_t i = 0; i < device.family().states.size(); ++i) {
        if (!device.states()[{static_cast<std::uint16_t>(i)}])
            return false;
    }
    return true;
}

/// They come with telemetry, at its own pace.
Task<void> awaitStates(Console &console, const Device &device)
{
    const Instant limit = console.clock().now() + statesLimit;
    while (!areAllTold(device) && console.clock().now() < limit && device.link().state() == LinkState::Open)
        co_await Sleep(console.clock(), lookEvery);
    co_return {};
}

void printJson(Console &console, const Device &device, const std::string &name, const Faults &faults)
{
    QJsonObject object = scanRow(device, name);
    QJsonObject descriptors;
    for (const auto &[key, text] : device.identity().descriptors)
        descriptors.insert(qt(key), qt(text));
    for (const auto &[key, number] : device.knowledge().profile().calibration)
        descriptors.insert(qt(key), qt(numberText(number)));
    object.insert(QStringLiteral("descriptors"), descriptors);
    object.insert(QStringLiteral("faults"), faults ? QJsonValue(faultsToJson(*faults)) : QJsonValue());
    object.insert(QStringLiteral("states"), statesOf(device));
    object.insert(QStringLiteral("counters"), countersToJson(device.link().counters()));
    console.out().json(object);
}

std::string describe(const FaultRecord &fault)
{
    std::string text = fault.active ? "active" : fault.sticky ? "seen since it was cleared" : "none";
    if (fault.count)
        text += ", counted " + std::to_string(*fault.count);
    return text;
}

void addBus(Table &table, Console &console, const CanLink &link)
{
    const BusHealth &health = link.health();
    std::string bus(toString(health.state));
    if (health.transmitErrors && health.receiveErrors)
        bus += ", " + std::to_string(*health.transmitErrors) + " transmit and " + std::to_string(*health.receiveErrors)
            + " receive errors";
    if (const auto load = link.load(console.clock().now()))
        bus += ", load " + numberText(std::round(*load * 100)) + " %";
    table.add({"bus", bus});
    if (health.lastError)
        table.add({"last error", describe(health.last).english()});
    const auto found = diagnose(symptomsOf(link, console.clock().now()), console.clock().now(), listLinks());
    if (!found.isHealthy())
        table.add({"link", found.text()});
}

/// A choice that nobody made is the first.
std::string calibrationText(const Device &device, const Calibration &row)
{
    const double known = device.knowledge().profile().calibrated(row.key);
    if (row.choices.empty())
        return known > 0.0 ? numberText(known) : "unknown; keep it with --keep";
    std::string text;
    for (const Choice &choice : row.choices) {
        if (static_cast<double>(choice.raw) == known || text.empty())
            text = numberText(static_cast<double>(choice.raw)) + " (" + std::string(choice.label) + ')';
    }
    return text + "; another with --keep";
}

void printText(Console &console, const Device &device, const std::string &name, const Faults &faults,
    const std::vector<std::string> &owed)
{
    const Identity &identity = device.identity();
    Table table({"DEVICE", device.selector()});
    table.add({"state", std::string(toString(identity.state))});
    if (identity.session)
        table.add({"session", std::to_string(*identity.session)});
    table.add({"name", name});
    table.add({"serial", identity.serial});
    table.add({"firmware", identity.firmware});
    table.add({"bootloader", identity.bootloader});
    if (!identity.dialect.empty())
        table.add({"dialect", identity.dialect});
    if (!identity.detail.empty())
        table.add({"detail", identity.detail.english()});
    for (const auto &[key, text] : identity.descriptors)
        table.add({key, text});
    for (const Calibration &row : device.family().calibrations) {
        table.add({std::string(row.key), calibrationText(device, row)});
    }
    for (const FaultRecord &fault : faults.value_or(std::vector<FaultRecord>{}))
        table.add({"fault " + fault.key, describe(fault)});
    for (const std::string &line : owed)
        table.add({"owed", line});
    for (const StateRow *const condition : conditionsOf(device.family().states, device.states()))
        table.add({"now", std::string(condition->clause)});
    for (std::size_t i = 0; i < device.family().states.size(); ++i) {
        const auto on = device.states()[{static_cast<std::uint16_t>(i)}];
        table.add({std::string(device.family().states[i].key), !on ? "not told" : *on ? "on" : "off"});
    }
    const LinkCounters &counters = device.link().counters();
    table.add({"link frames",
        std::to_string(counters.rx) + " received, " + std::to_string(counters.tx) + " sent, "
            + std::to_string(counters.lost) + " lost, " + std::to_string(counters.errors) + " errors"});
    if (device.link().kind() == LinkKind::Can)
        addBus(table, console, static_cast<const CanLink &>(device.link()));
    table.print(console.out());
}

struct FactsArguments {
    std::string device;
    std::vector<std::string> keep;
};

/// Something to be kept of the device: its dialect or one of its calibrations.
struct Kept {
    std::string key;
    std::string text;
    std::optional<double> number;
};

std::vector<std::string_view> dialectsOf(const Family &family)
{
    std::vector<std::string_view> keys;
    for (const DialectChoice &row : family.dialects)
        keys.push_back(row.key);
    return keys;
}

Result<Kept> parseKept(const Family &family, const std::string &text)
{
    const auto equals = text.find('=');
    if (equals == std::string::npos || equals == 0)
        return fail(Fault::Usage, say("'%1' is not KEY=VALUE", text), say("write it like counts_per_revolution=4096"));
    Kept kept{text.substr(0, equals), text.substr(equals + 1), {}};
    std::vector<std::string_view> known;
    if (!family.dialects.empty())
        known.emplace_back("dialect");
    for (const Calibration &row : family.calibrations)
        known.push_back(row.key);
    if (std::ranges::find(known, kept.key) == known.end())
        return fail(known.empty() ? Fault::Unsupported : Fault::Usage,
            say("%1 has no '%2' to keep", family.key, kept.key),
            suggestion(kept.key, known, known.empty() ? "leave --keep out" : "it has " + joined(known)));
    const std::vector<std::string_view> dialects = dialectsOf(family);
    if (kept.key == "dialect" && !kept.text.empty() && std::ranges::find(dialects, kept.text) == dialects.end())
        return fail(
            Fault::Usage, say("%1 has no dialect '%2'", family.key, kept.text), say("it has %1", joined(dialects)));
    if (kept.key == "dialect" || kept.text.empty())
        return kept;
    const auto row = std::ranges::find_if(
        family.calibrations, [&](const Calibration &candidate) { return candidate.key == kept.key; });
    MB_TRY(const auto number, parseNumber(kept.key, kept.text, row->minimum, row->maximum));
    kept.number = number;
    return kept;
}

Result<std::vector<Kept>> parseAll(const Family &family, const std::vector<std::string> &texts)
{
    std::vector<Kept> all;
    for (const std::string &text : texts) {
        MB_TRY(auto kept, parseKept(family, text));
        all.push_back(std::move(kept));
    }
    return all;
}

/// Refused where it is in force for this program only.
Result<void> keep(Console &console, Device &device, const std::vector<Kept> &all)
{
    bool isOnDisk = true;
    const Subscription watching
        = console.session().memory().profileTrouble().add([&isOnDisk](const Message &) { isOnDisk = false; });
    for (const Kept &kept : all) {
        const auto done = kept.key == "dialect" ? device.knowledge().setDialect(kept.text)
                                                : device.knowledge().calibrate(kept.key, kept.number);
        if (!done)
            return done;
        if (kept.key == "dialect" && !kept.text.empty())
            console.note(device.identity().detail.english());
    }
    if (!isOnDisk)
        return fail(Fault::NotKept, say("nothing was kept"), say("see to the folder's rights and room"));
    return {};
}

Task<int> info(Console &console, FactsArguments arguments)
{
    auto target = co_await parseTarget(console, arguments.device);
    target.mayBeSilent = target.family->capabilities.bootloaderElsewhere;
    const auto kept = co_await parseAll(*target.family, arguments.keep);
    Device *const device = co_await connect(console, target);
    co_await keep(console, *device, kept);
    const bool recorded = device->link().address().isRecording(); // then there is nobody to ask
    if (!recorded)
        co_await device->refresh();
    Faults faults;
    if (!recorded && device->identity().state != DeviceState::Bootloader) {
        faults = co_await device->readFaults();
    }
    if (!recorded && device->identity().state == DeviceState::Online)
        co_await awaitStates(console, *device);
    const std::vector<std::string> owed = co_await owedLines(console, *device);
    device->link().recount();
    const std::string name = UnitNames(console).of(*device);
    if (!console.json()) {
        printText(console, *device, name, faults, owed);
        co_return exitDone;
    }
    for (const std::string &line : owed)
        console.note(line);
    printJson(console, *device, name, faults);
    co_return exitDone;
}

} // namespace

Job declareInfo(CLI::App &arguments)
{
    const auto a = std::make_shared<FactsArguments>();
    arguments.add_option("device", a->device, "LINK/FAMILY:ADDRESS")->required();
    arguments
        .add_option("--keep", a->keep,
            "KEY=VALUE that only its user knows, kept for this device: dialect, counts_per_revolution …; KEY= forgets "
            "it")
        ->allow_extra_args(false);
    return [a](Console &console) { return info(console, *a); };
}

} // namespace mb::console
