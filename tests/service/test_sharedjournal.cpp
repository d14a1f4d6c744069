// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of the journal in a file and on a real server; stations that share one, and lose it.
#include "servicebench.h"
#include "storage/schema.h"
#include "storage/serverconnection.h"
#include "storage/sharedjournal.h"
#include "support/heldbackground.h"
#include "support/postgresserver.h"

#include <cstdio>
#include <map>
#include <thread>

namespace mb {
namespace {

using namespace std::chrono_literals;
using service::NumberWish;
using service::Outcome;
using service::Step;
using service::Visit;
using service::VisitFilter;
using test::PostgresServer;

Visit visitOf(const std::string &id, double time)
{
    Visit visit;
    visit.id = id;
    visit.run = "run";
    visit.time = time;
    visit.station = "bench 1";
    visit.recipe = "it's \"rev C\" \\ ü";
    visit.unit = "dmc60c " + id;
    visit.serial = id;
    visit.step = Step::Test;
    visit.outcome = Outcome::Failed;
    visit.from = "1.23";
    visit.unproved = true;
    visit.parameters = 55;
    visit.test = {{"settle", 0.25, std::nullopt, 0.6}, {"friction", std::nullopt, 0.1, 0.4, false, true}};
    visit.trial = std::int64_t{1} << 40;
    visit.seconds = 21.625;
    visit.cause = say("%1 is %2, %3", "settle", "line one\nline two", say("limit %1", "0.6"));
    visit.ending = service::Ending::StopUnconfirmed;
    visit.remedy = say("look at brushes, plugs and leads, then test again");
    visit.evidence = joined(
        say("%1: %2", Message::label("backup"), say("snapshot %1 has %2 values", 7, 55)), Message::verbatim("ü"));
    visit.steps = {{Step::Preflight, time, false, {}}, {Step::Preflight, time + 1.0, true, say("firmware %1", "1.23")}};
    return visit;
}

/// The same for a file and for a server.
class JournalTables : public testing::TestWithParam<const char *> {
protected:
    void SetUp() override
    {
        test::needCoreApplication();
        if (std::string_view(GetParam()) == "SQLite") {
            auto opened = Database::open(folder.path().toStdString() + "/motorbench.db");
            ASSERT_TRUE(opened);
            sql = std::move(*opened);
            return;
        }
        server.emplace();
        if (!server->isInstalled())
            GTEST_SKIP() << "postgresql is not installed";
        ASSERT_TRUE(server->start());
        const auto shared = JournalServer::parse(server->url());
        ASSERT_TRUE(shared);
        const auto prepared = shared->prepare();
        ASSERT_TRUE(prepared) << prepared.error().text();
        EXPECT_TRUE(shared->prepare()); // once more changes nothing
        auto opened = ServerConnection::open(*ServerAddress::parse(server->url()));
        ASSERT_TRUE(opened) << opened.error().text();
        sql = std::move(*opened);
    }
    QTemporaryDir folder;
    std::optional<PostgresServer> server;
    std::unique_ptr<SqlConnection> sql;
};

TEST_P(JournalTables, KeepEverythingOfAVisitAndAnOlderWriteChangesNothing)
{
    const Visit first = visitOf("A", 100.0);
    ASSERT_TRUE(putVisits(*sql, {{first, 2}, {visitOf("B", 200.0), 1}}));
    const auto kept = getVisit(*sql, "A");
    ASSERT_TRUE(kept) << kept.error().text();
    EXPECT_EQ(kept->visit, first);
    EXPECT_EQ(kept->visit.cause.literal(), "%1 is %2, %3"); // to be read in any language
    EXPECT_EQ(kept->visit.steps[1].detail.literal(), "firmware %1");
    EXPECT_EQ(kept->revision, 2);
    Visit later = first;
    later.outcome = Outcome::Passed;
    later.number = 12;
    later.steps.push_back({Step::Done, 130.0, true, say("passed")});
    ASSERT_TRUE(putVisits(*sql, {{later, 3}}));
    ASSERT_TRUE(putVisits(*sql, {{later, 3}}));
    ASSERT_TRUE(putVisits(*sql, {{first, 2}})); // a delivery that was late
    EXPECT_EQ(getVisit(*sql, "A")->visit, later);
    EXPECT_EQ(getVisits(*sql, {})->size(), 2U);
    VisitFilter filter;
    filter.since = 150.0;
    EXPECT_EQ(getVisits(*sql, filter)->front().visit.id, "B");
    filter = {};
    filter.outcome = Outcome::Passed;
    filter.recipe = later.recipe;
    filter.serial = "A";
    EXPECT_EQ(getVisits(*sql, filter)->size(), 1U);
    Visit simulated = visitOf("C", 300.0);
    simulated.simulated = true;
    ASSERT_TRUE(putVisits(*sql, {{simulated, 1}}));
    filter = {};
    filter.simulated = true;
    EXPECT_EQ(getVisits(*sql, filter)->size(), 1U);
    filter.simulated = false;
    EXPECT_EQ(getVisits(*sql, filter)->size(), 2U);
}

TEST(Stations, WaitForEachServerByItselfAndHaveNothingOfSimulatedUnitsForIt)
{
    const VirtualClock clock;
    const test::ServiceBooks books(clock);
    Database &sql = *books.database;
    const Visit first = visitOf("A", 100.0);
    Visit simulated = visitOf("C", 300.0);
    simulated.simulated = true;
    ASSERT_TRUE(putVisits(sql, {{first, 3}, {visitOf("B", 200.0), 1}, {simulated, 1}}));
    EXPECT_EQ(*countUndelivered(sql, "old"), 2);
    ASSERT_TRUE(markDelivered(sql, "old", {{first, 2}}));
    EXPECT_EQ(*countUndelivered(sql, "old"), 2) << "it was written again meanwhile";
    ASSERT_TRUE(markDelivered(sql, "old", {{first, 3}}));
    EXPECT_EQ(undelivered(sql, "old", 10)->front().visit.id, "B");
    EXPECT_EQ(*countUndelivered(sql, "new"), 2);
    EXPECT_EQ(undelivered(sql, "new", 10)->front().visit.id, "A");
}

TEST(Stations, DeliverOneBatchAfterTheOther)
{
    VirtualClock clock;
    const test::ServiceBooks books(clock);
    ServiceBook book(*books.database, clock, "bench 1", "anna");
    test::HeldBackground server; // does not answer
    SharedJournal journal(book, *JournalServer::parse("postgresql://anna@nowhere/journal"), clock, &server);
    for (const char *const id : {"A", "B", "C"}) {
        ASSERT_TRUE(test::run(clock, journal.open(visitOf(id, 100.0))));
        clock.advance(1s);
        EXPECT_EQ(server.waiting(), 1U) << id;
    }
}

TEST_P(JournalTables, ABlockIsTakenOnceAndTheSameQuestionHasTheSameAnswer)
{
    const NumberWish wish{"dmc60c rev C", "u", "v", 10, 21, {}};
    const auto block = takeBlock(*sql, "one", wish, 5, "bench 1", 1.0);
    ASSERT_TRUE(block) << block.error().text();
    EXPECT_EQ(std::pair(block->first, block->last), std::pair(10, 14));
    EXPECT_EQ(takeBlock(*sql, "one", wish, 5, "bench 1", 1.0)->first, 10);
    EXPECT_EQ(takeBlock(*sql, "two", wish, 5, "bench 2", 1.0)->first, 15);
    const auto last = takeBlock(*sql, "three", wish, 5, "bench 2", 1.0);
    EXPECT_EQ(std::pair(last->first, last->last), std::pair(20, 21));
    const auto none = takeBlock(*sql, "four", wish, 5, "bench 2", 1.0);
    ASSERT_TRUE(none) << none.error().text();
    EXPECT_TRUE(none->isEmpty()) << "all numbers are used up";
    EXPECT_TRUE(takeBlock(*sql, "four", wish, 5, "bench 2", 1.0)->isEmpty());
    EXPECT_FALSE(takeBlock(*sql, "five", {"another", "u", "v", 1, 63, {}}, 5, "bench 2", 1.0)->isEmpty());
}

TEST_P(JournalTables, ANumberIsOneUnitsForGood)
{
    ASSERT_TRUE(keepBlock(*sql, "s", {10, 12}));
    EXPECT_EQ(*giveNumber(*sql, {"s", "a", "v", 1, 63, {10}}), 11); // 10 is connected
    EXPECT_EQ(*giveNumber(*sql, {"s", "b", "v", 1, 63, {}}), 10);
    EXPECT_EQ(*giveNumber(*sql, {"s", "a", "w", 1, 63, {}}), 11); // the same unit again
    EXPECT_EQ(*giveNumber(*sql, {"s", "c", "v", 1, 63, {}}), 12);
    EXPECT_EQ(*giveNumber(*sql, {"s", "d", "v", 1, 63, {}}), std::nullopt);
    ASSERT_TRUE(keepBlock(*sql, "s", {10, 13}));
    EXPECT_EQ(*giveNumber(*sql, {"s", "d", "v", 1, 63, {}}), 13);
}

INSTANTIATE_TEST_SUITE_P(On, JournalTables, testing::Values("SQLite", "PostgreSQL"),
    [](const auto &each) { return std::string(each.param); });

TEST(JournalServers, HaveAnAddress)
{
    EXPECT_TRUE(JournalServer::parse("postgresql://anna@bench-db/journal"));
    EXPECT_TRUE(JournalServer::parse("postgresql://bench-db:5433/journal"));
    for (const auto &[host, port] : {std::pair("[::1]", 5432), std::pair("[fe80::1]:5433", 5433)}) {
        const auto address = ServerAddress::parse(std::string("postgresql://anna@") + host + "/journal");
        ASSERT_TRUE(address) << host;
        EXPECT_EQ(address->host.find_first_of("[]"), std::string::npos);
        EXPECT_EQ(address->port, port);
    }
    for (const char *const bad : {"", "mysql://a@b/c", "postgresql://", "postgresql://host", "postgresql://a@/db",
             "postgresql://a@host:0/db", "postgresql://host/"})
        EXPECT_FALSE(JournalServer::parse(bad)) << bad;
}

TEST(JournalServers, WithTheTablesOfAnOlderProgramAreBroughtUpToDateAndKeepWhatIsThere)
{
    test::needCoreApplication();
    PostgresServer server;
    if (!server.isInstalled())
        GTEST_SKIP() << "postgresql is not installed";
    ASSERT_TRUE(server.start());
    auto sql = ServerConnection::open(*ServerAddress::parse(server.url()));
    ASSERT_TRUE(sql) << sql.error().text();
    const QString first = QString::fromUtf8(journalSchemaVersions().front());
    for (const QString &statement : first.split(QStringLiteral(";\n"), Qt::SkipEmptyParts))
        ASSERT_TRUE(statement.trimmed().isEmpty() || (*sql)->run(statement.toUtf8().constData()));
    ASSERT_TRUE((*sql)->run("CREATE TABLE motorbench_schema (version BIGINT NOT NULL)"));
    ASSERT_TRUE((*sql)->run("INSERT INTO motorbench_schema (version) VALUES (1)"));
    ASSERT_TRUE((*sql)->run("INSERT INTO service_scope (scope, next) VALUES ('dmc60c rev C', 31)"));
    const auto shared = JournalServer::parse(server.url());
    for (int times = 0; times < 2; ++times) { // the second time it is up to date
        const auto prepared = shared->prepare();
        ASSERT_TRUE(prepared) << prepared.error().text();
    }
    const Visit visit = visitOf("A", 100.0);
    ASSERT_TRUE(shared->deliver({{visit, 1}}));
    EXPECT_EQ(shared->visits({})->front().visit, visit);
    EXPECT_EQ(shared->take("one", {"dmc60c rev C", "u", "v", 10, 63, {}}, "bench 1", 1.0)->first, 31);
}

/// A station with a file of its own.
struct Station {
    Station(VirtualClock &time, const std::string &name, const std::string &url)
        : clock(time)
        , books(time)
        , book(*books.database, time, name, "anna")
        , journal(book, *JournalServer::parse(url), time, nullptr)
    {
    }
    /// One unit from its beginning to its number and its end; nothing where it has to wait for a number.
    std::optional<int> serve(const std::string &unit)
    {
        Visit visit;
        visit.run = "run";
        visit.recipe = "rev C";
        visit.family = "dmc60c";
        visit.unit = unit;
        Visit opened = *test::run(clock, journal.open(visit));
        const auto number = test::run(clock, journal.number({"dmc60c rev C", unit, opened.id, 10, 63, {}}));
        opened.outcome = number && *number ? Outcome::Passed : Outcome::Failed;
        opened.number = number ? *number : std::nullopt;
        if (!number) {
            EXPECT_EQ(number.error().fault, Fault::Timeout) << number.error().text();
        }
        EXPECT_TRUE(test::run(clock, journal.write(opened)));
        clock.advance(1s);
        ++written;
        return opened.number;
    }
    VirtualClock &clock;
    test::ServiceBooks books;
    ServiceBook book;
    SharedJournal journal;
    int written = 0;
};

TEST(Stations, ShareAJournalThroughLossOfItsServer)
{
    test::needCoreApplication();
    PostgresServer server;
    if (!server.isInstalled())
        GTEST_SKIP() << "postgresql is not installed";
    ASSERT_TRUE(server.start());
    VirtualClock clock;
    Station one(clock, "bench 1", server.url());
    Station two(clock, "bench 2", server.url());
    std::map<int, int> given;
    int waited = 0;
    const auto serve = [&](Station &station, const std::string &unit) {
        const auto number = station.serve(unit);
        if (number)
            ++given[*number];
        else
            ++waited;
    };
    for (int i = 0; i < 8; ++i) {
        serve(one, "a" + std::to_string(i));
        serve(two, "b" + std::to_string(i));
    }
    EXPECT_EQ(waited, 0);
    EXPECT_EQ(one.journal.waiting() + two.journal.waiting(), 0);
    server.stop();
    for (int i = 8; i < 14; ++i) { // each has two numbers of its block left
        serve(one, "a" + std::to_string(i));
        serve(two, "b" + std::to_string(i));
    }
    EXPECT_EQ(waited, 8);
    EXPECT_EQ(one.journal.waiting(), 6);
    EXPECT_EQ(two.journal.waiting(), 6);
    EXPECT_FALSE(one.journal.trouble().detail.empty());
    ASSERT_TRUE(server.start());
    clock.advance(6s); // by itself
    EXPECT_EQ(one.journal.waiting() + two.journal.waiting(), 0);
    for (int i = 10; i < 14; ++i) {
        serve(one, "a" + std::to_string(i));
        serve(two, "b" + std::to_string(i));
    }
    const auto all = JournalServer::parse(server.url())->visits({});
    ASSERT_TRUE(all) << all.error().text();
    std::map<std::string, int> rows;
    for (const KeptVisit &kept : *all)
        ++rows[kept.visit.id];
    int twice = 0;
    for (const auto &[number, count] : given)
        twice += count > 1 ? 1 : 0;
    const int lost = one.written + two.written - static_cast<int>(rows.size());
    const int doubled = static_cast<int>(all->size() - rows.size());
    std::printf("two stations: %d entries, %d lost, %d twice; %zu numbers, %d given twice\n", one.written + two.written,
        lost, doubled, given.size(), twice);
    EXPECT_EQ(lost, 0);
    EXPECT_EQ(doubled, 0);
    EXPECT_EQ(twice, 0);
    EXPECT_EQ(given.size(), 28U);
}

/// A server, and units that ask for numbers of the same recipe wherever.
class StationNumbers : public testing::Test {
protected:
    void SetUp() override
    {
        test::needCoreApplication();
        if (!server.isInstalled())
            GTEST_SKIP() << "postgresql is not installed";
        ASSERT_TRUE(server.start());
    }
    int number(service::ServiceJournal &journal, const std::string &unit)
    {
        const auto given = test::run(clock, journal.number({"dmc60c rev C", unit, "visit", 10, 63, {}}));
        EXPECT_TRUE(given) << (given ? "" : given.error().text());
        return given ? given->value_or(-1) : -2;
    }
    PostgresServer server;
    VirtualClock clock;
};

TEST_F(StationNumbers, OfAFileThatWasUsedAloneBeforeAreNotGivenInTheSharedJournal)
{
    Station one(clock, "bench 1", server.url());
    Station two(clock, "bench 2", server.url());
    EXPECT_EQ(number(one.book, "alone 1"), 10);
    EXPECT_EQ(number(one.book, "alone 2"), 11);
    std::set<int> given;
    for (int i = 0; i < 6; ++i) {
        given.insert(number(one.journal, "a" + std::to_string(i)));
        given.insert(number(two.journal, "b" + std::to_string(i)));
    }
    EXPECT_EQ(given.size(), 12U) << "two units have one number";
    EXPECT_EQ(number(one.book, "alone 3"), 12) << "and the file's own go on";
}

TEST_F(StationNumbers, ThatAnOlderProgramTookFromTheServerAreKeptForTheirUnits)
{
    Station one(clock, "bench 1", server.url());
    ASSERT_TRUE(one.books.database->run("INSERT INTO service_block (token, scope, first, last, station, time) "
                                        "VALUES ('t', 'dmc60c rev C', 30, 34, 'bench 1', 1.0)"));
    ASSERT_TRUE(keepBlock(*one.books.database, "dmc60c rev C", {30, 34}));
    ASSERT_TRUE(giveNumber(*one.books.database, {"dmc60c rev C", "a", "visit", 10, 63, {}}));
    EXPECT_EQ(number(one.journal, "a"), 30);
    EXPECT_EQ(number(one.journal, "b"), 31);
    EXPECT_EQ(number(one.book, "c"), 10) << "the file alone has nothing of them";
}

TEST_F(StationNumbers, OfSimulatedUnitsAreTheStationsOwnAndNoRealUnitMissesThem)
{
    Station one(clock, "bench 1", server.url());
    Visit visit;
    visit.family = "dmc60c";
    visit.recipe = "rev C";
    visit.simulated = true;
    NumberWish wish{numberScopeOf(visit), "simulated dmc60c 1", "visit", 10, 63, {}, true};
    EXPECT_EQ(test::run(clock, one.journal.number(wish)).value_or(-1), 10);
    Station two(clock, "bench 2", server.url());
    EXPECT_EQ(number(two.journal, "a"), 10);
    EXPECT_EQ(number(one.journal, "b"), 15) << "a block of its own";
    EXPECT_EQ(JournalServer::parse(server.url())->take("t", wish, "bench 1", 1.0)->first, 10) << "the server gave none";
}

TEST_F(StationNumbers, AreTheSameForAUnitThatComesToAnotherStation)
{
    Station one(clock, "bench 1", server.url());
    Station two(clock, "bench 2", server.url());
    const auto first = one.serve("a");
    EXPECT_EQ(two.serve("b"), 15);
    EXPECT_EQ(two.serve("a"), first);
    server.stop();
    EXPECT_EQ(two.serve("a"), first) << "it knows by now";
    EXPECT_EQ(two.serve("c"), 16) << "what it has left";
}

TEST_F(StationNumbers, ThatLieHereAreGivenAtOnceWhileTheServerIsSilent)
{
    test::ServiceBooks books(clock);
    ServiceBook book(*books.database, clock, "bench 1", "anna");
    test::HeldBackground background;
    SharedJournal journal(book, *JournalServer::parse(server.url()), clock, &background);
    const auto ask = [&](const std::string &unit, bool answers) {
        auto asking = journal.number({"dmc60c rev C", unit, unit, 10, 63, {}});
        asking.start();
        for (int i = 0; answers && i < 3; ++i)
            background.release();
        const Instant begun = clock.now();
        EXPECT_TRUE(clock.runUntil([&] { return asking.isFinished(); }, 1min));
        const auto given = asking.isFinished() ? asking.result() : Result<std::optional<int>>();
        return std::pair(given ? given->value_or(-1) : -2, clock.now() - begun);
    };
    EXPECT_EQ(ask("a", true).first, 10);
    const auto opening = test::run(clock, journal.open(Visit())); // is not delivered
    ASSERT_TRUE(opening);
    clock.advance(13s);
    ASSERT_FALSE(journal.trouble().detail.empty());
    EXPECT_EQ(ask("b", false), std::pair(11, Duration()));
    EXPECT_EQ(ask("a", false), std::pair(10, Duration())) << "as before";
}

/// A line over which the server is too slow for as much as that.
TEST_F(StationNumbers, AServerThatIsTooSlowForManyEntriesGetsFewerAtOnce)
{
    test::ServiceBooks books(clock);
    ServiceBook book(*books.database, clock, "bench 1", "anna");
    for (int i = 0; i < 20; ++i)
        ASSERT_TRUE(test::run(clock, book.open(Visit())));
    test::HeldBackground background;
    SharedJournal journal(book, *JournalServer::parse(server.url()), clock, &background);
    std::vector<int> waiting;
    const auto hears = journal.changed().add([&] { waiting.push_back(journal.waiting()); });
    clock.advance(18s); // the first is late, and tried again
    EXPECT_EQ(background.waiting(), 2U);
    background.release();
    clock.advance(1s);
    ASSERT_GE(waiting.size(), 3U);
    waiting.resize(3);
    EXPECT_EQ(waiting, (std::vector<int>{20, 15, 5})) << "none in time, five, and as many as before";
}

TEST_F(StationNumbers, AreWaitedForWhileAnotherStationHoldsTheServer)
{
    const JournalServer shared = *JournalServer::parse(server.url());
    ASSERT_TRUE(shared.prepare());
    auto other = ServerConnection::open(*ServerAddress::parse(server.url()));
    ASSERT_TRUE(other && (*other)->run("BEGIN") && (*other)->run("SELECT pg_advisory_xact_lock(7733101)"));
    const auto taken = shared.take("one", {"scope", "u", "v", 1, 63, {}}, "bench 1", 1.0);
    ASSERT_FALSE(taken);
    EXPECT_EQ(taken.error().fault, Fault::Timeout) << taken.error().text();
}

TEST_F(StationNumbers, AreNotHeldForLongByAStationWhoseCableWasPulled)
{
    auto gone = ServerConnection::open(*ServerAddress::parse(server.url()));
    ASSERT_TRUE(gone);
    EXPECT_TRUE((*gone)->run("SELECT 1 / (current_setting('idle_in_transaction_session_timeout') = '10s')::int"));
}

TEST(Stations, AtOnceNeverGetTheSameNumbers)
{
    test::needCoreApplication();
    PostgresServer server;
    if (!server.isInstalled())
        GTEST_SKIP() << "postgresql is not installed";
    ASSERT_TRUE(server.start());
    const JournalServer shared = *JournalServer::parse(server.url());
    std::vector<std::vector<NumberBlock>> blocks(4);
    std::vector<std::thread> stations;
    for (std::size_t s = 0; s < blocks.size(); ++s)
        stations.emplace_back([&shared, &mine = blocks[s], s] {
            for (int i = 0; i < 10; ++i) {
                const auto block = shared.take(std::to_string(s) + '/' + std::to_string(i),
                    {"scope", "u", "v", 1, 10'000, {}}, "bench " + std::to_string(s), 1.0);
                if (block)
                    mine.push_back(*block);
            }
        });
    for (std::thread &station : stations)
        station.join();
    std::set<int> firsts;
    std::size_t count = 0;
    for (const auto &mine : blocks) {
        count += mine.size();
        for (const NumberBlock &block : mine)
            firsts.insert(block.first);
    }
    EXPECT_EQ(count, 40U);
    EXPECT_EQ(firsts.size(), 40U);
}

} // namespace
} // namespace mb
