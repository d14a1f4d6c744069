// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace mb {

struct Options;

/// Draws the recording of `options.plot` into the picture `options.out`, one pane for each unit, in the theme and size of
/// the options. Yields the exit status: 0, or that of refuse() after one line on standard error. Needs a QApplication, no screen.
[[nodiscard]] int plotFile(const Options &options);

/// Prints the report that `options.report` holds as HTML into the PDF `options.out`. Yields the exit status: 0, or that of refuse() after one line
/// on standard error. Needs a QApplication, no screen.
[[nodiscard]] int printReport(const Options &options);

} // namespace mb
