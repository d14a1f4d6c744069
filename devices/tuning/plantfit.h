// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tuning/pushfit.h"

#include <span>

namespace mb::tuning {

/// How final speed follows from duty: duty = friction·sgn + offset + speed/gain.
struct GainFit {
    double gain = 0.0;     ///< counts/s at full duty
    double friction = 0.0; ///< duty that moving friction takes
    double offset = 0.0;   ///< duty that a load takes which always pulls one way; 0 unless both directions were seen
    double gainError = 0.0;
    double frictionError = 0.0;
    double offsetError = 0.0;
    double forward = 0.0; ///< counts/s per duty beyond friction, of each direction alone
    double reverse = 0.0;
    /// |forward − reverse| over their mean.
    [[nodiscard]] double asymmetry() const;
};

/// Least squares over pushes of two sizes at least. OutOfRange where all have one size, or a motor did not turn with its duty.
[[nodiscard]] Result<GainFit> fitGain(std::span<const double> duties, std::span<const double> speeds);

} // namespace mb::tuning
