// SPDX-License-Identifier: GPL-3.0-or-later
// The journal in a file that is damaged, full, not to be written, or shared by two programs.
#include "files/qttext.h"
#include "files/runningprogram.h"
#include "servicebench.h"
#include "storage/sharedjournal.h"
#include "support/fulldisk.h"

#include <unistd.h>

#include <thread>

namespace mb {
namespace {

using service::Outcome;
using service::Step;
using service::Visit;

/// Statements on their way to a server that is far away.
class CountedStatements final : public SqlConnection {
public:
    explicit CountedStatements(SqlConnection &sql)
        : m_sql(sql)
    {
    }
    Result<void> run(const char *statement, const QVariantList &values, const Row &row) override
    {
        ++count;
        return m_sql.run(statement, values, row);
    }
    [[nodiscard]] int changed() const override { return m_sql.changed(); }
    Result<void> transact(const std::function<Result<void>()> &work) override { return m_sql.transact(work); }
    int count = 0;

private:
    SqlConnection &m_sql;
};

class JournalFiles : public testing::Test {
protected:
    Visit opened(ServiceBook &book, const std::string &unit)
    {
        Visit visit;
        visit.run = "run";
        visit.recipe = "rev C";
        visit.unit = unit;
        const auto open = test::run(clock, book.open(visit));
        EXPECT_TRUE(open) << (open ? "" : open.error().text());
        return open.value_or(visit);
    }
    static Visit passed(Visit visit)
    {
        visit.outcome = Outcome::Passed;
        visit.steps.push_back({Step::Done, 0.0, true, say("passed")});
        return visit;
    }
    VirtualClock clock;
    test::ServiceBooks books{clock};
};

TEST_F(JournalFiles, TheLastRunIsTheOneThatWasWrittenDownLastWhateverTheClockSaid)
{
    for (const auto &[run, time] :
        {std::pair("first", 2000.0), std::pair("second", 1000.0)}) { // the clock was set back between
        Visit visit;
        visit.id = run;
        visit.run = run;
        visit.recipe = "rev C";
        visit.station = "bench 1";
        visit.time = time;
        ASSERT_TRUE(putVisits(*books.database, {{visit, 1}}));
        visit.id += " simulated";
        visit.run = visit.id;
        visit.simulated = true;
        ASSERT_TRUE(putVisits(*books.database, {{visit, 1}}));
    }
    EXPECT_EQ(books.journal->lastRun("rev C", false).value_or("none"), "second");
    EXPECT_EQ(books.journal->lastRun("rev C", true).value_or("none"), "second simulated");
}

TEST_F(JournalFiles, TheVisitsOfARunStandInTheirOrderThoughTheClockIsSetBack)
{
    Visit first;
    first.id = first.unit = "a";
    first.run = "run";
    first.time = 3600.0; // it is 0 by now
    ASSERT_TRUE(putVisits(*books.database, {{first, 1}}));
    for (int i = 0; i < 5; ++i)
        opened(*books.journal, std::to_string(i));
    service::VisitFilter ours;
    ours.run = "run";
    const auto visits = books.visits(ours);
    ASSERT_EQ(visits.size(), 6U);
    EXPECT_EQ(visits.front().unit, "a");
    EXPECT_EQ(visits.back().unit, "4");
}

TEST_F(JournalFiles, TheNewestOfManyVisitsAreReadAloneAndWithoutTheirStepsWhereThatIsWanted)
{
    std::vector<KeptVisit> all;
    for (int i = 0; i < 60; ++i) {
        all.push_back({passed({}), 1});
        all.back().visit.id = all.back().visit.unit = std::to_string(i);
        all.back().visit.time = 1000.0 - i;
        all.back().visit.outcome = i == 7 ? Outcome::Failed : Outcome::Passed;
    }
    ASSERT_TRUE(putVisits(*books.database, all));
    service::VisitFilter filter;
    filter.outcome = Outcome::Passed;
    filter.newest = 50;
    for (const bool steps : {true, false}) {
        filter.steps = steps;
        const auto visits = books.visits(filter);
        ASSERT_EQ(visits.size(), 50U);
        EXPECT_EQ(visits.front().unit, "50") << "oldest first";
        EXPECT_EQ(visits.back().unit, "0");
        EXPECT_EQ(visits.front().steps.size(), steps ? 1U : 0U);
    }
}

TEST_F(JournalFiles, ARunOfAProgramThatStillRunsIsNotThereToBeResumed)
{
    const Visit visit = opened(*books.journal, "a");
    EXPECT_EQ(books.journal->lastRun("rev C", false).value_or("none"), "run") << "this program may";
    ASSERT_TRUE(
        books.database->run("UPDATE service_run SET program = ?", {qt(programOf(std::to_string(::getppid())))}));
    const auto living = books.journal->lastRun("rev C", false);
    ASSERT_FALSE(living);
    EXPECT_EQ(living.error().fault, Fault::Refused);
    ASSERT_TRUE(books.database->run("UPDATE service_run SET program = '1:2'"));
    EXPECT_EQ(books.journal->lastRun("rev C", false).value_or("none"), "run") << "that one has ended";
    ASSERT_TRUE(test::run(clock, books.journal->write(visit)));
    ASSERT_TRUE(books.database->run(
        "UPDATE service_run SET program = ? WHERE program = '1:2'", {qt(programOf(std::to_string(::getppid())))}));
    EXPECT_EQ(books.journal->lastRun("rev C", false).value_or("none"), "run") << "who goes on with it has it in hand";
}

TEST_F(JournalFiles, ANoteThatIsMadeWhileAnotherProgramWritesTheEntryKeepsItAndIsKept)
{
    constexpr int times = 100;
    const Visit visit = opened(*books.journal, "a");
    std::thread other([&] {
        auto database = Database::open(books.path("motorbench.db"));
        ASSERT_TRUE(database) << database.error().text();
        const VirtualClock time;
        ServiceBook book(**database, time, "bench 1", "bob");
        for (int i = 0; i < times; ++i) {
            ASSERT_TRUE(book.setNote(visit.id, "note " + std::to_string(i)));
        }
    });
    for (int i = 0; i < times; ++i) {
        Visit written = visit;
        written.seconds = i;
        EXPECT_TRUE(test::run(clock, books.journal->write(written)));
    }
    other.join();
    const auto kept = getVisit(*books.database, visit.id);
    ASSERT_TRUE(kept) << kept.error().text();
    EXPECT_EQ(kept->revision, 1 + 2 * times) << "each has counted";
    EXPECT_EQ(kept->visit.seconds, times - 1);
    EXPECT_EQ(kept->visit.note, "note 99");
    EXPECT_FALSE(books.journal->setNote("nobody", "note"));
}

TEST_F(JournalFiles, AVisitIsPutInTwoStatementsHoweverManyItsSteps)
{
    Visit visit;
    visit.id = "A";
    for (int i = 0; i < 40; ++i)
        visit.steps.push_back({Step::Parameters, 101.0 + i, i % 2 == 1, say("%1 of %2 written", i, 40)});
    CountedStatements counted(*books.database);
    ASSERT_TRUE(putVisits(counted, {{visit, 1}}));
    EXPECT_EQ(counted.count, 2);
    EXPECT_EQ(getVisit(*books.database, "A")->visit, visit);
    visit.steps.clear();
    EXPECT_TRUE(putVisits(*books.database, {{visit, 2}}));
}

TEST_F(JournalFiles, AUnitKeepsItsNumberOnlyWhileItIsFreeAndWithinWhatIsWished)
{
    service::NumberWish wish{"nodes", "a", "visit", 10, 20, {}};
    const auto number = [&] { return test::run(clock, books.journal->number(wish)).value_or(std::nullopt); };
    EXPECT_EQ(number(), 10);
    EXPECT_EQ(number(), 10) << "the same again";
    wish.taken = {10};
    EXPECT_EQ(number(), 11) << "somebody else answers under it";
    wish = {"nodes", "a", "visit", 15, 20, {}};
    EXPECT_EQ(number(), 15) << "the recipe begins later now";
}

TEST_F(JournalFiles, WhatWaitedForTheServerIsOfferedToItAsSoonAsTheProgramStarts)
{
    const JournalServer nobody = *JournalServer::parse("postgresql://anna@127.0.0.1:1/journal");
    opened(*books.journal, "a");
    const SharedJournal next(*books.journal, nobody, clock, nullptr);
    clock.advance(std::chrono::milliseconds(1));
    EXPECT_FALSE(next.trouble().detail.empty());
    EXPECT_EQ(next.waiting(), 1);
}

TEST_F(JournalFiles, ADamagedFileIsPutAsideWithAWordAndTheQueueGoesOn)
{
    opened(*books.journal, "a");
    books.journal.reset();
    books.settings.reset();
    books.trials.reset();
    books.database.reset();
    const QByteArray rubbish(20'000, 'x');
    books.write("motorbench.db", rubbish);
    books.open();
    EXPECT_NE(books.database->remark().find(books.path("motorbench.db") + ".damaged"), std::string::npos)
        << books.database->remark();
    EXPECT_TRUE(books.visits().empty());
    EXPECT_TRUE(test::run(clock, books.journal->write(passed(opened(*books.journal, "b")))));
    EXPECT_EQ(books.visits().size(), 1U);
    QFile aside(qt(books.path("motorbench.db.damaged")));
    ASSERT_TRUE(aside.open(QIODevice::ReadOnly));
    EXPECT_EQ(aside.readAll(), rubbish);
}

TEST_F(JournalFiles, AFullDiskFailsTheEntryAndChangesNothing)
{
    const Visit first = *test::run(clock, books.journal->write(passed(opened(*books.journal, "a"))));
    clock.advance(std::chrono::seconds(1));
    Visit second = opened(*books.journal, "b");
    const Visit before = books.visits()[1];
    std::string noise;
    for (std::uint32_t i = 1; noise.size() < 1'000'000; i = i * 1664525U + 1013904223U)
        noise += std::to_string(i);
    {
        const test::FullDisk full(300'000);
        second.steps.push_back({Step::Backup, 0.0, true, Message::verbatim(noise)});
        const auto written = test::run(clock, books.journal->write(passed(second)));
        ASSERT_FALSE(written);
        EXPECT_EQ(written.error().fault, Fault::NotKept);
        EXPECT_NE(written.error().text().find("motorbench.db"), std::string::npos) << written.error().text();
    }
    const auto visits = books.visits();
    ASSERT_EQ(visits.size(), 2U);
    EXPECT_EQ(visits[0], first);
    EXPECT_EQ(visits[1], before);
    EXPECT_TRUE(test::run(clock, books.journal->write(passed(visits[1])))); // there is room again
    EXPECT_EQ(books.visits()[1].outcome, Outcome::Passed);
}

/// An ordinary user while this lives; root may write everywhere.
class OrdinaryUser {
public:
    OrdinaryUser()
    {
        if (m_user == 0) {
            EXPECT_EQ(::setresuid(nobody, nobody, 0), 0); // the saved one brings it back
        }
    }
    OrdinaryUser(const OrdinaryUser &) = delete;
    OrdinaryUser &operator=(const OrdinaryUser &) = delete;
    ~OrdinaryUser()
    {
        if (m_user == 0) {
            EXPECT_EQ(::setresuid(0, 0, 0), 0);
        }
    }

private:
    static constexpr uid_t nobody = 65534;
    const uid_t m_user = ::geteuid();
};

TEST_F(JournalFiles, AFolderThatCannotBeWrittenIsReadAndTakesNoEntry)
{
    Visit visit = opened(*books.journal, "a");
    books.journal.reset();
    books.settings.reset();
    books.trials.reset();
    books.database.reset();
    const QString folder = books.folder.path();
    const QString file = qt(books.path("motorbench.db"));
    const auto readable = QFile::ReadOwner | QFile::ReadGroup | QFile::ReadOther;
    ASSERT_TRUE(QFile::setPermissions(folder, readable | QFile::ExeOwner | QFile::ExeGroup | QFile::ExeOther));
    for (const auto rights : {readable, readable | QFile::WriteOwner | QFile::WriteGroup | QFile::WriteOther}) {
        ASSERT_TRUE(QFile::setPermissions(file, rights));
        const OrdinaryUser user;
        auto opened = Database::open(books.path("motorbench.db"));
        ASSERT_TRUE(opened) << opened.error().text();
        EXPECT_TRUE((*opened)->isReadOnly());
        ServiceBook book(**opened, clock, "bench 1", "anna");
        const auto visits = book.list({});
        ASSERT_TRUE(visits) << visits.error().text();
        ASSERT_EQ(visits->size(), 1U);
        EXPECT_EQ(visits->front(), visit);
        const auto written = test::run(clock, book.write(passed(visit)));
        ASSERT_FALSE(written);
        EXPECT_EQ(written.error().fault, Fault::NotKept);
        EXPECT_EQ(book.list({})->front(), visit);
    }
    QFile::setPermissions(folder, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner); // so that it goes away
}

TEST_F(JournalFiles, TwoProgramsAtOnceLoseNoEntryAndGiveNoNumberTwice)
{
    constexpr int each = 25;
    std::vector<std::vector<int>> given(2);
    std::vector<std::thread> programs;
    for (std::size_t program = 0; program < given.size(); ++program)
        programs.emplace_back([&, program] {
            VirtualClock time;
            auto database = Database::open(books.path("motorbench.db"));
            ASSERT_TRUE(database) << database.error().text();
            ServiceBook book(**database, time, "bench " + std::to_string(program), "anna");
            for (int i = 0; i < each; ++i) {
                Visit visit;
                visit.recipe = "rev C";
                visit.unit = std::to_string(program) + '/' + std::to_string(i);
                const auto opened = test::run(time, book.open(visit));
                ASSERT_TRUE(opened) << opened.error().text();
                const auto number = test::run(time, book.number({"dmc60c rev C", visit.unit, opened->id, 1, 1000, {}}));
                ASSERT_TRUE(number) << number.error().text();
                given[program].push_back(**number);
                ASSERT_TRUE(test::run(time, book.write(passed(*opened))));
            }
        });
    for (std::thread &program : programs)
        program.join();
    std::set<int> numbers(given[0].begin(), given[0].end());
    numbers.insert(given[1].begin(), given[1].end());
    EXPECT_EQ(numbers.size(), std::size_t{2 * each});
    const auto visits = books.visits();
    EXPECT_EQ(visits.size(), std::size_t{2 * each});
    for (const Visit &visit : visits)
        EXPECT_EQ(visit.outcome, Outcome::Passed) << visit.unit;
}

} // namespace
} // namespace mb
