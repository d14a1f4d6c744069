// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/parametertransfer.h"

#include <optional>
#include <span>

namespace mb {

/// A value that is to be written, and what is in force until then.
struct StagedChange {
    ParameterIndex index;
    std::optional<std::int64_t> from;
    std::int64_t to = 0;
};

/// Where a change stands in a batch: smaller is written earlier. The drive obeys every value at once, so that between
/// two writes it must never be livelier than before and after the batch:
///   0 limits (numbers)   1 what switches limits on or off   2 I lowered   3 P lowered   4 D raised (damping first)
///   5 everything else    6 D lowered   7 P raised   8 I raised   9 live values, such as the position
/// Raised means a greater amount, whatever the sign; a change from an unknown value counts as raised.
[[nodiscard]] int writeRank(const Parameter &parameter, const StagedChange &change);

/// By rank, then in table order.
void sortForWriting(std::span<const Parameter> table, std::vector<StagedChange> &changes);

} // namespace mb
