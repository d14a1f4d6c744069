// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/linkowners.h"

#include "model/deviceprofile.h"
#include "transport/linkaddress.h"
#include "widgets/common/devicetext.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>

namespace mb {
namespace {

/// The link without its options: two windows may want different bit rates of one port.
std::string bare(const std::string &address)
{
    auto parsed = LinkAddress::parse(address);
    if (!parsed)
        return address;
    parsed->options.clear();
    return parsed->text();
}

bool isHardware(const std::string &address)
{
    const auto parsed = LinkAddress::parse(address);
    return parsed && !parsed->isSimulated() && !parsed->isRecording() && parsed->scheme != "unix";
}

QString processText(const QString &name, qint64 number)
{
    return LinkOwners::tr("%1, process %2").arg(name).arg(number);
}

} // namespace

QString holderOf(const QString &file, const QString &processes)
{
    const QString target = QFileInfo(file).canonicalFilePath();
    if (target.isEmpty())
        return {};
    for (const QString &number : QDir(processes).entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
        bool isNumber = false;
        const qint64 process = number.toLongLong(&isNumber);
        if (!isNumber || process == QCoreApplication::applicationPid())
            continue;
        const QDir open(processes + QLatin1Char('/') + number + QStringLiteral("/fd"));
        for (const QFileInfo &entry :
            open.entryInfoList(QDir::Files | QDir::System | QDir::Dirs | QDir::NoDotAndDotDot)) {
            if (entry.symLinkTarget() != target)
                continue;
            QFile name(processes + QLatin1Char('/') + number + QStringLiteral("/comm"));
            return processText(
                name.open(QIODevice::ReadOnly) ? QString::fromUtf8(name.readAll()).trimmed() : number, process);
        }
    }
    return {};
}

LinkOwners::LinkOwners(Workbench &workbench, const QString &folder, QObject *parent)
    : QObject(parent)
    , m_workbench(workbench)
    , m_folder(folder)
{
    QDir().mkpath(folder);
    connect(&workbench, &Workbench::changed, this, &LinkOwners::follow);
}

QString LinkOwners::fileOf(const std::string &address) const
{
    return m_folder + QLatin1Char('/') + QString::fromStdString(fileNameOf(bare(address))) + QStringLiteral(".lock");
}

QString LinkOwners::otherOwner(const std::string &address) const
{
    const QLockFile lock(fileOf(address));
    qint64 process = 0;
    QString computer;
    QString program;
    if (!lock.getLockInfo(&process, &computer, &program) || process == QCoreApplication::applicationPid()
        || !QFile::exists(QStringLiteral("/proc/%1").arg(process)))
        return {};
    return processText(program, process);
}

void LinkOwners::follow()
{
    const Snapshot &shot = m_workbench.snapshot();
    for (auto entry = m_locks.begin(); entry != m_locks.end();) {
        if (shot.link(entry->first)) {
            ++entry;
            continue;
        }
        m_told.erase(entry->first);
        entry = m_locks.erase(entry); // unlocks it
    }
    for (const LinkView &link : shot.links) {
        if (isHardware(link.address) && m_locks.find(link.address) == m_locks.end())
            take(link);
    }
    for (const FailedLink &link : shot.failed)
        explain(link);
}

void LinkOwners::take(const LinkView &link)
{
    auto lock = std::make_unique<QLockFile>(fileOf(link.address));
    lock->setStaleLockTime(0);
    if (!lock->tryLock() && lock->error() == QLockFile::LockFailedError) { // not: its folder is full
        const QString owner = otherOwner(link.address);
        m_workbench.report(Severity::Caution, qt(link.name),
            tr("%1 has this link too. Agree who drives: two masters on one motor disturb each other.").arg(owner));
        Q_EMIT shared(qt(link.name), owner);
    }
    m_locks.emplace(link.address, std::move(lock)); // held or not: asked once
}

/// A port that cannot be opened because somebody has it.
void LinkOwners::explain(const FailedLink &link)
{
    if (link.diagnosis.ailment != Ailment::Busy || !m_told.insert(link.address).second)
        return;
    const auto address = LinkAddress::parse(link.address);
    QString owner = otherOwner(link.address);
    if (owner.isEmpty() && address)
        owner = holderOf(qt(address->path));
    if (!owner.isEmpty())
        m_workbench.report(Severity::Caution, qt(address ? address->shortName() : link.address),
            tr("%1 has this port. Close it there, then reconnect.").arg(owner));
}

} // namespace mb
