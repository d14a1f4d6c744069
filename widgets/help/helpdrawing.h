// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"

#include <QByteArray>
#include <QFont>

namespace mb {

/// A drawing of scripts/drawings as the window shows it: in the colours of the theme, its labels in the language of the window.
/// What is longer than its room (data-room, in units of the drawing) is set smaller. `font`: whose glyphs are used where it
/// names several families, which Chinese and Japanese need.
[[nodiscard]] QByteArray dressedDrawing(const QByteArray &svg, const Theme &theme, const QFont &font);

} // namespace mb
