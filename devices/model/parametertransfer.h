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

/// Every parameter that this device has and that can be read, in table order.
[[nodiscard]] std::vector<ParameterIndex> readable(const Device &device);

/// Reads one after the other; goes on after an error of one parameter, ends early when the link is lost. Results in the
/// order of `indices`. The device and the progress outlive the task.
[[nodiscard]] Task<std::vector<TransferOutcome>> readParameters(
    Device &device, std::vector<ParameterIndex> indices, Progress &progress);

/// Writes in the order that is safe for the family (Family::arrange), else as given; each is read back and compared (never a Counter, and a Live one is not compared).
/// Ends at the first error, so that nothing half-known goes on; the outcomes tell how far it came.
[[nodiscard]] Task<std::vector<TransferOutcome>> writeParameters(
    Device &device, std::vector<ParameterChange> changes, Progress &progress);

} // namespace mb
