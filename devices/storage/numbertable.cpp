// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/numbertable.h"

#include "files/qttext.h"

#include <QSqlQuery>

#include <algorithm>

namespace mb {
namespace {

using service::NumberWish;

Result<std::optional<NumberBlock>> blockOf(SqlConnection &sql, const std::string &token)
{
    std::optional<NumberBlock> block;
    auto read
        = sql.run("SELECT first, last FROM service_block WHERE token = ?", {qt(token)}, [&block](const QSqlQuery &row) {
              block = NumberBlock{row.value(0).toInt(), row.value(1).toInt()};
          });
    if (!read)
        return fail(read.error());
    return block;
}

/// The change comes first: it makes whoever else takes numbers of this scope wait until this has ended.
Result<NumberBlock> advance(SqlConnection &sql, const NumberWish &wish, int size)
{
    const QString scope = qt(wish.scope);
    auto done = sql.run(
        "INSERT INTO service_scope (scope, next) VALUES (?, ?) ON CONFLICT (scope) DO NOTHING", {scope, wish.first});
    if (done)
        done = sql.run("UPDATE service_scope SET next = CASE WHEN next < ? THEN ? ELSE next END + ? WHERE scope = ?",
            {wish.first, wish.first, size, scope});
    int next = 0;
    if (done)
        done = sql.run("SELECT next FROM service_scope WHERE scope = ?", {scope},
            [&next](const QSqlQuery &row) { next = row.value(0).toInt(); });
    if (!done)
        return fail(done.error());
    return NumberBlock{next - size, std::min(next - 1, wish.last)};
}

} // namespace

Result<NumberBlock> takeBlock(SqlConnection &sql, const std::string &token, const NumberWish &wish, int size,
    const std::string &station, double time)
{
    NumberBlock block;
    auto taken = sql.transact([&]() -> Result<void> {
        const auto known = blockOf(sql, token);
        if (!known)
            return fail(known.error());
        if (*known) {
            block = **known;
            return {};
        }
        const auto next = advance(sql, wish, size);
        if (!next)
            return fail(next.error());
        block = *next;
        if (block.isEmpty())
            return {};
        return sql.run("INSERT INTO service_block (token, scope, first, last, station, time) VALUES (?, ?, ?, ?, ?, ?)",
            {qt(token), qt(wish.scope), block.first, block.last, qt(station), time});
    });
    if (!taken)
        return fail(taken.error());
    return block;
}

Result<void> keepBlock(SqlConnection &sql, const std::string &scope, const NumberBlock &block)
{
    return sql.transact([&]() -> Result<void> {
        for (int number = block.first; number <= block.last; ++number) {
            auto kept = sql.run("INSERT INTO service_number (scope, number, unit, visit) VALUES (?, ?, '', '') "
                                "ON CONFLICT (scope, number) DO NOTHING",
                {qt(scope), number});
            if (!kept)
                return kept;
        }
        return {};
    });
}

Result<std::optional<int>> giveNumber(SqlConnection &sql, const NumberWish &wish)
{
    std::optional<int> given;
    auto done = sql.transact([&]() -> Result<void> {
        std::vector<int> free;
        auto read
            = sql.run("SELECT number, unit FROM service_number WHERE scope = ? AND unit IN ('', ?) ORDER BY number",
                {qt(wish.scope), qt(wish.unit)}, [&](const QSqlQuery &row) {
                    const int number = row.value(0).toInt();
                    if (number < wish.first || number > wish.last || wish.taken.contains(number))
                        return;
                    if (row.value(1).toString().isEmpty())
                        free.push_back(number);
                    else if (!given)
                        given = number;
                });
        if (!read || given || free.empty())
            return read;
        given = free.front();
        return sql.run("UPDATE service_number SET unit = ?, visit = ? WHERE scope = ? AND number = ?",
            {qt(wish.unit), qt(wish.visit), qt(wish.scope), *given});
    });
    if (!done)
        return fail(done.error());
    return given;
}

} // namespace mb
