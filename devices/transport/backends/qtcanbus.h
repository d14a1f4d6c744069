// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "transport/canlink.h"

#include <memory>
#include <string>
#include <vector>

namespace mb {

/// What one plugin of QtSerialBus offers.
struct QtCanAdapter {
    std::string path; ///< "peakcan:usb0"; the plugin alone where it has no adapter
    Message description;
    Message missing; ///< why it has none, in one clause; empty when it has
    Message remedy;
};

/// Every plugin that is installed, and its adapters. Slow the first time: plugins load their vendor's library.
[[nodiscard]] std::vector<QtCanAdapter> qtCanAdapters();

/// The closed link of `qtcan:PLUGIN:INTERFACE?bitrate=N`: every adapter that QtSerialBus has a plugin for (peakcan,
/// tinycan, passthrucan, …). The bit rate is the plugin's own unless it is given. These plugins do not tell how many
/// frames were lost; `socketcan:` is the better way to the same adapter where the kernel drives it. Fails with
/// OutOfRange when the address does not parse.
[[nodiscard]] Result<std::unique_ptr<Link>> makeQtCanLink(const LinkAddress &address, Clock &clock);

} // namespace mb
