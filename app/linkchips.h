// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/chip.h"
#include "widgets/common/workbench.h"

namespace mb {

/// What the header says of a link: state, load, loss, and the whole story in its tooltip.
[[nodiscard]] LinkStatus chipOf(const LinkView &link, const Snapshot &shot);

/// Of the recording of frames that runs longest; empty when none does.
[[nodiscard]] QString recordingTime(const Snapshot &shot);

} // namespace mb
