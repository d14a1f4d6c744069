// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "service/servicejournal.h"
#include "storage/sqlconnection.h"

#include <string>
#include <vector>

namespace mb {

/// A visit as it is kept, with the number of its writes.
struct KeptVisit {
    service::Visit visit;
    std::int64_t revision = 0;
};

/// In place of what was kept under its id, unless that is newer: the same again changes nothing. Inside a transaction.
[[nodiscard]] Result<void> putVisit(SqlConnection &sql, const KeptVisit &kept);
/// All of them, in one transaction.
[[nodiscard]] Result<void> putVisits(SqlConnection &sql, const std::vector<KeptVisit> &visits);
/// Oldest first.
[[nodiscard]] Result<std::vector<KeptVisit>> getVisits(SqlConnection &sql, const service::VisitFilter &filter);
[[nodiscard]] Result<KeptVisit> getVisit(SqlConnection &sql, const std::string &id);

/// Those that this server, named by its url, has not got yet, or not as they are now, oldest first; at most so many. None of
/// simulated units.
[[nodiscard]] Result<std::vector<KeptVisit>> undelivered(SqlConnection &sql, const std::string &server, int most);
[[nodiscard]] Result<int> countUndelivered(SqlConnection &sql, const std::string &server);
[[nodiscard]] Result<void> markDelivered(
    SqlConnection &sql, const std::string &server, const std::vector<KeptVisit> &visits);

} // namespace mb
