// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStandardPaths>

#include <string>

namespace mb {

/// Where window and console keep what they know of devices (model/deviceprofile.h): below the user's data directory,
/// XDG_DATA_HOME.
[[nodiscard]] inline std::string profileFolder()
{
    return QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation).toStdString() + "/motorbench/devices";
}

/// Where they keep who answered on which link (model/scanbook.h): below the user's cache directory, XDG_CACHE_HOME, because it
/// can be lost.
[[nodiscard]] inline std::string scanFolder()
{
    return QStandardPaths::writableLocation(QStandardPaths::GenericCacheLocation).toStdString() + "/motorbench/scans";
}

/// Where the logs of firmware updates go.
[[nodiscard]] inline std::string transcriptFolder()
{
    return QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation).toStdString() + "/motorbench/updates";
}

/// Everything that is kept for good: below it also `recordings`, what the window had open, in `sessions`, and reports of crashes, in
/// `crashes`.
[[nodiscard]] inline std::string programFolder()
{
    return QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation).toStdString() + "/motorbench";
}

/// What people have chosen and arranged: settings of the window, limits of units, and layouts of plots, in `plots`.
[[nodiscard]] inline std::string settingsFolder()
{
    return QStandardPaths::writableLocation(QStandardPaths::GenericConfigLocation).toStdString() + "/motorbench";
}

/// Old samples of this run that memory has no room for.
[[nodiscard]] inline std::string samplesFolder()
{
    return QStandardPaths::writableLocation(QStandardPaths::GenericCacheLocation).toStdString() + "/motorbench/samples";
}

/// Trials, and what is owed to units: one file for window and console.
[[nodiscard]] inline std::string databaseFile()
{
    return QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation).toStdString()
        + "/motorbench/motorbench.db";
}

} // namespace mb
