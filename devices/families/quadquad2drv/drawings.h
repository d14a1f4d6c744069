// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "firmware/updateroute.h"

namespace mb::quadquad2drv {

/// The board from above with its serial adapter, not to scale: how TX and RX cross, and the jumper between AUX1 and AUX2 …
extern const Drawing jumperClosed;
/// … taken out.
extern const Drawing jumperOpen;

} // namespace mb::quadquad2drv
