// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdlib>

namespace mb {

/// A folder of the environment that is not absolute counts as not set (XDG Base Directory Specification): else a notebook would lie
/// wherever the program was run. Before anything reads the environment.
inline void ignoreRelativeFolders()
{
    for (const char *const name : {"XDG_DATA_HOME", "XDG_CACHE_HOME", "XDG_CONFIG_HOME"}) {
        const char *const folder = std::getenv(name);
        if (folder && *folder != '/')
            ::unsetenv(name);
    }
}

} // namespace mb
