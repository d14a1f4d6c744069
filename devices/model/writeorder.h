// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/parameterstore.h"

#include <optional>
#include <span>
#include <vector>

namespace mb {

struct Family;

/// A value that is to be written, and what is in force until then.
struct StagedChange {
    ParameterIndex index;
    std::optional<std::int64_t> from;
    std::int64_t to = 0;
};

/// Where a change stands in a batch: smaller is written earlier. The drive obeys every value at once, so that between
/// two writes it must never be livelier than both before and after the batch. First everything that calms, then what
/// leaves it as it is, then what makes it livelier:
///   0 limits that become tighter (numbers)   1 switches that turn a limit on   2 I lowered   3 P lowered
///   4 D raised (damping first)   5 limits that become wider (numbers)   6 switches that turn a limit off
///   7 everything else   8 D lowered   9 P raised   10 I raised   11 live values, such as the position
/// Raised and wider mean a greater amount, whatever the sign, but for limits of the position (boundsPlace). From an unknown value,
/// gains count as raised and limits as tighter, but for 0 where that is no limit (Parameter::zeroIsNone), which is always wider.
[[nodiscard]] int writeRank(const Parameter &parameter, const StagedChange &change);

/// A limit of either sign is a position, wide where it lies far out; all others are amounts.
[[nodiscard]] bool boundsPlace(const Parameter &parameter);

/// The change makes a limit wider, or switches it off; false where it is not known what was in force.
[[nodiscard]] bool widensLimit(const Parameter &parameter, const StagedChange &change);

/// Of a limit that is no place, raw: what lets its motor do least.
[[nodiscard]] std::int64_t tightestOf(const Parameter &limit);

/// By rank, then in table order.
void sortForWriting(std::span<const Parameter> table, std::vector<StagedChange> &changes);

/// The one order in which changes go to a device, whoever asks for them: that of its family (Family::arrange) where it has
/// one, else by rank. `known`: what is in force.
void arrangeForWriting(const Family &family, const ParameterStore &known, std::vector<ParameterChange> &changes);

} // namespace mb
