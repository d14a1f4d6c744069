// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "service/recipe.h"

namespace mb::service {

/// parseRecipe().
[[nodiscard]] Result<Recipe> readRecipe(const QByteArray &text, std::span<const Family *const> families);

} // namespace mb::service
