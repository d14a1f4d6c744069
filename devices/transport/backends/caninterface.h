// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/result.h"

#include <optional>
#include <string>
#include <vector>

namespace mb {

/// A CAN network interface as the kernel describes it (rtnetlink).
struct CanInterface {
    std::string name;
    std::string driver; ///< "can" for controllers, "vcan", "vxcan"; empty when the kernel does not say
    int bitrate = 0;    ///< bit/s; 0 when not configured or without meaning
    bool up = false;
    bool busOff = false;
    bool listenOnly = false; ///< frames sent are dropped by the driver
};

/// All of them, in the kernel's order. Fails with LinkLost when the kernel cannot be asked.
[[nodiscard]] Result<std::vector<CanInterface>> canInterfaces();

/// Why the interface cannot be used, and the command that helps, in one clause; nothing when it can.
[[nodiscard]] std::optional<std::string> whyUnusable(const CanInterface &interface);

/// Nothing when the kernel has CAN sockets, else the clause that says so and what helps.
[[nodiscard]] std::optional<std::string> whyNoCan();

} // namespace mb
