// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/family.h"

#include <array>
#include <span>
#include <string_view>
#include <vector>

namespace mb::console {

// What options take where that is one of a few words: verbs check against it, and the shells complete it.

[[nodiscard]] std::vector<std::string_view> tunableLoops();
[[nodiscard]] std::vector<std::string_view> aimWords();
[[nodiscard]] std::vector<std::string_view> profileWords();
/// Of families whose frames on CAN are read by a dialect.
[[nodiscard]] std::vector<std::string_view> dialectWords(std::span<const Family *const> families);
/// Of families whose update goes another way than their own link.
[[nodiscard]] std::vector<std::string_view> targetWords(std::span<const Family *const> families);
/// What `--via` takes for these, one example each.
[[nodiscard]] std::string waysOf(std::span<const UpdateRoute> routes, std::string_view between);
inline constexpr std::array<std::string_view, 3> reportSizes{"report", "card", "label"};

} // namespace mb::console
