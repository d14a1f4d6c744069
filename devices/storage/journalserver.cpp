// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/journalserver.h"

#include "files/qttext.h"
#include "storage/schema.h"
#include "storage/servicebook.h"

#include <QSqlQuery>

namespace mb {
namespace {

Result<void> runAll(SqlConnection &sql, const char *statements)
{
    for (const QString &statement : QString::fromUtf8(statements).split(QStringLiteral(";\n"), Qt::SkipEmptyParts)) {
        if (statement.trimmed().isEmpty())
            continue;
        MB_TRY_VOID(sql.run(statement.toUtf8().constData()));
    }
    return {};
}

/// 0 before there were any tables.
Result<int> versionOf(SqlConnection &sql)
{
    int version = 0;
    MB_TRY_VOID(sql.run("CREATE TABLE IF NOT EXISTS motorbench_schema (version BIGINT NOT NULL)"));
    MB_TRY_VOID(sql.run("SELECT version FROM motorbench_schema", {},
        [&version](const QSqlQuery &row) { version = row.value(0).toInt(); }));
    return version;
}

/// Two stations may come at the same moment: one of them makes the tables, or brings them up to date.
Result<void> makeTables(SqlConnection &sql)
{
    return sql.transact([&sql]() -> Result<void> {
        auto done = sql.run("SELECT pg_advisory_xact_lock(7733101)");
        if (!done)
            return done;
        const auto versions = journalSchemaVersions();
        const auto newest = static_cast<int>(versions.size());
        MB_TRY(const auto found, versionOf(sql));
        if (found == newest)
            return {};
        if (found > newest)
            return fail(Fault::OutOfRange, say("the journal on the server was made by a newer version of this program"),
                say("use that one"));
        for (int version = found; done && version < newest; ++version)
            done = runAll(sql, versions[static_cast<std::size_t>(version)]);
        if (!done)
            return done;
        return sql.run(found == 0 ? "INSERT INTO motorbench_schema (version) VALUES (?)"
                                  : "UPDATE motorbench_schema SET version = ?",
            {newest});
    });
}

} // namespace

Result<JournalServer> JournalServer::parse(const std::string &url)
{
    MB_TRY(auto address, ServerAddress::parse(url));
    return JournalServer(std::move(address));
}

Result<std::unique_ptr<ServerConnection>> JournalServer::connect() const
{
    auto connection = ServerConnection::open(m_address);
    if (!connection)
        return connection;
    MB_TRY_VOID(makeTables(**connection));
    return connection;
}

Result<void> JournalServer::prepare() const
{
    MB_TRY_VOID(connect());
    return {};
}

Result<void> JournalServer::deliver(const std::vector<KeptVisit> &visits, const std::vector<GivenNumber> &numbers) const
{
    MB_TRY(const auto connection, connect());
    MB_TRY_VOID(putNumbers(*connection, numbers));
    return putVisits(*connection, visits);
}

Result<std::vector<KeptVisit>> JournalServer::visits(const service::VisitFilter &filter) const
{
    MB_TRY(const auto connection, connect());
    return getVisits(*connection, filter);
}

Result<NumberBlock> JournalServer::take(
    const std::string &token, const service::NumberWish &wish, const std::string &station, double time) const
{
    MB_TRY(const auto connection, connect());
    return takeBlock(*connection, token, wish, numbersInBlock, station, time);
}

Result<std::optional<int>> JournalServer::numberOf(const service::NumberWish &wish) const
{
    MB_TRY(const auto connection, connect());
    return mb::numberOf(*connection, wish);
}

} // namespace mb
