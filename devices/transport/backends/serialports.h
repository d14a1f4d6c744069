// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace mb {

struct SerialPort {
    std::string path;        ///< "/dev/ttyUSB0"
    std::string description; ///< what the USB device calls itself; empty for others
};

/// Serial ports with hardware behind them, by name; none is opened. Read from sysfs, which takes about a millisecond
/// where QSerialPortInfo asks the device manager about every device of the machine.
[[nodiscard]] std::vector<SerialPort> serialPorts(const std::filesystem::path &terminals = "/sys/class/tty");

} // namespace mb
