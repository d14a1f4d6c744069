// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/envelopebook.h"

#include "experiment/envelope.h"
#include "files/filebytes.h"
#include "widgets/common/devicetext.h"

#include <QDir>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLockFile>

namespace mb {
namespace {

constexpr std::int64_t largestFile = 1'000'000;
constexpr int lockTime = 5000; ///< ms

const QLatin1String kindKey("motorbench");
const QLatin1String fileKind("experiment limits");
const QLatin1String unitsKey("units");
const QLatin1String enteredKey("entered");
const QLatin1String namedKey("named");

/// None where there is no file.
Result<QJsonObject> unitsIn(const QString &file)
{
    if (!QFileInfo::exists(file))
        return QJsonObject();
    const auto bytes = loadFile(file.toStdString(), largestFile);
    if (!bytes)
        return fail(Fault::OutOfRange, bytes.error().detail, say("remove it, or make it readable"));
    const QJsonObject all = QJsonDocument::fromJson(*bytes).object();
    if (all.value(kindKey).toString() != fileKind)
        return fail(Fault::OutOfRange, say("%1 holds no limits of experiments", file.toStdString()), say("remove it"));
    return all.value(unitsKey).toObject();
}

/// Another window may have entered something for other units since the file was read.
Result<void> writeUnit(const QString &file, const QString &name, const QJsonObject &unit)
{
    QDir().mkpath(QFileInfo(file).path());
    QLockFile lock(file + QStringLiteral(".lock"));
    (void)lock.tryLock(lockTime); // where none can be made nobody else writes either
    MB_TRY(QJsonObject units, unitsIn(file));
    units.insert(name, unit);
    return saveFile(
        file.toStdString(), QJsonDocument(QJsonObject{{kindKey, QString(fileKind)}, {unitsKey, units}}).toJson());
}

} // namespace

Result<void> EnvelopeBook::open(const QString &file)
{
    finish();
    m_file.clear(); // what is not ours is not written over
    m_units.clear();
    MB_TRY(const QJsonObject units, unitsIn(file));
    for (auto unit = units.begin(); unit != units.end(); ++unit) {
        Unit &read = m_units[unit.key().toStdString()];
        const QJsonObject object = unit.value().toObject();
        read.entered = tuning::limitsFrom(object.value(enteredKey).toObject());
        const QJsonObject named = object.value(namedKey).toObject();
        for (auto limits = named.begin(); limits != named.end(); ++limits)
            read.named.emplace(limits.key(), tuning::limitsFrom(limits.value().toObject()));
    }
    m_file = file;
    return {};
}

void EnvelopeBook::write(const std::string &name)
{
    if (m_file.isEmpty())
        return;
    const Unit &unit = m_units.at(name);
    QJsonObject named;
    for (const auto &[title, limits] : unit.named)
        named.insert(title, tuning::limitsToJson(limits));
    const QString key = QString::fromStdString(name);
    const QJsonObject object{{enteredKey, tuning::limitsToJson(unit.entered)}, {namedKey, named}};
    m_disk.order(
        key, [file = m_file, key, object] { return writeUnit(file, key, object); },
        [this](const Result<void> &written) {
            if (!written)
                Q_EMIT failed(errorText(written.error()));
        });
}

Envelope EnvelopeBook::entered(const std::string &unit) const
{
    const auto found = m_units.find(unit);
    return found == m_units.end() ? Envelope() : found->second.entered;
}

void EnvelopeBook::enter(const std::string &unit, const Envelope &limits)
{
    if (unit.empty() || entered(unit) == limits)
        return;
    m_units[unit].entered = limits;
    write(unit);
}

void EnvelopeBook::carry(const std::string &from, const std::string &to)
{
    const auto found = m_units.find(from);
    if (to.empty() || found == m_units.end() || m_units.count(to) > 0)
        return;
    const Unit unit = found->second;
    m_units.emplace(to, unit);
    write(to);
}

QStringList EnvelopeBook::names(const std::string &unit) const
{
    QStringList all;
    const auto found = m_units.find(unit);
    if (found == m_units.end())
        return all;
    for (const auto &[name, limits] : found->second.named)
        all << name;
    return all;
}

Envelope EnvelopeBook::named(const std::string &unit, const QString &name) const
{
    const auto found = m_units.find(unit);
    if (found == m_units.end())
        return {};
    const auto limits = found->second.named.find(name);
    return limits == found->second.named.end() ? Envelope() : limits->second;
}

void EnvelopeBook::keep(const std::string &unit, const QString &name, const Envelope &limits)
{
    if (unit.empty() || name.trimmed().isEmpty())
        return;
    m_units[unit].named[name.trimmed()] = limits;
    write(unit);
}

void EnvelopeBook::forget(const std::string &unit, const QString &name)
{
    const auto found = m_units.find(unit);
    if (found != m_units.end() && found->second.named.erase(name) > 0)
        write(unit);
}

} // namespace mb
