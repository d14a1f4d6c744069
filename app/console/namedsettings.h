// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/notebook.h"
#include "app/console/target.h"

#include <QByteArray>

namespace mb::console {

/// Settings as a command line names them: a device, `snapshot:NAME` or `snapshot:NUMBER`, `defaults`, or else a file.
struct NamedSettings {
    enum class Kind { Device, Snapshot, Defaults, File };
    Kind kind = Kind::File;
    std::string text;             ///< without `snapshot:`
    std::optional<Target> target; ///< of a device
};

[[nodiscard]] Result<NamedSettings> parseSettings(const Console &console, const std::string &text);

/// The object of `get` in a file or a snapshot. Of several snapshots of that name the newest of `unit` (Unit::key), where a
/// unit is named. Usage, with the cause, where it is not there. The notebook is for snapshots.
[[nodiscard]] Result<QByteArray> loadSettings(const NamedSettings &named, Notebook *notebook, const std::string &unit);

} // namespace mb::console
