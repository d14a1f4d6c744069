// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tuning/margins.h"
#include "widgets/plots/curvemarks.h"

namespace mb {

/// Where a loop crosses 0 dB and −180°, and how far it is from both together, as marks of its two plots.
struct BodeMarks {
    std::vector<CurveMark> magnitude;
    std::vector<CurveMark> phase;
};
/// `usable`: Hz, beyond which nothing was measured that may be trusted; 0: nothing was measured.
[[nodiscard]] BodeMarks bodeMarks(const tuning::Margins &margins, double usable);

/// "crossover 0.63 Hz, phase margin 67°, gain margin 11.9 dB, Ms 1.44".
[[nodiscard]] QString marginText(const tuning::Margins &margins);

} // namespace mb
