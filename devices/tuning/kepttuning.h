// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tuning/autotune.h"

namespace mb {

/// A tuning as it is kept in the notebook: what it stands on and what came of it. Of the trials of its proof those that are still
/// there, without their signals; predictions are thinned out.
struct KeptTuning {
    std::int64_t number = 0;
    double time = 0.0; ///< Unix time of its end, s
    tuning::TuneReport report;
};

/// The trial is one of those that the tuning was made of.
[[nodiscard]] inline bool isPartOf(std::int64_t trial, const tuning::TuneReport &report)
{
    for (const std::int64_t number : report.trials) {
        if (number == trial)
            return true;
    }
    return false;
}

} // namespace mb
