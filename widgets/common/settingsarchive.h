// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/result.h"
#include "settings/settingslog.h"

#include <QObject>

#include <functional>
#include <vector>

namespace mb {

/// Everything that is kept of one unit's settings, each oldest first; snapshots without their files.
struct SettingsTimeline {
    std::vector<settings::ParameterSnapshot> snapshots;
    std::vector<settings::SettingsChange> changes;
};

/// What is kept of settings as the window sees it: nothing waits, answers come later, never from inside the call. Everything on
/// the GUI thread.
class SettingsArchive : public QObject {
    Q_OBJECT
public:
    using Listed = std::function<void(Result<SettingsTimeline>)>;
    using Fetched = std::function<void(Result<settings::ParameterSnapshot>)>;

    using QObject::QObject;

    /// Of a unit (unitKeyOf()).
    virtual void list(const std::string &unit, Listed listed) = 0;
    /// One snapshot with its file.
    virtual void fetch(std::int64_t snapshot, Fetched fetched) = 0;
};

} // namespace mb
