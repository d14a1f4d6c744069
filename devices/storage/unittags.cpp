// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/unittags.h"

#include "files/qttext.h"
#include "model/unit.h"
#include "storage/sqltext.h"

#include <QSqlQuery>
#include <QVariant>

namespace mb {
namespace {

/// The one cell that is asked for; empty: there is none. A file of an earlier version that is read only may not have its table.
std::string cell(SqlConnection &sql, const char *statement, const std::string &key)
{
    std::string found;
    (void)sql.run(statement, {qt(key)}, [&found](const QSqlQuery &row) { found = textAt(row, 0); });
    return found;
}

std::string comingTo(SqlConnection &sql, const std::string &place)
{
    return cell(sql, "SELECT place FROM moving WHERE target = ?", place);
}

/// Who was there goes first where it is told to, also to the place that becomes free: its tag is parked meanwhile.
Result<void> come(SqlConnection &sql, const std::string &from, const std::string &to)
{
    const std::string before = resolvedUnit(sql, from);
    const std::string parked = to + '!';
    MB_TRY_VOID(sql.run("DELETE FROM moving WHERE target = ?", {qt(to)}));
    MB_TRY_VOID(sql.run("UPDATE OR REPLACE tag SET place = ? WHERE place = ?", {qt(parked), qt(from)}));
    if (const std::string next = cell(sql, "SELECT target FROM moving WHERE place = ?", to); !next.empty())
        MB_TRY_VOID(come(sql, to, next));
    MB_TRY_VOID(sql.run("DELETE FROM tag WHERE place = ?", {qt(to)}));
    MB_TRY_VOID(sql.run("UPDATE tag SET place = ? WHERE place = ?", {qt(to), qt(parked)}));
    return moveDebts(sql, before, resolvedUnit(sql, to));
}

} // namespace

std::string resolvedUnit(SqlConnection &sql, const std::string &unit)
{
    if (unitByOf(unit) != UnitBy::Place)
        return unit;
    std::string tag = cell(sql, "SELECT name FROM tag WHERE place = ?", unit);
    if (tag.empty())
        tag = cell(sql, "SELECT name FROM tag JOIN moving ON moving.place = tag.place WHERE target = ?", unit);
    return tag.empty() ? unit : taggedUnitKey(unit, tag);
}

void meetAt(SqlConnection &sql, const std::string &place)
{
    if (comingTo(sql, place).empty())
        return;
    (void)sql.transact([&sql, &place]() -> Result<void> {
        const std::string from = comingTo(sql, place); // another program may have been quicker
        return from.empty() ? Result<void>() : come(sql, from, place);
    });
}

Result<void> moveDebts(SqlConnection &sql, const std::string &before, const std::string &after)
{
    int ofBefore = 0;
    int ofAfter = 0;
    auto counted
        = sql.run("SELECT place, name FROM tag", {}, [&ofBefore, &ofAfter, &before, &after](const QSqlQuery &row) {
              const std::string key = taggedUnitKey(textAt(row, 0), textAt(row, 1));
              ofBefore += key == before ? 1 : 0;
              ofAfter += key == after ? 1 : 0;
          });
    const bool isOnly = ofBefore == 0 && ofAfter == (unitByOf(after) == UnitBy::Tag ? 1 : 0);
    if (!counted || before == after || !isOnly)
        return counted;
    return sql.run("UPDATE OR IGNORE owed SET unit = ? WHERE unit = ?", {qt(after), qt(before)});
}

std::set<std::string> unitsAt(SqlConnection &sql, const DeviceSelector &place)
{
    Identity known;
    known.family = place.family;
    known.address = place.address;
    std::set<std::string> units{resolvedUnit(sql, unitKeyOf(known, place.link))};
    const auto see = [&place, &units](const QSqlQuery &row) {
        auto there = DeviceSelector::parse(textAt(row, 1));
        if (!there || there->link.scheme != place.link.scheme || there->link.path != place.link.path)
            return;
        if (!row.value(2).isNull()) // it is another place that has the new number
            there->address = unitByOf(textAt(row, 0)) == UnitBy::Place ? -1 : row.value(2).toInt();
        if (there->family == place.family && there->address == place.address)
            units.insert(textAt(row, 0));
    };
    for (const char *statement : {"SELECT DISTINCT unit, device, NULL FROM trial",
             "SELECT DISTINCT unit, device, NULL FROM snapshot", "SELECT DISTINCT unit, device, NULL FROM change",
             "SELECT DISTINCT unit, device, after FROM change JOIN changed_value ON change = id "
             "WHERE key = 'number' AND proof <> 'refused'"})
        (void)sql.run(statement, {}, see); // a file of an earlier version that is read only may not have it
    return units;
}

} // namespace mb
