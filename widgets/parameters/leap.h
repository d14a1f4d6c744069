// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/parameter.h"

#include <QString>

#include <optional>

namespace mb {

/// How many times as large (or as small, below 1) a gain becomes, where that is beyond ten and so asks for one more look;
/// nothing where it is not, where nothing is known to compare with, and where a gain goes to or comes from 0.
[[nodiscard]] std::optional<double> leap(const Parameter &parameter, std::optional<std::int64_t> from, std::int64_t to);
/// "27 × as large as now, 1.2."
[[nodiscard]] QString leapText(const Parameter &parameter, std::int64_t from, double factor);
/// Whether a legal value near what was typed may be offered at one click. The end of a range is what the wire can carry: for
/// a gain that is no proposal.
[[nodiscard]] bool isSensibleFix(const Parameter &parameter, std::optional<std::int64_t> known, std::int64_t proposed);

} // namespace mb
