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

/// Where the logs of firmware updates go.
[[nodiscard]] inline std::string transcriptFolder()
{
    return QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation).toStdString() + "/motorbench/updates";
}

} // namespace mb
