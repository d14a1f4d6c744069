// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/device.h"

#include <vector>

namespace mb {

struct TransferOutcome {
    ParameterIndex index;
    Result<std::int64_t> raw{0};  ///< what is in force
    std::optional<bool> verified; ///< of a write: read back and equal; nothing where it cannot be read back
};

/// Why it failed, told of the parameter of this key: it stands before a cause that does not say it. Of one that failed.
[[nodiscard]] Error errorOf(const TransferOutcome &outcome, std::string_view key);

/// Every parameter that this device has and that can be read, in table order.
[[nodiscard]] std::vector<ParameterIndex> readable(const Device &device);

/// Reads one after the other; goes on after an error of one parameter, ends early when the link is lost or the device is not heard any more. Results in the
/// order of `indices`. The device and the progress outlive the task.
[[nodiscard]] Task<std::vector<TransferOutcome>> readParameters(
    Device &device, std::vector<ParameterIndex> indices, Progress &progress);

/// What a reset took from a device that keeps nothing, and can be written again, in table order (DeviceProfile::lost).
[[nodiscard]] std::vector<ParameterChange> lostSettings(const Family &family, const DeviceProfile &profile);

/// Writes it again; yields how many. Unsafe while a motor turns. Ends at the first error or second reset and says how far it
/// came; what was not written stays lost, so that it can be run again after any cut.
[[nodiscard]] Task<int> rewriteSettings(Device &device, Progress &progress);

/// What may not be written (Device::mayWrite) in the order of writing, the first of them; nothing where all may.
[[nodiscard]] Task<std::optional<TransferOutcome>> findRefused(Device &device, std::vector<ParameterChange> changes);

/// Writes, where all may be written, in the order that is never livelier in between (arrangeForWriting()), however they are given; each is read back and compared (a Counter that was cleared with 0, and a Live one with nothing).
/// Ends at the first error, so that nothing half-known goes on; the outcomes tell how far it came: findRefused() alone, nowhere.
[[nodiscard]] Task<std::vector<TransferOutcome>> writeParameters(
    Device &device, std::vector<ParameterChange> changes, Progress &progress);

} // namespace mb
