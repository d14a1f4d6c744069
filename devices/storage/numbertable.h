// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "service/servicejournal.h"
#include "storage/sqlconnection.h"

#include <optional>
#include <string>

namespace mb {

/// Numbers that were reserved together, first and last included; last < first: none.
struct NumberBlock {
    int first = 1;
    int last = 0;
    [[nodiscard]] bool isEmpty() const { return last < first; }
};
/// Takes the next `size` numbers of a scope that nobody has, beginning at wish.first. The same token yields the same block again.
/// None where all are given, up to wish.last.
[[nodiscard]] Result<NumberBlock> takeBlock(SqlConnection &sql, const std::string &token,
    const service::NumberWish &wish, int size, const std::string &station, double time);
/// They lie here from now on, for nobody yet; those that were given before are left out.
[[nodiscard]] Result<void> keepBlock(SqlConnection &sql, const std::string &scope, const NumberBlock &block);
/// The number that this unit has already, or the lowest that lies here; within what is wished for, and nobody's who is connected.
/// Nothing where there is none.
[[nodiscard]] Result<std::optional<int>> giveNumber(SqlConnection &sql, const service::NumberWish &wish);
} // namespace mb
