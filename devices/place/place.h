// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace mb {

/// Which list of the system a name is in: `can0`, `/dev/ttyUSB0`, `/dev/spidev0.0`.
enum class PlaceKind { CanInterface, SerialPort, SpiDevice };

/// The hardware behind a name of today: its place on its bus, with channel, and the serial number of a USB adapter. Begins with a
/// slash; empty where no hardware is known (virtual interfaces, terminals of programs). Reads sysfs; `root` is for tests.
[[nodiscard]] std::string placeOf(PlaceKind kind, const std::string &name, const std::string &root = {});
/// The other way round: what the hardware at a place is called now; empty while it is not there.
[[nodiscard]] std::string nameAt(PlaceKind kind, const std::string &place, const std::string &root = {});

} // namespace mb
