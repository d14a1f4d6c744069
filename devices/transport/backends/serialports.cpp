// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/backends/serialports.h"

#include <algorithm>
#include <fstream>
#include <system_error>

namespace mb {
namespace {

namespace fs = std::filesystem;

std::string firstLine(const fs::path &file)
{
    std::ifstream stream(file);
    std::string line;
    std::getline(stream, line);
    return line;
}

/// A built-in UART reserves more names than it has ports; the driver knows type 0 of those.
bool hasHardware(const fs::path &terminal)
{
    std::error_code ignored;
    return fs::exists(terminal / "device", ignored) && firstLine(terminal / "type") != "0";
}

/// USB devices keep their texts a few folders above the port.
std::string descriptionOf(const fs::path &terminal)
{
    std::error_code failed;
    fs::path folder = fs::canonical(terminal / "device", failed);
    for (int level = 0; !failed && level < 4; ++level, folder = folder.parent_path()) {
        const std::string product = firstLine(folder / "product");
        if (product.empty())
            continue;
        const std::string maker = firstLine(folder / "manufacturer");
        return maker.empty() ? product : maker + " " + product;
    }
    return {};
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
    std::sort(ports.begin(), ports.end(), [](const SerialPort &a, const SerialPort &b) { return a.path < b.path; });
    return ports;
}

} // namespace mb
