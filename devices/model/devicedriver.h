// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/noncopyable.h"
#include "async/progress.h"
#include "async/task.h"
#include "model/parameter.h"
#include "model/setpoint.h"
#include "telemetry/channel.h"

#include <cstdint>
#include <optional>
#include <span>
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

/// What a family implements of a device, besides Stoppable. What is public is asked as it stands; the rest Device calls, after the
/// checks that all families have in common, and says there what each has to do. Engine thread.
class DeviceDriver : NonCopyable {
public:
    [[nodiscard]] const Family &family() const { return m_family; }
    /// False for a parameter of the family's table that this device's dialect does not have.
    [[nodiscard]] virtual bool offers(ParameterIndex) const { return true; }
    /// Why this value cannot be written after those `before` it, as far as that is known before they are: the device is told nothing.
    /// They outlive it.
    [[nodiscard]] Task<void> mayWrite(
        ParameterIndex index, std::int64_t raw, std::span<const ParameterChange> before = {});
    /// Versions and descriptors from the device itself.
    [[nodiscard]] virtual Task<void> refresh() = 0;
    /// Makes what was written survive a power cycle and proves it where the device can: true; false where it cannot.
    [[nodiscard]] virtual Task<bool> store(Progress &progress) = 0;
    [[nodiscard]] virtual Task<std::vector<FaultRecord>> readFaults() = 0;
    /// Reads and clears sticky faults and counters; yields what they were.
    [[nodiscard]] virtual Task<std::vector<FaultRecord>> clearFaults() = 0;
    /// Blinks, or Unsupported.
    [[nodiscard]] virtual Task<void> identify();
    /// Unsupported where the unit stores no name.
    [[nodiscard]] virtual Task<void> rename(std::string name);
    /// Gives the device another address; on success identity() has it, proved by the device's answer from there.
    [[nodiscard]] virtual Task<void> renumber(int address) = 0;
    /// Asks for this many samples per second of a channel, as near as the device can; 0 returns to what it was.
    [[nodiscard]] virtual Task<void> setRate(ChannelIndex channel, double hertz) = 0;
    /// Checks the set-point against what the device can do: OutOfRange or Unsupported, nothing sent.
    [[nodiscard]] Result<void> check(const SetPoint &setPoint) const;
    /// What the user should know before it is sent although it is legal, as one clause; empty most of the time.
    [[nodiscard]] virtual Message caution(const SetPoint &) const { return {}; }
    /// Stops the motor, waits until the device has acknowledged that, and makes the present position 0 (Capabilities::
    /// zeroPosition). The motor stays off. Unsafe when the stop is not acknowledged: nothing was zeroed then.
    /// MotionGate::originMoved() once it may have been.
    [[nodiscard]] virtual Task<void> zeroPosition();

protected:
    explicit DeviceDriver(const Family &family);
    ~DeviceDriver() = default;

    /// All but the options of the output, which Capabilities has.
    [[nodiscard]] virtual Result<void> doCheck(const SetPoint &setPoint) const = 0;
    virtual Task<std::int64_t> doRead(ParameterIndex index) = 0;
    /// A family's own reasons besides those that all have; what must be asked for them is asked.
    virtual Task<void> doMayWrite(ParameterIndex index, std::int64_t raw, std::span<const ParameterChange> before);
    virtual Task<std::int64_t> doWrite(ParameterIndex index, std::int64_t raw) = 0;
    virtual Task<void> doRestart();
    /// A family's own reasons besides those that all have.
    [[nodiscard]] virtual Result<void> doMayMove() const { return {}; }
    /// Calibration or dialect are others.
    virtual void doProfileChanged() { }
    virtual Result<void> doCommand(const SetPoint &setPoint) = 0;
    virtual Result<void> doReleaseMoves();
    virtual void doStop() = 0;
    /// A family's own reasons why a stop may do harm.
    [[nodiscard]] virtual Result<void> doMayStop() const { return {}; }

private:
    const Family &m_family;
};

} // namespace mb
