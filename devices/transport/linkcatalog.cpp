// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/linkcatalog.h"

#include "transport/backends/caninterface.h"
#include "transport/backends/qtcanbus.h"
#include "transport/backends/serialports.h"
#include "transport/backends/socketcan.h"

#include <QDir>

#include <unistd.h>

namespace mb {
namespace {

std::string bitrateText(int bitrate)
{
    if (bitrate % 1'000'000 == 0)
        return std::to_string(bitrate / 1'000'000) + " Mbit/s";
    return std::to_string(bitrate / 1000) + " kbit/s";
}

LinkListing listed(const CanInterface &interface)
{
    LinkListing row{{"socketcan", interface.name, {}}, LinkKind::Can, "up", {}, true};
    if (const auto cause = whyUnusable(interface)) {
        row.state = "down";
        row.detail = *cause;
        row.openable = false;
    } else if (interface.driver == "vcan" || interface.driver == "vxcan") {
        row.detail = "virtual";
    } else if (interface.bitrate > 0) {
        row.detail
            = bitrateText(interface.bitrate) + (interface.listenOnly ? ", listen-only: nothing can be sent" : "");
    }
    return row;
}

void listCan(std::vector<LinkListing> &rows)
{
    const LinkListing none{{"socketcan", {}, {}}, LinkKind::Can, "absent", {}, false};
    if (const auto cause = whyNoCan()) {
        rows.push_back(none);
        rows.back().detail = *cause;
        return;
    }
    const auto interfaces = canInterfaces();
    if (interfaces && !interfaces->empty()) {
        for (const CanInterface &interface : *interfaces)
            rows.push_back(listed(interface));
        return;
    }
    rows.push_back(none);
    rows.back().detail = interfaces ? "there is no CAN interface; plug in an adapter" : interfaces.error().detail;
}

LinkListing listedFile(
    const char *scheme, LinkKind kind, const std::string &path, std::string detail, const char *group)
{
    LinkListing row{{scheme, path, {}}, kind, "available", std::move(detail), false};
    if (::access(path.c_str(), R_OK | W_OK) != 0) {
        row.state = "no-permission";
        row.detail
            = "no permission to use " + path + "; become a member of its group: sudo usermod -aG " + group + " $USER";
    } else {
        row.detail += (row.detail.empty() ? "" : "; ") + std::string(toString(kind)) + " links are not supported yet";
    }
    return row;
}

void listSerial(std::vector<LinkListing> &rows)
{
    for (const SerialPort &port : serialPorts())
        rows.push_back(listedFile("serial", LinkKind::Serial, port.path, port.description, "dialout"));
}

void listSpi(std::vector<LinkListing> &rows)
{
    const QDir devices(QStringLiteral("/dev"));
    for (const QString &name : devices.entryList({QStringLiteral("spidev*")}, QDir::System))
        rows.push_back(listedFile("spidev", LinkKind::Spi, devices.filePath(name).toStdString(), {}, "spi"));
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

Result<std::unique_ptr<Link>> createLink(const LinkAddress &address, Clock &clock)
{
    if (address.scheme == "socketcan") {
        if (!address.options.empty())
            return fail(Fault::OutOfRange, "socketcan links have no option '" + address.options.front().first + "'");
        return std::make_unique<SocketCanLink>(address, clock);
    }
    if (address.scheme == "qtcan")
        return makeQtCanLink(address, clock);
    if (address.isSimulated())
        return fail(Fault::Unsupported, "simulated links belong to a bench");
    return fail(Fault::Unsupported, address.scheme + " links are not supported yet");
}

} // namespace mb
