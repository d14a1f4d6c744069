// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/settingsbook.h"

#include "files/qttext.h"
#include "model/unit.h"
#include "storage/sqltext.h"
#include "storage/unittags.h"

#include <QSqlQuery>
#include <QVariant>

#include <algorithm>

namespace mb {
namespace {

using settings::ParameterSnapshot;
using settings::SettingsChange;
using settings::ValueChange;

const std::string listed = "SELECT id, time, unit, device, family, serial, firmware, name, occasion, count";
const std::string whole = listed + ", file";

ParameterSnapshot snapshotOf(const QSqlQuery &row, bool isWhole)
{
    ParameterSnapshot snapshot;
    snapshot.number = row.value(0).toLongLong();
    snapshot.time = row.value(1).toDouble();
    snapshot.unit = textAt(row, 2);
    snapshot.device = textAt(row, 3);
    snapshot.family = textAt(row, 4);
    snapshot.serial = textAt(row, 5);
    snapshot.firmware = textAt(row, 6);
    snapshot.name = textAt(row, 7);
    snapshot.occasion = settings::occasionFromString(textAt(row, 8));
    snapshot.count = row.value(9).toInt();
    if (isWhole)
        snapshot.file = textAt(row, 10);
    return snapshot;
}

SettingsChange changeOf(const QSqlQuery &row)
{
    SettingsChange change;
    change.number = row.value(0).toLongLong();
    change.time = row.value(1).toDouble();
    change.unit = textAt(row, 2);
    change.device = textAt(row, 3);
    change.person = textAt(row, 4);
    change.origin = settings::originFromString(textAt(row, 5));
    change.purpose = settings::purposeFromString(textAt(row, 6));
    if (!row.value(7).isNull())
        change.of = row.value(7).toLongLong();
    return change;
}

ValueChange valueOf(const QSqlQuery &row, int from)
{
    ValueChange value;
    value.key = textAt(row, from);
    if (!row.value(from + 1).isNull())
        value.before = row.value(from + 1).toLongLong();
    value.after = row.value(from + 2).toLongLong();
    value.proof = settings::proofFromString(textAt(row, from + 3));
    return value;
}

QVariant orNull(const std::optional<std::int64_t> &number)
{
    return number ? QVariant(static_cast<qint64>(*number)) : QVariant(QVariant::LongLong);
}

} // namespace

SettingsBook::SettingsBook(Database &database, const Clock &clock, std::string person)
    : m_database(database)
    , m_clock(clock)
    , m_person(std::move(person))
{
}

std::string SettingsBook::resolved(const std::string &unit)
{
    return resolvedUnit(m_database, unit);
}

Result<std::string> SettingsBook::setTag(const std::string &place, const std::string &tag)
{
    if (unitByOf(place) != UnitBy::Place)
        return fail(Fault::OutOfRange, say("a unit that has a serial number needs no tag"));
    const QString line = qt(renumberedPlaceKey(place, 0)).chopped(1);
    std::string left;
    MB_TRY_VOID(m_database.transact([&]() -> Result<void> {
        const std::string before = resolved(place);
        MB_TRY_VOID(tag.empty() ? m_database.run("DELETE FROM tag WHERE place = ?", {qt(place)})
                                : m_database.run("INSERT OR REPLACE INTO tag (place, name, time) VALUES (?, ?, ?)",
                                    {qt(place), qt(tag), now()}));
        MB_TRY_VOID(moveDebts(before, resolved(place)));
        const std::string others = "FROM tag WHERE name = ? AND place <> ? AND substr(place, 1, length(?)) = ?";
        const QVariantList which{qt(tag), qt(place), line, line};
        MB_TRY_VOID(m_database.run(
            ("SELECT place " + others).c_str(), which, [&left](const QSqlQuery &row) { left = textAt(row, 0); }));
        return m_database.run(("DELETE " + others).c_str(), which);
    }));
    return left;
}

/// What is owed to a unit goes with it to its new name; not to one that is known elsewhere, nor from one that still is.
Result<void> SettingsBook::moveDebts(const std::string &before, const std::string &after)
{
    int ofBefore = 0;
    int ofAfter = 0;
    auto counted = m_database.run(
        "SELECT place, name FROM tag", {}, [&ofBefore, &ofAfter, &before, &after](const QSqlQuery &row) {
            const std::string key = taggedUnitKey(textAt(row, 0), textAt(row, 1));
            ofBefore += key == before ? 1 : 0;
            ofAfter += key == after ? 1 : 0;
        });
    const bool isOnly = ofBefore == 0 && ofAfter == (unitByOf(after) == UnitBy::Tag ? 1 : 0);
    if (!counted || before == after || !isOnly)
        return counted;
    return m_database.run("UPDATE OR IGNORE owed SET unit = ? WHERE unit = ?", {qt(after), qt(before)});
}

Task<void> SettingsBook::moved(std::string from, std::string to)
{
    if (from == to)
        co_return {};
    co_return m_database.transact([&]() -> Result<void> {
        const std::string before = resolved(from);
        MB_TRY_VOID(m_database.run("DELETE FROM tag WHERE place = ?", {qt(to)}));
        MB_TRY_VOID(m_database.run("UPDATE tag SET place = ? WHERE place = ?", {qt(to), qt(from)}));
        return moveDebts(before, resolved(to));
    });
}

Task<ParameterSnapshot> SettingsBook::keep(ParameterSnapshot snapshot)
{
    snapshot.time = now();
    snapshot.unit = resolved(snapshot.unit);
    const auto added = m_database.run(
        "INSERT INTO snapshot (time, unit, device, family, serial, firmware, name, occasion, count, file) "
        "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)",
        {snapshot.time, qt(snapshot.unit), qt(snapshot.device), qt(snapshot.family), qt(snapshot.serial),
            qt(snapshot.firmware), qt(snapshot.name), qt(toString(snapshot.occasion)), snapshot.count,
            qt(snapshot.file)});
    if (!added)
        co_return fail(added.error());
    snapshot.number = m_database.lastRow();
    co_return snapshot;
}

Task<std::int64_t> SettingsBook::begin(SettingsChange change)
{
    std::int64_t number = 0;
    const auto added = m_database.transact([&]() -> Result<void> {
        MB_TRY_VOID(m_database.run(
            "INSERT INTO change (time, unit, device, person, origin, purpose, of) VALUES (?, ?, ?, ?, ?, ?, ?)",
            {now(), qt(resolved(change.unit)), qt(change.device), qt(m_person), qt(toString(change.origin)),
                qt(toString(change.purpose)), orNull(change.of)}));
        number = m_database.lastRow();
        return addValues(number, change.values);
    });
    if (!added)
        co_return fail(added.error());
    co_return number;
}

Task<void> SettingsBook::complete(std::int64_t number, std::vector<ValueChange> values)
{
    co_return m_database.transact([&]() -> Result<void> {
        MB_TRY_VOID(m_database.run("DELETE FROM changed_value WHERE change = ?", {static_cast<qint64>(number)}));
        return addValues(number, values);
    });
}

Result<void> SettingsBook::addValues(std::int64_t number, const std::vector<ValueChange> &values)
{
    int place = 0;
    for (const ValueChange &value : values) {
        MB_TRY_VOID(m_database.run("INSERT INTO changed_value (change, place, key, before, after, proof) "
                                   "VALUES (?, ?, ?, ?, ?, ?)",
            {static_cast<qint64>(number), place++, qt(value.key), orNull(value.before),
                static_cast<qint64>(value.after), qt(toString(value.proof))}));
    }
    return {};
}

Task<std::vector<SettingsChange>> SettingsBook::changesOf(std::string unit)
{
    co_return changes(unit);
}

Result<std::vector<SettingsChange>> SettingsBook::changes(const std::string &unit)
{
    std::vector<SettingsChange> found;
    const auto read = m_database.run("SELECT c.id, c.time, c.unit, c.device, c.person, c.origin, c.purpose, c.of, "
                                     "v.key, v.before, v.after, v.proof "
                                     "FROM change c LEFT JOIN changed_value v ON v.change = c.id "
                                     "WHERE c.unit = ? ORDER BY c.id, v.place",
        {qt(resolved(unit))}, [&found](const QSqlQuery &row) {
            if (found.empty() || found.back().number != row.value(0).toLongLong())
                found.push_back(changeOf(row));
            if (!row.value(8).isNull())
                found.back().values.push_back(valueOf(row, 8));
        });
    if (!read)
        return fail(read.error());
    return found;
}

Result<std::vector<ParameterSnapshot>> SettingsBook::read(
    const std::string &columns, const std::string &rest, const QVariantList &values)
{
    std::vector<ParameterSnapshot> found;
    const std::string statement = columns + " FROM snapshot" + rest;
    const bool isWhole = columns.size() == whole.size();
    MB_TRY_VOID(m_database.run(statement.c_str(), values,
        [&found, isWhole](const QSqlQuery &row) { found.push_back(snapshotOf(row, isWhole)); }));
    return found;
}

Result<std::vector<ParameterSnapshot>> SettingsBook::snapshots(const std::string &unit)
{
    return unit.empty() ? read(listed, " ORDER BY unit, id", {})
                        : read(listed, " WHERE unit = ? ORDER BY id", {qt(resolved(unit))});
}

Result<ParameterSnapshot> SettingsBook::find(const std::string &nameOrNumber, const std::string &unit)
{
    bool isNumber = false;
    const qint64 number = qt(nameOrNumber).toLongLong(&isNumber);
    auto found = isNumber ? read(whole, " WHERE id = ?", {number}) : std::vector<ParameterSnapshot>();
    if (found && found->empty())
        found = unit.empty()
            ? read(whole, " WHERE name = ? ORDER BY id", {qt(nameOrNumber)})
            : read(whole, " WHERE name = ? AND unit = ? ORDER BY id", {qt(nameOrNumber), qt(resolved(unit))});
    if (!found)
        return fail(found.error());
    if (found->empty())
        return fail(Fault::OutOfRange,
            unit.empty() ? say("there is no snapshot '%1'", nameOrNumber)
                         : say("there is no snapshot '%1' of this unit", nameOrNumber),
            say("'motorbenchctl snapshots' lists those there are"));
    const bool several = std::any_of(found->begin(), found->end(),
        [&found](const ParameterSnapshot &snapshot) { return snapshot.unit != found->back().unit; });
    if (several)
        return fail(Fault::OutOfRange, say("several units have a snapshot '%1'", nameOrNumber),
            say("name it by its number; 'motorbenchctl snapshots' lists them"));
    return std::move(found->back());
}

} // namespace mb
