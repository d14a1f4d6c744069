// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/pagekeys.h"

namespace mb {

class TunePage;

/// The keys of the Tune page, each with what it does: what F1 lists. Belongs to the page.
PageKeys *makeTuneKeys(TunePage &page);

} // namespace mb
