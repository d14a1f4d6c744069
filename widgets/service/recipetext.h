// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "service/recipematter.h"

#include <QString>

namespace mb {

/// What a recipe does to every unit, for people: one word or two of each part, a dash where it has none. `matter`: nullptr, no
/// recipe yet.
[[nodiscard]] QString recipeName(const service::RecipeMatter *matter);
/// "dmc60c-1.25.hex · version 1.25 · sha 9f2a41c7"
[[nodiscard]] QString imageText(const service::RecipeMatter *matter);
/// "base_c.json · 55 values"
[[nodiscard]] QString parameterText(const service::RecipeMatter *matter);
/// "next free from 10"
[[nodiscard]] QString numberText(const service::RecipeMatter *matter);
/// "velocity, overshoot, friction": the loop, and what the self-test is judged by.
[[nodiscard]] QString testText(const service::RecipeMatter *matter);

} // namespace mb
