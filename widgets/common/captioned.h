// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"

class QHBoxLayout;
class QLabel;
class QWidget;

namespace mb {

/// Adds a value below its small dim caption, as heads of pages have them; one line that ends in "…" where it does not fit. The
/// caption is its accessible name.
QLabel *addCaptioned(
    const ThemeSource &theme, const QString &caption, TextRole role, QHBoxLayout &row, int stretch, QWidget *parent);

} // namespace mb
