// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/linkcatalog.h"

#include "transport/backends/caninterface.h"
#include "transport/backends/cansocket.h"
#include "transport/backends/qtcanbus.h"
#include "transport/backends/replay.h"
#include "transport/backends/serialport.h"
#include "transport/backends/serialports.h"
#include "transport/backends/socketcan.h"
#include "transport/backends/spidev.h"
#include "transport/backends/unixspi.h"

#include <QDir>

#include <cmath>

#include <unistd.h>

namespace mb {
namespace {

Message describe(const CanInterface &interface)
{
    if (interface.kind == CanInterface::Kind::Virtual)
        return say("virtual");
    Message text = Message::verbatim(interface.driver);
    const auto add = [&text](const Message &part) { text = text.empty() ? part : say("%1, %2", text, part); };
    if (interface.bitrate > 0)
        add(Message::verbatim(bitrateText(interface.bitrate)));
    if (interface.samplePoint > 0.0)
        add(say("sample point %1 %", std::round(interface.samplePoint * 1000.0) / 10.0));
    if (interface.listenOnly)
        add(say("listen-only: nothing can be sent"));
    if (interface.state == BusState::Warning)
        add(say("error-warning"));
    else if (interface.state == BusState::Passive)
        add(say("error-passive"));
    else if (interface.state == BusState::BusOff)
        add(say("bus-off"));
    return text;
}

} // namespace

std::string_view toString(ListingState state)
{
    switch (state) {
    case ListingState::Up: return "up";
    case ListingState::Down: return "down";
    case ListingState::BusOff: return "bus-off";
    case ListingState::NoPermission: return "no-permission";
    case ListingState::Absent: return "absent";
    case ListingState::Available: return "available";
    case ListingState::Open: return "open";
    case ListingState::Lost: return "lost";
    }
    return "";
}

LinkListing listed(const CanInterface &interface)
{
    LinkListing row{
        {"socketcan", interface.name, {}}, LinkKind::Can, ListingState::Up, describe(interface), true, {}, false};
    row.listenable = interface.canListenOnly;
    row.diagnosis = diagnose(interface);
    if (!row.diagnosis.isHealthy()) {
        row.state = row.diagnosis.ailment == Ailment::BusOff ? ListingState::BusOff : ListingState::Down;
        row.detail = row.diagnosis.message();
        row.openable = false;
    }
    return row;
}

namespace {

LinkListing absentCan(const Diagnosis &cause)
{
    const ListingState state
        = cause.ailment == Ailment::NoPermission ? ListingState::NoPermission : ListingState::Absent;
    return {{"socketcan", {}, {}}, LinkKind::Can, state, cause.message(), false, cause, false};
}

void listCan(std::vector<LinkListing> &rows)
{
    if (const auto cause = whyNoCan()) {
        rows.push_back(absentCan(*cause));
        return;
    }
    const auto interfaces = canInterfaces();
    if (!interfaces)
        rows.push_back(absentCan({Ailment::Failed, interfaces.error().detail, {}, {}}));
    else if (interfaces->empty())
        rows.push_back(absentCan({Ailment::NotThere, say("there is no CAN interface"), say("plug in an adapter"), {}}));
    for (const CanInterface &interface : interfaces.value_or(std::vector<CanInterface>{}))
        rows.push_back(listed(interface));
}

LinkListing listedSpi(const std::string &path)
{
    LinkListing row{{"spidev", path, {}}, LinkKind::Spi, ListingState::Available, {}, true, {}, false};
    if (::access(path.c_str(), R_OK | W_OK) != 0) {
        row.state = ListingState::NoPermission;
        row.diagnosis = {Ailment::NoPermission, say("no permission to use %1", path),
            say("become a member of its group"), "sudo usermod -aG spi $USER"};
        row.detail = row.diagnosis.message();
        row.openable = false;
    }
    return row;
}

void listSerial(std::vector<LinkListing> &rows)
{
    for (const SerialPort &port : serialPorts()) {
        rows.push_back(
            {{"serial", port.path, {}}, LinkKind::Serial, ListingState::Available, port.description, true, {}, false});
        if (auto cause = whyUnusable(port.path, port.path)) {
            rows.back().state = ListingState::NoPermission;
            rows.back().detail = cause->message();
            rows.back().diagnosis = std::move(*cause);
            rows.back().openable = false;
        }
    }
}

void listSpi(std::vector<LinkListing> &rows)
{
    const QDir devices(QStringLiteral("/dev"));
    for (const QString &name : devices.entryList({QStringLiteral("spidev*")}, QDir::System))
        rows.push_back(listedSpi(devices.filePath(name).toStdString()));
}

} // namespace

std::vector<LinkListing> listLinks()
{
    std::vector<LinkListing> rows;
    listCan(rows);
    listSerial(rows);
    listSpi(rows);
    return rows;
}

std::vector<LinkListing> listPluginLinks()
{
    std::vector<LinkListing> rows;
    for (const QtCanAdapter &adapter : qtCanAdapters()) {
        LinkListing row{
            {"qtcan", adapter.path, {}}, LinkKind::Can, ListingState::Available, adapter.description, true, {}, false};
        if (!adapter.missing.empty()) {
            row.diagnosis = {Ailment::NotThere, adapter.missing, adapter.remedy, {}};
            row.state = ListingState::Absent;
            row.detail = row.diagnosis.message();
            row.openable = false;
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

Diagnosis diagnose(const LinkSymptoms &link, Instant now, const std::vector<LinkListing> &listings)
{
    for (const LinkListing &row : listings) {
        const bool none
            = row.link.path.empty() && row.link.scheme == link.scheme && row.diagnosis.ailment != Ailment::NotThere;
        if (none || (row.link.scheme == link.scheme && row.link.shortName() == link.name))
            return diagnose(link, now, row.diagnosis, row.listenable);
    }
    return diagnose(link, now, std::nullopt, false);
}

Result<std::unique_ptr<Link>> createLink(const LinkAddress &address, Clock &clock)
{
    if (address.scheme == "socketcan") {
        if (!address.options.empty())
            return fail(Fault::OutOfRange, say("socketcan links have no option '%1'", address.options.front().first));
        return std::make_unique<SocketCanLink>(address, clock);
    }
    if (address.scheme == "qtcan")
        return makeQtCanLink(address, clock);
    if (address.isRecording())
        return ReplayLink::create(address, clock);
    if (address.scheme == "serial")
        return makeSerialPortLink(address, clock);
    if (address.scheme == "pty")
        return fail(Fault::OutOfRange, say("pty: is where 'simulate' puts its devices"),
            say("open that terminal as serial:%1", address.path));
    if (address.scheme == "spidev")
        return SpidevLink::make(address, clock);
    if (address.scheme == "unix") {
        if (!address.options.empty())
            return fail(Fault::OutOfRange, say("unix links have no option '%1'", address.options.front().first));
        return std::make_unique<UnixSpiLink>(address, clock);
    }
    if (address.isSimulated())
        return fail(Fault::Unsupported, say("simulated links belong to a bench"));
    return fail(Fault::Unsupported, say("%1 links are not supported yet", address.scheme));
}

} // namespace mb
