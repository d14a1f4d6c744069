// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/result.h"
#include "wire/canerror.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace mb {

/// A CAN network interface as the kernel describes it (rtnetlink, and the adapter's name from sysfs).
struct CanInterface {
    enum class Kind {
        Virtual,    ///< vcan, vxcan: frames pass in memory
        Controller, ///< a CAN controller
        SerialLine, ///< slcan: an adapter that speaks text on a serial port
        Other,
    };
    int index = 0;
    std::string name;
    Kind kind = Kind::Other;
    std::string driver;       ///< "gs_usb", "vcan"; empty when the kernel does not say
    int bitrate = 0;          ///< bit/s; 0 when not configured or without meaning
    double samplePoint = 0.0; ///< fraction of the bit; 0 when the kernel does not tell
    bool up = false;
    BusState state = BusState::Active;
    std::optional<int> transmitErrors; ///< error counters of the controller, where it tells
    std::optional<int> receiveErrors;
    bool listenOnly = false;    ///< frames sent are dropped by the driver
    bool canListenOnly = false; ///< the controller has that mode
    bool restarts = false;      ///< comes back from bus-off by itself
    std::uint64_t overruns = 0; ///< frames lost in the controller, since the interface exists
    std::uint64_t dropped = 0;  ///< frames that its driver, or the kernel on the way from or to it, dropped
};

/// What the kernel's description of an interface (RTM_NEWLINK, from its ifinfomsg on) says; nothing when it is none of CAN.
[[nodiscard]] std::optional<CanInterface> canInterfaceFrom(std::span<const std::byte> message);
/// All of them, in the kernel's order. Fails with LinkLost when the kernel cannot be asked.
[[nodiscard]] Result<std::vector<CanInterface>> canInterfaces();
/// One of them; nothing when it is gone. Some ten microseconds.
[[nodiscard]] std::optional<CanInterface> canInterface(int index);

} // namespace mb
