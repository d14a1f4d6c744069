// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"

namespace mb {

/// Whether a palette is made for eyes that need black on white or white on black.
bool isHighContrast(const QPalette &palette);
/// Surfaces, text and highlight of a desktop's palette; what it has no word for (states, traces, banners) is ours, moved as far from
/// its surfaces as text needs: 4.5:1, and 7:1 where isHighContrast(). Readable whatever the palette is.
Theme systemTheme(const QPalette &palette, double bodyPointSize = 10.0);
/// Ours for those whose desktop has none: white on black.
Theme contrastTheme(double bodyPointSize = 10.0);

/// What settings and the command line call them: dark, light, contrast, system.
QStringList themeNames();
QString systemThemeName();
/// Nothing chosen yet: dark, but where the desktop is made for high contrast, as the desktop.
Theme themeNamed(const QString &name, const QPalette &desktop, double bodyPointSize);

} // namespace mb
