// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pwd.h>
#include <unistd.h>

#include <string>

namespace mb {

/// Whose account this process runs under, as histories name a person; its number where it has no name.
[[nodiscard]] inline std::string accountName()
{
    const passwd *const entry = ::getpwuid(::getuid());
    return entry && entry->pw_name ? std::string(entry->pw_name) : std::to_string(::getuid());
}

} // namespace mb
