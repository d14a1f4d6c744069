// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/reportunit.h"

namespace mb {

/// One HTML document that refers to nothing outside it, its plots as inline SVG. It keeps to what QTextDocument understands, so
/// that the same text becomes a PDF. Its words are translated, its numbers have a dot. `<meta name="simulated">` is there where one
/// of its units is.
[[nodiscard]] QString htmlOf(const Report &report);

/// The service card, one page a unit: who it is, what its last service has done and measured beside the visit before, its step, and
/// what is set apart from the defaults. The same rules.
[[nodiscard]] QString cardHtmlOf(const Report &report);

/// A label of 62 × 29 mm for each unit that was served: name, number, serial number, firmware, result and day. The same rules.
[[nodiscard]] QString labelHtmlOf(const Report &report);

} // namespace mb
