// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/serverconnection.h"

#include "files/qttext.h"
#include "wire/number.h"

#include <QSqlDatabase>
#include <QSqlError>
#include <QSqlQuery>
#include <QUrl>

#include <algorithm>
#include <array>
#include <atomic>

namespace mb {
namespace {

const QString driver = QStringLiteral("QPSQL");
constexpr std::string_view scheme = "postgresql://";
/// Classes of errors that another try may not meet: broken connection, transaction of another state (a standby takes no writes),
/// conflict of two, full tables, somebody else's lock, ended by its operator or by a time-out.
constexpr std::array<std::string_view, 6> passing{"08", "25", "40", "53", "55", "57"};

tl::unexpected<Error> badUrl(const std::string &text)
{
    return fail(Fault::Usage, say("'%1' is no journal that stations share", text),
        say("such as %1", "postgresql://USER@HOST/DB"));
}

} // namespace

Result<ServerAddress> ServerAddress::parse(const std::string &url)
{
    if (!url.starts_with(scheme))
        return badUrl(url);
    std::string rest = url.substr(scheme.size());
    ServerAddress server;
    server.url = url;
    if (const auto at = rest.find('@'); at != std::string::npos) {
        server.user = QUrl::fromPercentEncoding(QByteArray::fromStdString(rest.substr(0, at))).toStdString();
        rest.erase(0, at + 1);
    }
    const auto slash = rest.rfind('/');
    if (slash == std::string::npos || slash + 1 == rest.size() || server.user.find(':') != std::string::npos)
        return badUrl(url);
    server.database = rest.substr(slash + 1);
    std::string host = rest.substr(0, slash);
    const auto bracket = host.rfind(']'); // colons before it are of an address such as [::1]
    if (const auto colon = host.rfind(':');
        colon != std::string::npos && (bracket == std::string::npos || colon > bracket)) {
        const auto port = wholeFrom<int>(host.substr(colon + 1));
        if (!port || *port < 1 || *port > 65535)
            return badUrl(url);
        server.port = *port;
        host.erase(colon);
    }
    if (host.starts_with('[') && host.ends_with(']'))
        host = host.substr(1, host.size() - 2);
    server.host = QUrl::fromPercentEncoding(QByteArray::fromStdString(host)).toStdString();
    if (server.host.empty())
        return badUrl(url);
    return server;
}

ServerConnection::ServerConnection(std::string name)
    : m_name(std::move(name))
{
}

ServerConnection::~ServerConnection()
{
    connection().close();
    QSqlDatabase::removeDatabase(qt(m_name));
}

QSqlDatabase ServerConnection::connection() const
{
    return QSqlDatabase::database(qt(m_name), false);
}

Result<std::unique_ptr<ServerConnection>> ServerConnection::open(const ServerAddress &server)
{
    static std::atomic<int> count{0};
    if (!QSqlDatabase::isDriverAvailable(driver))
        return fail(Fault::Unsupported, say("this computer has no driver for PostgreSQL"),
            say("install %1", "libqt5sql5-psql"));
    std::unique_ptr<ServerConnection> made(new ServerConnection("motorbench-server-" + std::to_string(++count)));
    QSqlDatabase database = QSqlDatabase::addDatabase(driver, qt(made->m_name));
    database.setHostName(qt(server.host));
    database.setPort(server.port);
    database.setDatabaseName(qt(server.database));
    database.setUserName(qt(server.user));
    database.setConnectOptions(QStringLiteral("connect_timeout=2;tcp_user_timeout=5000"));
    if (!database.open())
        return fail(Fault::Timeout,
            say("%1 does not answer: %2", server.url, database.lastError().databaseText().trimmed().toStdString()),
            say("see that the server runs; entries wait here until it does"));
    for (const char *const setting :
        {"SET client_min_messages TO WARNING", "SET statement_timeout = 5000", "SET lock_timeout = 3000",
            "SET idle_in_transaction_session_timeout = 10000", "SET synchronous_commit = on"}) {
        MB_TRY_VOID(made->run(setting));
    }
    return made;
}

Result<void> ServerConnection::run(const char *statement, const QVariantList &values, const Row &row)
{
    QSqlQuery query(connection());
    query.setForwardOnly(true);
    bool good
        = values.isEmpty() ? query.exec(QString::fromUtf8(statement)) : query.prepare(QString::fromUtf8(statement));
    for (int i = 0; good && i < values.size(); ++i)
        query.bindValue(i, values.at(i));
    good = good && (values.isEmpty() || query.exec());
    while (good && query.next()) {
        if (row)
            row(query);
    }
    if (!good || query.lastError().isValid()) { // the server may end a query between two rows
        const std::string code = query.lastError().nativeErrorCode().toStdString();
        const bool silent = code.empty()
            || std::ranges::any_of(passing, [&code](std::string_view each) { return code.starts_with(each); });
        return fail(silent ? Fault::Timeout : Fault::OutOfRange,
            say("the journal's server: %1", query.lastError().databaseText().trimmed().toStdString()));
    }
    m_changed = query.numRowsAffected();
    return {};
}

Result<void> ServerConnection::transact(const std::function<Result<void>()> &work)
{
    MB_TRY_VOID(run("BEGIN"));
    auto worked = work();
    if (worked)
        worked = run("COMMIT");
    if (!worked)
        (void)run("ROLLBACK");
    return worked;
}

} // namespace mb
