// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSysInfo>

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

/// Of this computer, as journals name a station that nobody has named.
[[nodiscard]] inline std::string hostName()
{
    return QSysInfo::machineHostName().toStdString();
}

} // namespace mb
