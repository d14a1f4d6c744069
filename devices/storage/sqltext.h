// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSqlQuery>
#include <QVariant>

#include <string>

namespace mb {

/// Text of a column of the row where `row` stands; empty for NULL.
[[nodiscard]] inline std::string textAt(const QSqlQuery &row, int column)
{
    return row.value(column).toString().toStdString();
}

} // namespace mb
