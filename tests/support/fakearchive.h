// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/settingsarchive.h"

#include <QTimer>

#include <algorithm>
#include <map>

namespace mb::test {

/// What is kept of settings, in memory. Answers come with the next turn of the event loop.
class FakeArchive final : public SettingsArchive {
public:
    using SettingsArchive::SettingsArchive;

    std::map<std::string, SettingsTimeline> kept; ///< by unit; snapshots with their files

    void list(const std::string &unit, Listed listed) override
    {
        SettingsTimeline timeline = kept[unit];
        for (settings::ParameterSnapshot &snapshot : timeline.snapshots)
            snapshot.file.clear();
        QTimer::singleShot(0, this, [listed, timeline] { listed(timeline); });
    }
    void fetch(std::int64_t snapshot, Fetched fetched) override
    {
        Result<settings::ParameterSnapshot> found = fail(Fault::OutOfRange, say("there is no such snapshot"));
        for (const auto &[unit, timeline] : kept) {
            for (const settings::ParameterSnapshot &each : timeline.snapshots) {
                if (each.number == snapshot)
                    found = each;
            }
        }
        QTimer::singleShot(0, this, [fetched, found] { fetched(found); });
    }
};

} // namespace mb::test
