// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "transport/linkdoctor.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace mb {

struct SerialPort {
    std::string path;    ///< "/dev/ttyUSB0"
    Message description; ///< of a USB device: maker, product, serial number, VID:PID; empty for others
};

/// Serial ports with hardware behind them, by name; none is opened. Read from sysfs, which takes about a millisecond
/// where QSerialPortInfo asks the device manager about every device of the machine.
[[nodiscard]] std::vector<SerialPort> serialPorts(const std::filesystem::path &terminals = "/sys/class/tty");

/// Why the device file cannot be opened by this user, and what helps; nothing when it can be tried. `name`
/// is what the user calls it. Opens nothing.
[[nodiscard]] std::optional<Diagnosis> whyUnusable(const std::string &name, const std::string &path);

} // namespace mb
