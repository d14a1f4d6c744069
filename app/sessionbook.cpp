// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sessionbook.h"

#include "files/filebytes.h"

#include <QCoreApplication>
#include <QDir>

namespace mb {
namespace {

constexpr std::int64_t largestSession = 1 << 20;

QString lockOf(const QString &file)
{
    return file + QStringLiteral(".lock");
}

} // namespace

SessionBook::SessionBook(const QString &folder)
    : m_folder(folder)
{
}

Result<void> SessionBook::begin(qint64 begun)
{
    if (!QDir().mkpath(m_folder))
        return fail(Fault::OutOfRange, say("the folder %1 cannot be made", m_folder.toStdString()));
    m_file = m_folder
        + QStringLiteral("/%1-%2.json").arg(begun, 12, 10, QLatin1Char('0')).arg(QCoreApplication::applicationPid());
    m_lock = std::make_unique<QLockFile>(lockOf(m_file));
    m_lock->setStaleLockTime(0);
    if (!m_lock->tryLock())
        return fail(Fault::OutOfRange, say("%1 is locked by another program", m_file.toStdString()));
    tidy();
    return {};
}

Result<void> SessionBook::save(const SessionRecord &record) const
{
    return m_file.isEmpty() ? Result<void>{} : saveFile(m_file.toStdString(), record.toJson());
}

bool SessionBook::isRunning(const QString &file)
{
    QLockFile lock(lockOf(file));
    lock.setStaleLockTime(0);
    return !lock.tryLock(); // one whose program is gone is broken by this
}

std::vector<SessionBook::Entry> SessionBook::earlier() const
{
    std::vector<Entry> entries;
    const QDir folder(m_folder);
    const QStringList names
        = folder.entryList({QStringLiteral("*.json")}, QDir::Files, QDir::Name | QDir::Reversed); // by their beginning
    for (const QString &name : names) {
        const QString file = folder.filePath(name);
        if (file == m_file || isRunning(file))
            continue;
        const auto bytes = loadFile(file.toStdString(), largestSession);
        const auto record = bytes ? SessionRecord::fromJson(*bytes)
                                  : Result<SessionRecord>{fail(Fault::OutOfRange, say("unreadable"))};
        if (record && record->isWorthKeeping())
            entries.push_back({file, *record});
    }
    return entries;
}

std::optional<SessionBook::Entry> SessionBook::crashed() const
{
    for (Entry &entry : earlier()) {
        if (!entry.record.ended)
            return std::move(entry);
    }
    return std::nullopt;
}

void SessionBook::settle(const Entry &entry) const
{
    SessionRecord record = entry.record;
    record.ended = true;
    (void)saveFile(entry.file.toStdString(), record.toJson()); // else it is asked about once more
}

void SessionBook::tidy() const
{
    const QDir folder(m_folder);
    const QStringList names = folder.entryList({QStringLiteral("*.json")}, QDir::Files, QDir::Name | QDir::Reversed);
    for (const QString &name : names.mid(most)) {
        if (!isRunning(folder.filePath(name)))
            QFile::remove(folder.filePath(name));
    }
}

} // namespace mb
