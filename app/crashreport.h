// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace mb {

/// Writes a report when the program crashes (SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT): what it was, on what, and the calls that
/// led there, as text that people can read and send. Then the signal takes its course. Once, at the start, in main().
/// `folder` is made; where that fails nothing is written.
void installCrashReport(const QString &folder, const QString &versions);
/// The newest report of the folder; empty when there is none.
[[nodiscard]] QString newestCrashReport(const QString &folder);

} // namespace mb
