// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace mb::console {

/// Yes only from somebody who sits at a terminal and says so; a script is never asked.
[[nodiscard]] bool isAgreedTo(const std::string &question);

} // namespace mb::console
