// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/database.h"

#include "files/qttext.h"
#include "storage/schema.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSqlDatabase>
#include <QSqlError>
#include <QSqlQuery>
#include <QUrl>

#include <atomic>

namespace mb {
namespace {

// Primary result codes of SQLite.
constexpr int otherTables = 1;   // SQLITE_ERROR: a table or column is not there
constexpr int heldByAnother = 5; // SQLITE_BUSY
constexpr int notReached = 10;   // SQLITE_IOERR
constexpr int damaged = 11;      // SQLITE_CORRUPT
constexpr int diskIsFull = 13;   // SQLITE_FULL
constexpr int notADatabase = 26; // SQLITE_NOTADB

Message remedyOf(int code, const std::string &path)
{
    switch (code) {
    case otherTables: return say("move it away");
    case heldByAnother: return say("another program holds it: try again when that has ended");
    case notReached: return say("look whether its disk is there, has room and is in order");
    case damaged:
        return say("'sqlite3 %1 .recover' tells what it still holds; where it is moved away, a new one is begun", path);
    case diskIsFull: return say("make room on its disk");
    default: return {};
    }
}

std::string nextConnection()
{
    static std::atomic<int> count{0};
    return "motorbench-" + std::to_string(++count);
}

QString freeName(const QString &path)
{
    QString name = path + QStringLiteral(".damaged");
    for (int i = 2; QFile::exists(name); ++i)
        name = path + QStringLiteral(".damaged-%1").arg(i);
    return name;
}

/// Beside a file with a write-ahead log SQLite wants to make another, for reading, too. Where it cannot, and no program that could
/// write has the file open, it is told that the file does not change.
QString readOnlyName(const QFileInfo &file)
{
    const QString path = file.absoluteFilePath();
    const bool alone = !QFileInfo(file.absolutePath()).isWritable() && !QFile::exists(path + QStringLiteral("-wal"));
    return QStringLiteral("file:") + QString::fromLatin1(QUrl::toPercentEncoding(path, "/"))
        + (alone ? QStringLiteral("?immutable=1") : QString());
}

} // namespace

Database::Database(std::string path, std::string connection)
    : m_path(std::move(path))
    , m_connection(std::move(connection))
{
}

Database::~Database()
{
    close();
}

QSqlDatabase Database::connection() const
{
    return QSqlDatabase::database(qt(m_connection), false);
}

void Database::close()
{
    connection().close();
    QSqlDatabase::removeDatabase(qt(m_connection));
}

Result<std::unique_ptr<Database>> Database::open(const std::string &path)
{
    const QFileInfo file(qt(path));
    if (!QDir().mkpath(file.absolutePath()))
        return fail(Fault::NotKept, say("%1 cannot be made", file.absolutePath().toStdString()),
            say("check the rights of the folder above it"));
    std::unique_ptr<Database> database(new Database(path, nextConnection()));
    auto connected = database->connect();
    const int code = database->m_lastCode;
    if (!connected && (code == damaged || code == notADatabase)) {
        MB_TRY_VOID(database->putAside());
        connected = database->connect();
    }
    if (!connected)
        return fail(connected.error());
    return database;
}

Result<void> Database::connect()
{
    if (QSqlDatabase::contains(qt(m_connection)))
        close();
    const QFileInfo file(qt(m_path));
    const bool takesFiles = QFileInfo(file.absolutePath()).isWritable(); // its log stands beside it
    m_readOnly = !takesFiles || (file.exists() && !file.isWritable());
    if (m_readOnly && !file.exists())
        return fail(
            Fault::NotKept, say("%1 cannot be written", file.absolutePath().toStdString()), say("check its rights"));
    QSqlDatabase made = QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), qt(m_connection));
    made.setDatabaseName(m_readOnly ? readOnlyName(file) : qt(m_path));
    made.setConnectOptions(QStringLiteral("QSQLITE_BUSY_TIMEOUT=5000")
        + (m_readOnly ? QStringLiteral(";QSQLITE_OPEN_READONLY;QSQLITE_OPEN_URI") : QString()));
    if (!made.open())
        return fail(Fault::NotKept, say("%1 cannot be opened: %2", m_path, made.lastError().text().toStdString()),
            say("move it away"));
    auto prepared = m_readOnly ? Result<void>() : prepare();
    return prepared ? run("SELECT 1 FROM trial LIMIT 1") : prepared;
}

Result<void> Database::prepare()
{
    for (const char *const setting :
        {"PRAGMA journal_mode = WAL", "PRAGMA synchronous = FULL", "PRAGMA foreign_keys = ON"}) {
        MB_TRY_VOID(run(setting));
    }
    return migrate();
}

Result<void> Database::migrate()
{
    const auto versions = schemaVersions();
    const auto newest = static_cast<int>(versions.size());
    return transact([this, versions, newest]() -> Result<void> {
        int version = 0;
        if (auto read = run("PRAGMA user_version", {}, [&](const QSqlQuery &row) { version = row.value(0).toInt(); });
            !read)
            return read;
        if (version > newest)
            return fail(Fault::NotKept,
                say("%1 was made by a newer version of this program (schema %2, known here is %3)", m_path, version,
                    newest),
                say("use that one"));
        if (version == newest)
            return {};
        for (; version < newest; ++version) {
            const QStringList statements = QString::fromUtf8(versions[static_cast<std::size_t>(version)])
                                               .split(QStringLiteral(";\n"), Qt::SkipEmptyParts);
            for (const QString &statement : statements)
                MB_TRY_VOID(run(statement.toUtf8().constData()));
        }
        return run(("PRAGMA user_version = " + std::to_string(newest)).c_str());
    });
}

Result<void> Database::putAside()
{
    close();
    const QString aside = freeName(qt(m_path));
    if (!QFile::rename(qt(m_path), aside))
        return fail(Fault::NotKept, say("%1 is damaged and cannot be put aside", m_path), say("move it away"));
    for (const char *const part : {"-wal", "-shm"}) // of the damaged one: they must not be taken for the new one's
        QFile::rename(qt(m_path) + QLatin1String(part), aside + QLatin1String(part));
    m_remark = m_path + " was damaged: it was put aside as " + aside.toStdString() + ", and a new one begun";
    return {};
}

Result<void> Database::run(const char *statement, const QVariantList &values, const Row &row)
{
    QSqlQuery query(connection());
    query.setForwardOnly(true);
    bool good = query.prepare(QString::fromUtf8(statement));
    for (int i = 0; good && i < values.size(); ++i)
        query.bindValue(i, values.at(i));
    good = good && query.exec();
    while (good && query.next()) {
        if (row)
            row(query);
    }
    m_lastCode = query.lastError().nativeErrorCode().toInt() & 0xFF; // of an extended code the primary one
    if (!good || query.lastError().isValid())
        return fail(Fault::NotKept, say("%1: %2", m_path, query.lastError().databaseText().toStdString()),
            remedyOf(m_lastCode, m_path));
    m_lastRow = query.lastInsertId().toLongLong();
    m_changed = query.numRowsAffected();
    return {};
}

Result<void> Database::transact(const std::function<Result<void>()> &work)
{
    MB_TRY_VOID(run("BEGIN IMMEDIATE"));
    auto worked = work();
    const int code = m_lastCode;
    if (worked) {
        worked = run("COMMIT");
        if (worked)
            return {};
    }
    (void)run("ROLLBACK");
    m_lastCode = code;
    return worked;
}

} // namespace mb
