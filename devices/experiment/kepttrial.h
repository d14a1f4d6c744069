// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "experiment/trial.h"

namespace mb {

/// A trial as it is kept in the notebook. Without its signals, unless somebody has asked for them.
struct KeptTrial {
    std::int64_t number = 0;
    double time = 0.0; ///< Unix time of its beginning, s
    tuning::Trial trial;
    bool star = false;
    std::string note;
};

} // namespace mb
