// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/backends/serialports.h"

#include "place/firstline.h"

#include <algorithm>
#include <system_error>

#include <grp.h>
#include <sys/stat.h>
#include <unistd.h>

namespace mb {
namespace {

namespace fs = std::filesystem;

/// A built-in UART reserves more names than it has ports; the driver knows type 0 of those.
bool hasHardware(const fs::path &terminal)
{
    std::error_code ignored;
    return fs::exists(terminal / "device", ignored) && firstLine(terminal / "type") != "0";
}

/// USB devices keep their texts a few folders above the port.
Message descriptionOf(const fs::path &terminal)
{
    std::error_code failed;
    fs::path folder = fs::canonical(terminal / "device", failed);
    for (int level = 0; !failed && level < 4; ++level, folder = folder.parent_path()) {
        if (firstLine(folder / "product").empty() && firstLine(folder / "idVendor").empty())
            continue;
        const std::string maker = firstLine(folder / "manufacturer");
        const std::string product = firstLine(folder / "product");
        Message text = Message::verbatim(maker.empty() || product.empty() ? maker + product : maker + ' ' + product);
        const auto add = [&text](const Message &part) { text = text.empty() ? part : say("%1, %2", text, part); };
        if (const std::string serial = firstLine(folder / "serial"); !serial.empty())
            add(say("serial number %1", serial));
        if (const std::string vendor = firstLine(folder / "idVendor"); !vendor.empty())
            add(Message::verbatim(vendor + ':' + firstLine(folder / "idProduct")));
        return text;
    }
    return {};
}

std::string groupOf(const std::string &path)
{
    struct stat file { };
    if (::stat(path.c_str(), &file) != 0)
        return "dialout";
    const struct group *owner = ::getgrgid(file.st_gid);
    return owner && file.st_gid != 0 ? owner->gr_name : "dialout";
}

} // namespace

std::vector<SerialPort> serialPorts(const fs::path &terminals)
{
    std::vector<SerialPort> ports;
    std::error_code failed;
    for (fs::directory_iterator entry(terminals, failed), end; !failed && entry != end; entry.increment(failed)) {
        if (hasHardware(entry->path()))
            ports.push_back({"/dev/" + entry->path().filename().string(), descriptionOf(entry->path())});
    }
    std::ranges::sort(ports, [](const SerialPort &a, const SerialPort &b) { return a.path < b.path; });
    return ports;
}

std::optional<Diagnosis> whyUnusable(const std::string &name, const std::string &path)
{
    struct stat file { };
    if (::stat(path.c_str(), &file) != 0)
        return Diagnosis{
            Ailment::NotThere, say("there is no %1", name), say("plug in the adapter, or name another port"), {}};
    if (!S_ISCHR(file.st_mode))
        return Diagnosis{Ailment::Failed, say("%1 is no serial port", name), say("name one such as /dev/ttyUSB0"), {}};
    if (::access(path.c_str(), R_OK | W_OK) != 0)
        return Diagnosis{Ailment::NoPermission, say("no permission to use %1", name),
            say("become a member of its group"), "sudo usermod -aG " + groupOf(path) + " $USER"};
    return std::nullopt;
}

} // namespace mb
