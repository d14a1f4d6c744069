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

} // namespace mb
