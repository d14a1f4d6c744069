// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>

#include <unistd.h>

#include <string>

namespace mb::test {

/// A PostgreSQL server of one's own: on a socket in a temporary folder, as an ordinary user, gone with this.
class PostgresServer {
public:
    PostgresServer()
    {
        const QStringList versions
            = QDir(QStringLiteral("/usr/lib/postgresql")).entryList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name);
        for (const QString &version : versions) {
            const QString folder = QStringLiteral("/usr/lib/postgresql/%1/bin/").arg(version);
            if (QFile::exists(folder + QStringLiteral("initdb")))
                m_programs = folder;
        }
        if (!isInstalled())
            return;
        if (::geteuid() == 0) // its programs refuse root
            run(QStringLiteral("/usr/bin/chown"), {QStringLiteral("nobody"), m_folder.path()}, false);
        m_isReady = run(m_programs + QStringLiteral("initdb"),
            {QStringLiteral("-D"), data(), QStringLiteral("-A"), QStringLiteral("trust"), QStringLiteral("-U"),
                QStringLiteral("motorbench"), QStringLiteral("-E"), QStringLiteral("UTF8"),
                QStringLiteral("--locale=C"), QStringLiteral("--no-sync")});
    }
    PostgresServer(const PostgresServer &) = delete;
    PostgresServer &operator=(const PostgresServer &) = delete;
    ~PostgresServer() { stop(); }

    [[nodiscard]] bool isInstalled() const { return !m_programs.isEmpty(); }
    bool start()
    {
        m_isRunning = m_isReady
            && control({QStringLiteral("start"), QStringLiteral("-o"),
                QStringLiteral("-F -k %1 -c listen_addresses=''").arg(m_folder.path())});
        return m_isRunning;
    }
    /// At once, as when its computer loses power.
    void stop()
    {
        if (std::exchange(m_isRunning, false))
            control({QStringLiteral("stop"), QStringLiteral("-m"), QStringLiteral("immediate")});
    }
    [[nodiscard]] std::string url() const
    {
        QString folder = m_folder.path();
        return "postgresql://motorbench@" + folder.replace(QLatin1Char('/'), QStringLiteral("%2F")).toStdString()
            + "/postgres";
    }

private:
    [[nodiscard]] QString data() const { return m_folder.path() + QStringLiteral("/data"); }
    bool control(QStringList arguments)
    {
        arguments << QStringLiteral("-D") << data() << QStringLiteral("-w") << QStringLiteral("-l")
                  << m_folder.path() + QStringLiteral("/log");
        return run(m_programs + QStringLiteral("pg_ctl"), arguments);
    }
    static bool run(const QString &program, QStringList arguments, bool asUser = true)
    {
        QProcess process;
        process.setStandardOutputFile(QProcess::nullDevice()); // the server inherits it, and would hold a pipe open
        process.setStandardErrorFile(QProcess::nullDevice());
        process.setWorkingDirectory(QDir::tempPath());
        if (asUser && ::geteuid() == 0) {
            arguments.prepend(program);
            arguments = QStringList{QStringLiteral("--reuid=nobody"), QStringLiteral("--regid=nogroup"),
                            QStringLiteral("--clear-groups"), QStringLiteral("--")}
                + arguments;
            process.start(QStringLiteral("setpriv"), arguments);
        } else {
            process.start(program, arguments);
        }
        return process.waitForFinished(60000) && process.exitStatus() == QProcess::NormalExit
            && process.exitCode() == 0;
    }
    QTemporaryDir m_folder{QDir::tempPath() + QStringLiteral("/server-XXXXXX")};
    QString m_programs;
    bool m_isReady = false;
    bool m_isRunning = false;
};

} // namespace mb::test
