// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "storage/sqlconnection.h"

#include <memory>
#include <string>

class QSqlDatabase;

namespace mb {

/// Where a PostgreSQL server is, and which of its databases is meant.
struct ServerAddress {
    std::string url;
    std::string host; ///< one that begins with / is the folder of a socket
    std::string user;
    std::string database;
    int port = 5432;

    /// `postgresql://[USER@]HOST[:PORT]/DB`, with %2F for a slash in HOST. Usage for other texts.
    [[nodiscard]] static Result<ServerAddress> parse(const std::string &url);
};

/// One connection to a PostgreSQL server; closed when it goes.
class ServerConnection final : public SqlConnection {
public:
    /// Timeout where the server does not answer, Unsupported where this computer has no driver for it.
    [[nodiscard]] static Result<std::unique_ptr<ServerConnection>> open(const ServerAddress &server);
    ~ServerConnection() override;

    [[nodiscard]] Result<void> run(
        const char *statement, const QVariantList &values = {}, const Row &row = {}) override;
    [[nodiscard]] int changed() const override { return m_changed; }
    [[nodiscard]] Result<void> transact(const std::function<Result<void>()> &work) override;

private:
    explicit ServerConnection(std::string name);
    [[nodiscard]] QSqlDatabase connection() const;

    std::string m_name;
    int m_changed = 0;
};

} // namespace mb
