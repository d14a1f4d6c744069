// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/parameters/timelinelist.h"

#include <QCoreApplication>

namespace mb {

/// The states of one unit that can be compared: what it has now, the snapshots whose files have come, newest first, and the
/// factory's defaults.
class UnitStates {
    Q_DECLARE_TR_FUNCTIONS(mb::UnitStates)
public:
    static constexpr std::int64_t present = 0; ///< numbers of what is no snapshot
    static constexpr std::int64_t defaults = -1;

    /// Another unit: nothing is known of its past.
    void begin(const Family &family);
    void setPresent(settings::Side now) { m_now = std::move(now); }
    void setTimeline(const SettingsTimeline &timeline) { m_timeline = timeline; }
    void addFile(const settings::ParameterSnapshot &snapshot);
    /// Of the newest snapshots those whose files have not come.
    [[nodiscard]] std::vector<std::int64_t> missing() const;
    /// Puts them together anew.
    void rebuild();

    [[nodiscard]] const Family *family() const { return m_family; }
    [[nodiscard]] const SettingsTimeline &timeline() const { return m_timeline; }
    [[nodiscard]] const std::vector<UnitState> &all() const { return m_states; }
    [[nodiscard]] const UnitState &at(int place) const { return m_states[static_cast<std::size_t>(place)]; }
    /// Of the newest snapshot that is unlike the present, which is worth a look when nobody has chosen yet.
    [[nodiscard]] std::int64_t newestUnlike() const;

private:
    const Family *m_family = nullptr;
    settings::Side m_now;
    SettingsTimeline m_timeline;
    std::map<std::int64_t, settings::Side> m_files; ///< by number of the snapshot
    std::vector<UnitState> m_states;
};

} // namespace mb
