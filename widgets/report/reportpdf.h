// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>

namespace mb {

/// The document of htmlOf() or cardHtmlOf() (devices/report) on pages of A4, its plots as vectors; on every page its title, the
/// number of the page, and where it is of a simulated unit a word about that. A text that names its page (`@page { size: 62mm 29mm;
/// margin: 2mm }`), as labelHtmlOf() does, gets pages of that size with nothing else on them. Empty when it cannot be painted. Needs a QGuiApplication, no screen.
[[nodiscard]] QByteArray pdfOf(const QString &html);

} // namespace mb
