// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/parametertransfer.h"
#include "settings/settingslog.h"

/// Snapshots of a unit: all its values at one moment, as they are known, or read and kept.
namespace mb::settings {

/// Every parameter that this device has, also those that can only be written, in table order.
[[nodiscard]] std::vector<ParameterIndex> offered(const Device &device);

/// What is known of the device now, not kept yet; nothing is asked. Values that cannot be read stay marked as assumed.
[[nodiscard]] ParameterSnapshot describe(const Device &device, Occasion occasion, std::string name = {});

/// Reads everything that can be read, and keeps it. An empty name is the usual one of the occasion. Single parameters that
/// do not answer are kept as unknown; Timeout or LinkLost when the device fell silent, and then nothing is kept.
[[nodiscard]] Task<ParameterSnapshot> takeSnapshot(
    Device &device, Occasion occasion, std::string name, SettingsLog &log, Progress &progress);

/// Why who replaces many values goes no further: no snapshot of them could be kept (NotKept).
[[nodiscard]] Error keepsNothing(const Error &trouble);

} // namespace mb::settings
