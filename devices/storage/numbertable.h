// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "service/servicejournal.h"
#include "storage/sqlconnection.h"
#include "storage/visittable.h"

#include <optional>
#include <string>
#include <vector>

namespace mb {

/// Numbers that were reserved together, first and last included; last < first: none.
struct NumberBlock {
    int first = 1;
    int last = 0;
    [[nodiscard]] bool isEmpty() const { return last < first; }
};
/// Whose a number is.
struct GivenNumber {
    std::string scope;
    int number = 0;
    std::string unit;
    std::string visit;
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
/// The number that this unit has already, like that.
[[nodiscard]] Result<std::optional<int>> numberOf(SqlConnection &sql, const service::NumberWish &wish);
/// They were given elsewhere. What is somebody else's here remains that.
[[nodiscard]] Result<void> putNumbers(SqlConnection &sql, const std::vector<GivenNumber> &numbers);
/// Those of these visits that were given out of `scope + suffix`, under `scope`.
[[nodiscard]] Result<std::vector<GivenNumber>> numbersOf(
    SqlConnection &sql, const std::vector<KeptVisit> &visits, const std::string &suffix);
/// What was reserved under `scope` lies under `other` from now on, unless this file gives numbers of `scope` by itself.
[[nodiscard]] Result<void> moveBlocks(SqlConnection &sql, const std::string &scope, const std::string &other);
} // namespace mb
