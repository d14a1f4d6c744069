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
        MB_TRY(const auto known, blockOf(sql, token));
        if (known) {
            block = *known;
            return {};
        }
        MB_TRY(const auto next, advance(sql, wish, size));
        block = next;
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
    std::vector<GivenNumber> numbers;
    for (int number = block.first; number <= block.last; ++number)
        numbers.push_back({scope, number, {}, {}});
    return putNumbers(sql, numbers);
}

Result<std::optional<int>> numberOf(SqlConnection &sql, const NumberWish &wish)
{
    std::optional<int> number;
    auto read = sql.run("SELECT number FROM service_number WHERE scope = ? AND unit = ? ORDER BY number DESC",
        {qt(wish.scope), qt(wish.unit)}, [&](const QSqlQuery &row) {
            const int each = row.value(0).toInt();
            if (each >= wish.first && each <= wish.last && !wish.taken.contains(each))
                number = each;
        });
    if (!read)
        return fail(read.error());
    return number;
}

Result<std::optional<int>> giveNumber(SqlConnection &sql, const NumberWish &wish)
{
    std::optional<int> given;
    auto done = sql.transact([&]() -> Result<void> {
        NumberWish free = wish;
        free.unit.clear();
        for (const NumberWish &each : {wish, free}) {
            MB_TRY(const auto number, numberOf(sql, each));
            given = number;
            if (given)
                break;
        }
        if (!given)
            return {};
        return sql.run("UPDATE service_number SET unit = ?, visit = ? WHERE scope = ? AND number = ? AND unit = ''",
            {qt(wish.unit), qt(wish.visit), qt(wish.scope), *given});
    });
    if (!done)
        return fail(done.error());
    return given;
}

Result<void> putNumbers(SqlConnection &sql, const std::vector<GivenNumber> &numbers)
{
    return sql.transact([&]() -> Result<void> {
        for (const GivenNumber &given : numbers) {
            MB_TRY_VOID(sql.run("INSERT INTO service_number (scope, number, unit, visit) VALUES (?, ?, ?, ?) "
                                "ON CONFLICT (scope, number) DO NOTHING",
                {qt(given.scope), given.number, qt(given.unit), qt(given.visit)}));
        }
        return {};
    });
}

Result<std::vector<GivenNumber>> numbersOf(
    SqlConnection &sql, const std::vector<KeptVisit> &visits, const std::string &suffix)
{
    std::vector<GivenNumber> numbers;
    for (const KeptVisit &kept : visits) {
        const service::Visit &visit = kept.visit;
        if (!visit.number)
            continue;
        const GivenNumber given{numberScopeOf(visit), *visit.number, numberOwnerOf(visit), visit.id};
        MB_TRY_VOID(sql.run("SELECT 1 FROM service_number WHERE scope = ? AND number = ? AND unit = ?",
            {qt(given.scope + suffix), given.number, qt(given.unit)},
            [&](const QSqlQuery &) { numbers.push_back(given); }));
    }
    return numbers;
}

Result<void> moveBlocks(SqlConnection &sql, const std::string &scope, const std::string &other)
{
    return sql.transact([&]() -> Result<void> {
        Result<void> moved;
        for (const char *const statement : {"UPDATE service_number SET scope = ? WHERE scope = ? AND NOT EXISTS "
                                            "(SELECT 1 FROM service_scope WHERE service_scope.scope = ?)",
                 "UPDATE service_block SET scope = ? WHERE scope = ? AND NOT EXISTS "
                 "(SELECT 1 FROM service_scope WHERE service_scope.scope = ?)"}) {
            if (moved)
                moved = sql.run(statement, {qt(other), qt(scope), qt(scope)});
        }
        return moved;
    });
}

} // namespace mb
