// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/seconds.h"
#include "settings/settingslog.h"
#include "storage/database.h"

namespace mb {

/// Snapshots of units and every write to them, kept for good. Thread of the database, which outlives it. Fails with NotKept
/// and the cause on a full disk, or a file that cannot be written; nothing was changed then.
class SettingsBook final : public settings::SettingsLog {
public:
    /// The clock gives the time of day; `person` is the name of the account that writes are kept under.
    SettingsBook(Database &database, const Clock &clock, std::string person);

    [[nodiscard]] Task<settings::ParameterSnapshot> keep(settings::ParameterSnapshot snapshot) override;
    [[nodiscard]] Task<std::int64_t> begin(settings::SettingsChange change) override;
    [[nodiscard]] Task<void> complete(std::int64_t number, std::vector<settings::ValueChange> values) override;
    [[nodiscard]] Task<std::vector<settings::SettingsChange>> changesOf(std::string unit) override;
    [[nodiscard]] Task<void> moved(std::string from, std::string to) override;

    /// The unit that stands at a place by now: what is kept under a place is kept under the tag of its unit, where it has one. Every
    /// function here that takes a unit does that by itself.
    [[nodiscard]] std::string resolved(const std::string &unit);
    /// What the user calls the unit that is connected at this place (a key by place); empty: nothing any more. OutOfRange for a
    /// unit that has a serial number. Yields the place on the same line that was called so, and is not any more: a unit stands at one
    /// only, and two that are taken for one would get each other's values.
    [[nodiscard]] Result<std::string> setTag(const std::string &place, const std::string &tag);
    /// Without their files, ordered by unit and then by age, oldest first; of one unit, if it is named.
    [[nodiscard]] Result<std::vector<settings::ParameterSnapshot>> snapshots(const std::string &unit = {});
    /// One with its file: a number, or else the newest of this name. Of one unit, where it is named; else a name that several
    /// units have is OutOfRange, and so is what is not there.
    [[nodiscard]] Result<settings::ParameterSnapshot> find(
        const std::string &nameOrNumber, const std::string &unit = {});
    /// All changes of all units, or of one, oldest first.
    [[nodiscard]] Result<std::vector<settings::SettingsChange>> changes(const std::string &unit);

private:
    [[nodiscard]] Result<void> moveDebts(const std::string &before, const std::string &after);
    [[nodiscard]] double now() const { return unixSeconds(m_clock); }
    [[nodiscard]] Result<std::vector<settings::ParameterSnapshot>> read(
        const std::string &columns, const std::string &rest, const QVariantList &values);
    [[nodiscard]] Result<void> addValues(std::int64_t number, const std::vector<settings::ValueChange> &values);

    Database &m_database;
    const Clock &m_clock;
    std::string m_person;
};

} // namespace mb
