// SPDX-License-Identifier: GPL-3.0-or-later
#include "place/place.h"

#include "place/firstline.h"

#include <filesystem>

namespace mb {
namespace {

namespace fs = std::filesystem;

fs::path realPath(const fs::path &path)
{
    std::error_code failed;
    const fs::path real = fs::canonical(path, failed);
    return failed ? fs::path() : real;
}

/// With `absolute` below the root of a test.
fs::path below(const std::string &root, const fs::path &absolute)
{
    return root.empty() ? absolute : fs::path(root) / absolute.relative_path();
}

const char *listOf(PlaceKind kind)
{
    switch (kind) {
    case PlaceKind::CanInterface: return "/sys/class/net";
    case PlaceKind::SerialPort: return "/sys/class/tty";
    case PlaceKind::SpiDevice: return "/sys/class/spidev";
    }
    return "";
}

/// Of the USB device that this one belongs to; empty elsewhere.
std::string usbSerial(fs::path device)
{
    for (; device.has_relative_path(); device = device.parent_path()) {
        std::error_code failed;
        if (fs::exists(device / "idVendor", failed))
            return firstLine(device / "serial");
    }
    return {};
}

fs::path deviceOf(const fs::path &row)
{
    const fs::path device = realPath(row / "device");
    return device.filename() == row.filename() ? device.parent_path() : device; // ttyUSB0 once more: the name of today
}

/// Which of several ports of one driver this row is; empty for the first of a USB interface and where there is only one: files are
/// kept under what those were called before.
std::string portOf(const fs::path &row, const fs::path &device)
{
    if (const std::string number = firstLine(row / "device" / "port_number"); !number.empty())
        return number == "0" ? std::string() : number;
    std::string base = firstLine(row / "port");
    if (base == "0x0")
        base = firstLine(row / "iomem_base");
    if (base.empty())
        return {};
    std::error_code failed;
    for (const auto &other : fs::directory_iterator(row.parent_path(), failed)) {
        if (other.path().filename() != row.filename() && deviceOf(other.path()) == device)
            return base;
    }
    return {};
}

/// Of a row of the list, such as /sys/class/net/can0.
std::string placeOfRow(const fs::path &row, const std::string &root)
{
    const fs::path device = deviceOf(row);
    if (device.empty())
        return {};
    const std::string top = root.empty() ? std::string() : realPath(root).string();
    std::string place = device.string().substr(top.size());
    for (const char *channel : {"dev_id", "dev_port"}) { // several channels of one adapter
        if (const std::string number = firstLine(row / channel); !number.empty())
            place += '/' + number;
    }
    if (const std::string port = portOf(row, device); !port.empty())
        place += '/' + port;
    if (const std::string serial = usbSerial(device); !serial.empty())
        place += '#' + serial;
    return place;
}

} // namespace

std::string placeOf(PlaceKind kind, const std::string &name, const std::string &root)
{
    if (kind == PlaceKind::CanInterface)
        return placeOfRow(below(root, listOf(kind)) / name, root);
    const fs::path node = name.find('/') == std::string::npos ? fs::path("/dev") / name : fs::path(name);
    const fs::path real = realPath(node.is_absolute() ? below(root, node) : node);
    return real.empty() ? std::string() : placeOfRow(below(root, listOf(kind)) / real.filename(), root);
}

std::string nameAt(PlaceKind kind, const std::string &place, const std::string &root)
{
    std::error_code failed;
    const std::string top = root.empty() ? std::string() : realPath(root).string();
    for (const auto &row : fs::directory_iterator(below(root, listOf(kind)), failed)) {
        const fs::path device = deviceOf(row.path()); // cheap; most rows are of other hardware
        if (!device.empty() && (top + place).starts_with(device.string()) && placeOfRow(row.path(), root) == place)
            return (kind == PlaceKind::CanInterface ? "" : "/dev/") + row.path().filename().string();
    }
    return {};
}

} // namespace mb
