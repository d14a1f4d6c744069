// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/pagekeys.h"
#include "widgets/control/tuneparts.h"

namespace mb {

class TuneExperiments;
class TuneForm;
class TuneGains;
class TuneMotion;

/// What the keys of the Tune page order, and the order that only the page can give.
struct TuneKeyOrders {
    TuneParts parts;
    TuneForm *form = nullptr;
    TuneMotion *motion = nullptr;
    TuneGains *gains = nullptr;
    TuneExperiments *experiments = nullptr;
    std::function<void()> run;
};

/// The keys of the Tune page, each with what it does: what F1 lists. Belongs to the page.
PageKeys *makeTuneKeys(QWidget &page, const TuneKeyOrders &orders);

} // namespace mb
