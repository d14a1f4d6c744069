// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/sharedjournal.h"

#include "files/qttext.h"
#include "storage/sqltext.h"

#include <QSqlQuery>
#include <QUuid>

#include <algorithm>

namespace mb {
namespace {

using namespace std::chrono_literals;

constexpr auto lane = "journal-server";
constexpr Duration serverLimit = 12s; ///< of a call, whatever hangs
constexpr Duration againAfter = 5s;
constexpr int mostAtOnce = 10;

} // namespace

using service::NumberWish;
using service::Visit;

SharedJournal::SharedJournal(ServiceBook &book, JournalServer server, Clock &clock, Background *background)
    : m_book(book)
    , m_server(std::move(server))
    , m_clock(clock)
    , m_background(background)
    , m_batchSize(mostAtOnce)
    , m_again(clock)
    , m_scope(clock)
{
    deliverSoon();
}

Task<Visit> SharedJournal::open(Visit visit)
{
    Visit opened = co_await m_book.open(std::move(visit));
    deliverSoon();
    co_return opened;
}

Task<Visit> SharedJournal::write(Visit visit)
{
    Visit written = co_await m_book.write(std::move(visit));
    deliverSoon();
    co_return written;
}

Task<std::vector<Visit>> SharedJournal::visits(service::VisitFilter filter)
{
    return m_book.visits(std::move(filter));
}

void SharedJournal::deliverSoon()
{
    m_isBehind = true;
    if (m_isDelivering)
        return;
    m_isDelivering = true;
    m_scope.spawn<void>(deliver(), [this](Result<void> delivered) {
        m_isDelivering = false;
        m_trouble = delivered ? Error{} : delivered.error();
        m_changed.notify();
        if (!delivered) {
            m_batchSize = std::max(1, m_batchSize / 2); // a slow line has not carried so many in time
            m_again.startIn(againAfter, [this] { deliverSoon(); });
        } else if (m_isBehind) {
            deliverSoon();
        }
    });
}

Task<void> SharedJournal::deliver()
{
    for (;;) {
        m_isBehind = false;
        const auto batch = co_await undelivered(m_book.database(), m_server.url(), m_batchSize);
        if (batch.empty())
            co_return {};
        co_await deliverBatch(batch);
        co_await markDelivered(m_book.database(), m_server.url(), batch);
        m_batchSize = std::min(2 * m_batchSize, mostAtOnce);
        m_changed.notify();
    }
}

/// In the background, which outlives a server that hangs.
template <class Answer> Task<Answer> SharedJournal::askServer(std::function<Result<Answer>(const JournalServer &)> what)
{
    if (!m_background)
        co_return what(m_server);
    auto working = inBackground<Answer>(
        *m_background, m_clock, lane, serverLimit, [server = m_server, what = std::move(what)] { return what(server); },
        WhenLate::Finish);
    co_return co_await std::move(working).attempt();
}

Task<void> SharedJournal::deliverBatch(std::vector<KeptVisit> batch)
{
    const auto numbers = numbersOf(m_book.database(), batch, hereOf({}));
    if (!numbers)
        co_return fail(numbers.error());
    auto delivering = askServer<bool>([batch = std::move(batch), numbers = *numbers](const JournalServer &server) {
        return server.deliver(batch, numbers).map([] { return true; });
    });
    co_await std::move(delivering);
    co_return {};
}

/// What is asked for is written down before: an answer that was lost is asked for again by the same name.
Result<std::string> SharedJournal::tokenFor(const std::string &scope)
{
    SqlConnection &sql = m_book.database();
    std::string token;
    MB_TRY_VOID(sql.run("SELECT token FROM service_block WHERE scope = ? AND last < first", {qt(scope)},
        [&token](const QSqlQuery &row) { token = textAt(row, 0); }));
    if (!token.empty())
        return token;
    token = QUuid::createUuid().toString(QUuid::WithoutBraces).toStdString();
    MB_TRY_VOID(
        sql.run("INSERT INTO service_block (token, scope, first, last, station, time) VALUES (?, ?, 1, 0, ?, ?)",
            {qt(token), qt(scope), qt(m_book.station()), m_book.now()}));
    return token;
}

/// That this unit has, here or by another station; without the server it is what is known here.
Task<std::optional<int>> SharedJournal::recalled(NumberWish wish, std::string here)
{
    SqlConnection &sql = m_book.database();
    NumberWish local = wish;
    local.scope = here;
    const std::optional<int> known = co_await numberOf(sql, local);
    if (known)
        co_return known;
    auto asking = askServer<std::optional<int>>([wish](const JournalServer &server) { return server.numberOf(wish); });
    const Result<std::optional<int>> told = co_await std::move(asking).attempt();
    if (!told || !*told)
        co_return std::nullopt;
    if (auto kept = putNumbers(sql, {{here, **told, wish.unit, wish.visit}}); !kept)
        co_return fail(kept.error());
    co_return *told;
}

Task<std::optional<int>> SharedJournal::number(NumberWish wish)
{
    if (wish.simulated) {
        co_return co_await m_book.number(std::move(wish));
    }
    SqlConnection &sql = m_book.database();
    NumberWish local = wish;
    local.scope = hereOf(wish.scope);
    co_await moveBlocks(sql, wish.scope, local.scope); // of a program that did not tell them apart
    if (isSilent()) {                                  // nobody waits for its time-out as long as numbers lie here
        const std::optional<int> given = co_await giveNumber(sql, local);
        if (given)
            co_return given;
    }
    if (const std::optional<int> known = co_await recalled(wish, local.scope); known)
        co_return *known;
    for (;;) {
        const std::optional<int> given = co_await giveNumber(sql, local);
        if (given)
            co_return given;
        const std::string token = co_await tokenFor(local.scope);
        auto taking = askServer<NumberBlock>(
            [token, wish, station = m_book.station(), time = m_book.now()](
                const JournalServer &server) { return server.take(token, wish, station, time); });
        const NumberBlock block = co_await std::move(taking);
        if (block.isEmpty())
            co_return std::nullopt;
        auto kept = keepBlock(sql, local.scope, block); // again after a cut: the token is still asked for then
        if (kept)
            kept = sql.run(
                "UPDATE service_block SET first = ?, last = ? WHERE token = ?", {block.first, block.last, qt(token)});
        if (!kept)
            co_return fail(kept.error());
    }
}

int SharedJournal::waiting() const
{
    return countUndelivered(m_book.database(), m_server.url()).value_or(0);
}

} // namespace mb
