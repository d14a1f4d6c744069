// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QWidget;

namespace mb {

/// What a screen reader says of a widget; it is told only when that is another than before, because each telling is read aloud.
void setSpoken(QWidget &widget, const QString &name, const QString &description);
/// The same of a description that follows a live value: at most once a second, the last one always.
void setSpokenLive(QWidget &widget, const QString &description);
/// A result that somebody waits for: the widget is called so from now on, and a screen reader hears of it.
void announce(QWidget &widget, const QString &words);

} // namespace mb
