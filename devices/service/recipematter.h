// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "firmware/firmwareimage.h"
#include "service/recipe.h"

namespace mb::service {

/// A recipe with what its files hold.
struct RecipeMatter {
    Recipe recipe;
    std::string
        hash; ///< SHA-256 of the recipe's text and of the files that it names, hexadecimal: another one is another recipe
    FirmwareImage image;
    std::string imageHash;                   ///< SHA-256 of the firmware file; empty: it has none
    std::string imageVersion;                ///< empty where the image tells none
    std::vector<ParameterChange> parameters; ///< what is written to every unit, in table order
};

/// The files that a recipe names, relative to that folder; of its text toText() is in its hash. OutOfRange with the file and the cause.
[[nodiscard]] Result<RecipeMatter> gatherMatter(Recipe recipe, const std::string &folder);

/// Reads a recipe and the files that it names, relative to its own folder. OutOfRange with the file, its line and the cause.
[[nodiscard]] Result<RecipeMatter> loadRecipe(const std::string &path, std::span<const Family *const> families);

} // namespace mb::service
