// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdlib>

namespace mb::test {

/// `usual` rounds, or that times MOTORBENCH_SOAK (an empty or unreadable value counts as 100) when it is set.
[[nodiscard]] inline int rounds(int usual)
{
    const char *soak = std::getenv("MOTORBENCH_SOAK");
    if (soak == nullptr)
        return usual;
    const long factor = std::strtol(soak, nullptr, 10);
    return usual * static_cast<int>(factor > 0 && factor <= 10'000 ? factor : 100);
}

} // namespace mb::test
