// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/clock.h"
#include "model/liveness.h"
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
    /// Its own watchdog switches its output off when nobody commands it (Capabilities::watchdog).
    [[nodiscard]] bool hasWatchdog() const { return m_hasWatchdog; }
    /// When it has done so for certain (Capabilities::watchdogLimit).
    [[nodiscard]] Duration watchdogLimit() const { return m_watchdogLimit; }
    [[nodiscard]] virtual const Liveness &liveness() const = 0;
    /// By telemetry that is younger than the call to stop(): output off.
    [[nodiscard]] virtual bool isSeenStopped() const = 0;
    /// See Device.
    [[nodiscard]] virtual Result<void> mayStop() const = 0;
    /// What stops this device when this process, or its engine thread, cannot: sent by the guardian and by the stop lane
    /// (docs/architecture.md#stop).
    [[nodiscard]] virtual StopScript stopScript() const { return {}; }
    virtual void stop() = 0;
    virtual void repeatStop() = 0;

protected:
    explicit Stoppable(bool hasWatchdog, Duration watchdogLimit = std::chrono::milliseconds(250))
        : m_hasWatchdog(hasWatchdog)
        , m_watchdogLimit(watchdogLimit)
    {
    }
    ~Stoppable() = default;

private:
    bool m_hasWatchdog;
    Duration m_watchdogLimit;
};

} // namespace mb
