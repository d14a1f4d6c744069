// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/result.h"
#include "service/visit.h"

#include <QJsonArray>
#include <QJsonObject>

namespace mb {

/// Each value with its limits, as the journal keeps it.
[[nodiscard]] QJsonArray testToJson(const std::vector<service::TestValue> &test);
[[nodiscard]] std::vector<service::TestValue> testFromJson(const QJsonArray &array);

/// A line of `service`.
[[nodiscard]] QJsonObject visitLine(const service::Visit &visit);
/// A row of `journal`: that line and time, station, recipe, note.
[[nodiscard]] QJsonObject visitRow(const service::Visit &visit);
[[nodiscard]] QJsonArray visitRows(const std::vector<service::Visit> &visits);

/// A table of the rows with everything the journal knows of each unit; OutOfRange when nothing can be written there, NotKept when that fails.
[[nodiscard]] Result<void> exportVisits(const std::string &path, const std::vector<service::Visit> &visits);

} // namespace mb
