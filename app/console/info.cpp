// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/table.h"
#include "app/console/target.h"
#include "app/console/verb.h"
#include "transport/canlink.h"
#include "transport/linkcatalog.h"

#include <cmath>
#include <memory>

namespace mb::console {
namespace {

using Faults = std::optional<std::vector<FaultRecord>>;

QJsonObject toJson(const std::vector<FaultRecord> &faults)
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

QJsonObject toJson(const LinkCounters &counters)
{
    return {
        {QStringLiteral("rx"), static_cast<qint64>(counters.rx)},
        {QStringLiteral("tx"), static_cast<qint64>(counters.tx)},
        {QStringLiteral("lost"), static_cast<qint64>(counters.lost)},
        {QStringLiteral("errors"), static_cast<qint64>(counters.errors)},
    };
}

void printJson(Console &console, const Device &device, const Faults &faults)
{
    QJsonObject object = scanRow(device);
    QJsonObject descriptors;
    for (const auto &[key, text] : device.identity().descriptors)
        descriptors.insert(qt(key), qt(text));
    object.insert(QStringLiteral("descriptors"), descriptors);
    object.insert(QStringLiteral("faults"), faults ? QJsonValue(toJson(*faults)) : QJsonValue());
    object.insert(QStringLiteral("counters"), toJson(device.link().counters()));
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
    table.add({"bus", bus + ", load " + numberText(std::round(link.load(console.clock().now()) * 100)) + " %"});
    if (health.lastError)
        table.add({"last error", describe(health.last)});
    const auto found = diagnose(symptomsOf(link, console.clock().now()), console.clock().now(), listLinks());
    if (!found.isHealthy())
        table.add({"link", found.text()});
}

void printText(Console &console, const Device &device, const Faults &faults)
{
    const Identity &identity = device.identity();
    Table table({"DEVICE", device.selector()});
    table.add({"state", std::string(toString(identity.state))});
    if (identity.session)
        table.add({"session", std::to_string(*identity.session)});
    table.add({"name", identity.name});
    table.add({"serial", identity.serial});
    table.add({"firmware", identity.firmware});
    table.add({"bootloader", identity.bootloader});
    if (!identity.dialect.empty())
        table.add({"dialect", identity.dialect});
    if (!identity.detail.empty())
        table.add({"detail", identity.detail});
    for (const auto &[key, text] : identity.descriptors)
        table.add({key, text});
    for (const FaultRecord &fault : faults.value_or(std::vector<FaultRecord>{}))
        table.add({"fault " + fault.key, describe(fault)});
    const LinkCounters &counters = device.link().counters();
    table.add({"link frames",
        std::to_string(counters.rx) + " received, " + std::to_string(counters.tx) + " sent, "
            + std::to_string(counters.lost) + " lost, " + std::to_string(counters.errors) + " errors"});
    if (device.link().kind() == LinkKind::Can)
        addBus(table, console, static_cast<const CanLink &>(device.link()));
    table.print(console.out());
}

Task<int> info(Console &console, std::string text)
{
    const auto target = parseTarget(console, text);
    if (!target)
        co_return fail(target.error());
    auto connecting = connect(console, *target);
    Device *const device = co_await std::move(connecting);
    const bool recorded = device->link().address().isRecording(); // then there is nobody to ask
    if (!recorded) {
        auto refreshing = device->refresh();
        co_await std::move(refreshing);
    }
    Faults faults;
    if (!recorded && device->identity().state != DeviceState::Bootloader) {
        auto reading = device->readFaults();
        faults = co_await std::move(reading);
    }
    device->link().recount();
    if (console.json())
        printJson(console, *device, faults);
    else
        printText(console, *device, faults);
    co_return exitDone;
}

} // namespace

Job declareInfo(CLI::App &arguments)
{
    const auto device = std::make_shared<std::string>();
    arguments.add_option("device", *device, "LINK/FAMILY:ADDRESS")->required();
    return [device](Console &console) { return info(console, *device); };
}

} // namespace mb::console
