// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

namespace mb {

struct Family;

/// Every family of this build, in the order of FAMILIES. Defined in `devices`, the sum of the families.
[[nodiscard]] std::span<const Family *const> families();

/// nullptr when there is none.
[[nodiscard]] const Family *findFamily(std::span<const Family *const> families, std::string_view key);

} // namespace mb
