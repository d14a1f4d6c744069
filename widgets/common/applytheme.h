// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"

#include <QPalette>

class QApplication;

namespace mb {

/// QPalette::Shadow, which nothing of ours is painted with, is left to the desktop: by it SystemPalette notices that the desktop has
/// other colours.
QPalette themePalette(const Theme &theme);
/// Fills a sheet: `@token` is a colour of the theme, `12u` a length, `0.85f` a font size relative to the body,
/// `@scheme` the word dark or light. An unknown token stays as it is.
QString fillStyleSheet(const QString &sheet, const Theme &theme);
/// Palette and sheet (`:/style.qss`) for the whole program. May be called again at any time.
void applyTheme(QApplication &app, const Theme &theme);

} // namespace mb
