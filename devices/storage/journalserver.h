// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "service/servicejournal.h"
#include "storage/numbertable.h"
#include "storage/serverconnection.h"
#include "storage/visittable.h"

#include <optional>
#include <string>
#include <vector>

namespace mb {

/// A PostgreSQL server that several stations share their journal on, with the same tables as the file. A value: each call
/// opens a connection of its own, waits for the server (2 s for it to answer, 5 s for a statement) and closes it, in any thread.
/// Fails with Timeout where it does not answer, with OutOfRange and its words where it refuses.
class JournalServer {
public:
    explicit JournalServer(ServerAddress address)
        : m_address(std::move(address))
    {
    }
    /// ServerAddress::parse().
    [[nodiscard]] static Result<JournalServer> parse(const std::string &url);

    /// Makes the tables where there are none. OutOfRange when they are of a newer version.
    [[nodiscard]] Result<void> prepare() const;
    /// In place of what is there, unless that is newer: the same again changes nothing. With the numbers that they were given.
    [[nodiscard]] Result<void> deliver(
        const std::vector<KeptVisit> &visits, const std::vector<GivenNumber> &numbers = {}) const;
    [[nodiscard]] Result<std::vector<KeptVisit>> visits(const service::VisitFilter &filter) const;
    /// takeBlock() there.
    [[nodiscard]] Result<NumberBlock> take(
        const std::string &token, const service::NumberWish &wish, const std::string &station, double time) const;

    /// numberOf() there.
    [[nodiscard]] Result<std::optional<int>> numberOf(const service::NumberWish &wish) const;
    [[nodiscard]] const std::string &url() const { return m_address.url; }

private:
    [[nodiscard]] Result<std::unique_ptr<ServerConnection>> connect() const;

    ServerAddress m_address;
};

/// Where the journal of service is kept. A value.
struct JournalPlace {
    std::string station;                 ///< name of this one in it
    std::optional<JournalServer> server; ///< that stations share; nothing: this computer's file alone
};

} // namespace mb
