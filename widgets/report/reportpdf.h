// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>

namespace mb {

/// The document of htmlOf() (devices/report) on pages of A4, its plots as vectors, or on pages of the size that its
/// `@page { size: Wmm Hmm; margin: Mmm }` asks for, such as labels, with nothing around; on every page its title, the number of the page,
/// and where it is of a simulated unit a word about that. Empty when it cannot be painted. Needs a QGuiApplication, no screen.
[[nodiscard]] QByteArray pdfOf(const QString &html);

} // namespace mb
