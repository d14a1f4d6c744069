// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"
#include "model/stopscript.h"
#include "transport/link.h"

#include <string>

namespace mb {

/// What DeviceGuard and DeviceStop need of a device, and all that they know of it. Engine thread.
class Stoppable {
public:
    [[nodiscard]] virtual Link &link() const = 0;
    [[nodiscard]] virtual Clock &clock() const = 0;
    [[nodiscard]] virtual std::string selector() const = 0;
    /// Capabilities::watchdog.
    [[nodiscard]] virtual bool hasWatchdog() const = 0;
    /// Its telemetry is up to date.
    [[nodiscard]] virtual bool isHeard() const = 0;
    /// It was seen to move.
    [[nodiscard]] virtual bool isMoving() const = 0;
    /// By telemetry that is younger than the call to stop(): output off.
    [[nodiscard]] virtual bool isSeenStopped() const = 0;
    /// See Device.
    [[nodiscard]] virtual Result<void> mayStop() const = 0;
    [[nodiscard]] virtual StopScript stopScript() const = 0;
    virtual void stop() = 0;
    virtual void repeatStop() = 0;

protected:
    Stoppable() = default;
    ~Stoppable() = default;
};

} // namespace mb
