// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/parametertransfer.h"
#include "settings/settingslog.h"

namespace mb::settings {

/// readParameters() of a unit that stores by itself a while after a write (Capabilities::storesAfter): what a program of this user
/// wrote within that time, and nobody saw stored, is Ram where it is read back, not Stored. `log` may be nullptr: only what this
/// program wrote is known then.
[[nodiscard]] Task<std::vector<TransferOutcome>> readKept(
    Device &device, std::vector<ParameterIndex> indices, SettingsLog *log, Progress &progress);

/// Device::store(); its proof is in the history, for readKept(). A disk that fails costs that only.
[[nodiscard]] Task<bool> storeKept(Device &device, Origin origin, SettingsLog *log, Progress &progress);

/// What is in the unit by now is in its flash: it was proved, or the unit has restarted.
[[nodiscard]] Task<void> keepStored(const Device &device, Origin origin, SettingsLog &log);

} // namespace mb::settings
