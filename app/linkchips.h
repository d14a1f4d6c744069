// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/workbench.h"

namespace mb {

class DemoStripe;
class HeaderBar;

/// What the header says of the links: of each its state, load, loss, and the whole story in its tooltip; how long a recording of frames
/// runs; and in the stripe whether anything is simulated or replayed.
void showLinks(HeaderBar &header, DemoStripe &stripe, const Snapshot &shot);

} // namespace mb
