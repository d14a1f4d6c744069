// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "service/recipe.h"

namespace mb::service {

/// OutOfRange with line, cause and remedy: "line 7: unknown key 'limit'". Paths stay as they are in the text.
[[nodiscard]] Result<Recipe> parseRecipe(const QByteArray &text, std::span<const Family *const> families);

} // namespace mb::service
