// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/unittags.h"

#include "files/qttext.h"
#include "model/unit.h"
#include "storage/sqltext.h"

#include <QSqlQuery>
#include <QVariant>

namespace mb {

std::string resolvedUnit(SqlConnection &sql, const std::string &unit)
{
    if (unitByOf(unit) != UnitBy::Place)
        return unit;
    std::string tag;
    (void)sql.run(
        "SELECT name FROM tag WHERE place = ?", {qt(unit)}, [&tag](const QSqlQuery &row) { tag = textAt(row, 0); });
    return tag.empty() ? unit : taggedUnitKey(unit, tag);
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
