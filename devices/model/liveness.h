// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/setpoint.h"

#include <optional>
#include <string>
#include <vector>

namespace mb {

/// One of several axes of a device.
struct AxisLiveness {
    std::optional<Mode> mode; ///< as the device reports it, or else as it was told; nothing while it is not known
    bool moving = false;      ///< its output is on, or its shaft turns

    friend bool operator==(const AxisLiveness &, const AxisLiveness &) = default;
};

/// Whether a device is heard, and whether it moves.
struct Liveness {
    bool heard = false;              ///< its telemetry is up to date
    bool moving = false;             ///< its output is on, or its shaft turns
    std::optional<Mode> mode;        ///< as the device reports it
    bool foreignMaster = false;      ///< somebody else sends it control frames
    bool restarted = false;          ///< it was reset or changed its session since it was opened; read it again
    std::vector<std::string> faults; ///< keys of the faults it reports in its telemetry; of an axis: "ch1.glitch"
    std::vector<AxisLiveness> axes;  ///< from axis 1 on; empty where there is only one

    friend bool operator==(const Liveness &, const Liveness &) = default;
};

} // namespace mb
