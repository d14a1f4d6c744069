// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/seconds.h"
#include "service/servicejournal.h"
#include "storage/database.h"
#include "storage/numbertable.h"
#include "storage/visittable.h"

namespace mb {

/// The journal of service in the user's own file. Thread of the database, which outlives it. Fails with NotKept and the cause
/// on a full disk, or a file that cannot be written; nothing was changed then.
class ServiceBook final : public service::ServiceJournal {
public:
    /// The clock gives the time of day; entries are kept under `station` and `person`.
    ServiceBook(Database &database, const Clock &clock, std::string station, std::string person);

    [[nodiscard]] Task<service::Visit> open(service::Visit visit) override;
    [[nodiscard]] Task<service::Visit> write(service::Visit visit) override;
    [[nodiscard]] Task<std::vector<service::Visit>> visits(service::VisitFilter filter) override;
    [[nodiscard]] Task<std::optional<int>> number(service::NumberWish wish) override;

    /// The same at once.
    [[nodiscard]] Result<std::vector<service::Visit>> list(const service::VisitFilter &filter);
    /// A note of the operator on an entry.
    [[nodiscard]] Result<void> setNote(const std::string &visit, const std::string &note);
    /// Name of the last run of this recipe on this station, to be resumed; empty: there is none. The last that was written down,
    /// whatever the clock of the computer said. Refused while another program that has begun it still runs.
    [[nodiscard]] Result<std::string> lastRun(const std::string &recipe, bool simulated);

    [[nodiscard]] Database &database() const { return m_database; }
    [[nodiscard]] const std::string &station() const { return m_station; }
    [[nodiscard]] double now() const { return unixSeconds(m_clock); }

private:
    [[nodiscard]] Result<service::Visit> put(service::Visit visit, bool isNew);

    Database &m_database;
    const Clock &m_clock;
    std::string m_station;
    std::string m_person;
};

constexpr int numbersInBlock = 5; ///< that a station reserves together

} // namespace mb
