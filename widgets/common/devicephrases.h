// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <string_view>

namespace mb {

/// A sentence of the device library in the language of the program. The library joins its English sentences from words
/// and values ("page 5: no status within 2 s, sent again") and knows no translation; here they are patterns with %1 …,
/// and what stands for a placeholder is translated in the same way. A sentence that fits no pattern stays as it is.
[[nodiscard]] QString devicePhrase(std::string_view english);

} // namespace mb
