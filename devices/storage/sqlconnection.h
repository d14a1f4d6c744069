// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "async/noncopyable.h"
#include "async/result.h"

#include <QVariantList>

#include <functional>

class QSqlQuery;

namespace mb {

/// An open database that takes statements which SQLite and PostgreSQL both understand. Of one thread; waits for disk or server.
class SqlConnection : NonCopyable {
public:
    virtual ~SqlConnection() = default;

    using Row = std::function<void(const QSqlQuery &)>;
    /// One statement with its values in order of the question marks; `row` sees each row.
    [[nodiscard]] virtual Result<void> run(const char *statement, const QVariantList &values = {}, const Row &row = {})
        = 0;
    /// Number of rows that run() has changed last.
    [[nodiscard]] virtual int changed() const = 0;
    /// All of `work` or nothing of it; kept for good when it succeeds.
    [[nodiscard]] virtual Result<void> transact(const std::function<Result<void>()> &work) = 0;
};

} // namespace mb
