// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace mb {

/// The pages, in the order of their tabs.
enum class PageId { Overview, Parameters, Tune, Design, Plots, Firmware, Bus, Log, Reports };

} // namespace mb
