// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "service/visit.h"

namespace mb::service {

/// Where the values of units that passed lie: median ± 3 MAD.
struct Band {
    double median = 0.0;
    double deviation = 0.0; ///< MAD, not scaled
    int units = 0;

    [[nodiscard]] double low() const { return median - 3.0 * deviation; }
    [[nodiscard]] double high() const { return median + 3.0 * deviation; }
};

constexpr int fewestForBand = 8;
constexpr int visitsForBand
    = 500; ///< the newest say what is usual now, and a journal of years is not read while motors turn

/// Of one key of the self-tests of units that passed, each unit by its last visit; nothing for fewer than 8.
[[nodiscard]] std::optional<Band> bandOf(const std::vector<Visit> &passed, const std::string &key);

/// Marks the values that are outside; yields one sentence about them, empty when none is.
[[nodiscard]] Message markUnusual(std::vector<TestValue> &values, const std::vector<Visit> &passed);

} // namespace mb::service
