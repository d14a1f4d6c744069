// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "transport/canlink.h"

#include <memory>

namespace mb {

/// The closed link of `qtcan:PLUGIN:INTERFACE?bitrate=N`: every adapter that QtSerialBus has a plugin for (peakcan,
/// tinycan, passthrucan, …). The bit rate is the plugin's own unless it is given. These plugins do not tell how many
/// frames were lost; `socketcan:` is the better way to the same adapter where the kernel drives it. Fails with
/// OutOfRange when the address does not parse.
[[nodiscard]] Result<std::unique_ptr<Link>> makeQtCanLink(const LinkAddress &address, Clock &clock);

} // namespace mb
