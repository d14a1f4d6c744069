// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/progress.h"
#include "async/task.h"
#include "model/parameter.h"
#include "model/setpoint.h"
#include "model/stopscript.h"
#include "telemetry/channel.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace mb {

struct Family;

struct FaultRecord {
    std::string key; ///< over_current, …; stable, for JSON
    bool active = false;
    bool sticky = false;
    std::optional<std::int64_t> count;
};

/// What a family implements of a device: Device calls it, after the checks that all families have in common, and says there what
/// each has to do. Engine thread.
class DeviceDriver {
public:
    DeviceDriver(const DeviceDriver &) = delete;
    DeviceDriver &operator=(const DeviceDriver &) = delete;

protected:
    explicit DeviceDriver(const Family &family);
    virtual ~DeviceDriver() = default;

    virtual Task<void> doRefresh() = 0;
    virtual Task<std::int64_t> doRead(ParameterIndex index) = 0;
    virtual Task<std::int64_t> doWrite(ParameterIndex index, std::int64_t raw) = 0;
    virtual Task<bool> doStore(Progress &progress) = 0;
    virtual Task<std::vector<FaultRecord>> doReadFaults() = 0;
    virtual Task<std::vector<FaultRecord>> doClearFaults() = 0;
    virtual Task<void> doIdentify() = 0;
    virtual Task<void> doRestart();
    virtual Task<void> doRename(std::string name) = 0;
    virtual Task<void> doRenumber(int address) = 0;
    virtual Task<void> doSetRate(ChannelIndex channel, double hertz) = 0;
    /// A family's own reasons besides those that all have.
    [[nodiscard]] virtual Result<void> doMayMove() const { return {}; }
    /// Calibration or dialect are others.
    virtual void doProfileChanged() { }
    [[nodiscard]] virtual Result<void> doCheck(const SetPoint &setPoint) const = 0;
    [[nodiscard]] virtual Message doCaution(const SetPoint &) const { return {}; }
    virtual Result<void> doCommand(const SetPoint &setPoint) = 0;
    [[nodiscard]] virtual bool doOffers(ParameterIndex) const { return true; }
    virtual Result<void> doReleaseMoves();
    virtual Task<void> doZeroPosition();
    virtual void doStop() = 0;
    /// Families that repeat a stop by themselves do nothing here.
    virtual void doRepeatStop() { doStop(); }
    /// A family's own reasons why a stop may do harm.
    [[nodiscard]] virtual Result<void> doMayStop() const { return {}; }
    [[nodiscard]] virtual StopScript doStopScript() const { return {}; }
    [[nodiscard]] virtual bool doIsSeenStopped() const = 0;

private:
    const Family &m_family;
};

} // namespace mb
