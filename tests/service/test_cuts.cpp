// SPDX-License-Identifier: GPL-3.0-or-later
// What becomes of a queue of simulated units that is cut: its program, its wire, its units. In virtual time.
#include "model/unit.h"
#include "queuebench.h"

#include <QtGlobal>

#include <algorithm>
#include <cstdlib>

namespace mb::service {
namespace {

using namespace std::chrono_literals;
using test::QueueRun;
using test::ServiceBooks;
using test::UnitRack;

/// Lets a number of writes through; the next either is not done, or is and nobody hears of it: the program has died.
class DyingJournal final : public ServiceJournal {
public:
    DyingJournal(ServiceJournal &journal, int lives, bool writesLast)
        : m_journal(journal)
        , m_lives(lives)
        , m_writesLast(writesLast)
    {
    }
    [[nodiscard]] Task<Visit> open(Visit visit) override { return through(m_journal.open(std::move(visit))); }
    [[nodiscard]] Task<Visit> write(Visit visit) override { return through(m_journal.write(std::move(visit))); }
    [[nodiscard]] Task<std::vector<Visit>> visits(VisitFilter filter) override
    {
        return m_journal.visits(std::move(filter));
    }
    [[nodiscard]] Task<std::optional<int>> number(NumberWish wish) override
    {
        return through(m_journal.number(std::move(wish)));
    }
    bool isDead = false;

private:
    template <class T> Task<T> through(Task<T> writing)
    {
        const bool last = --m_lives < 0;
        if (last && !m_writesLast) {
            isDead = true;
            co_await m_never.wait();
        }
        Result<T> written = co_await std::move(writing).attempt();
        if (last) {
            isDead = true;
            co_await m_never.wait();
        }
        co_return written;
    }
    ServiceJournal &m_journal;
    int m_lives;
    bool m_writesLast;
    Event m_never;
};

class Cuts : public ServiceQueues {
protected:
    /// A good unit and one that is refused, a cut at the write of this number, and then a resumed queue; false when there are not so many writes.
    bool cutAt(int lives, bool writesLast)
    {
        UnitRack rack({"dmc60c:5,serial=210334000001,firmware=1.23", "dmc60c:6,serial=210334000002,product=601"});
        std::vector<double> flashed;
        const Subscription events = rack.unit(0).events().add([&flashed](const SimulatorEvent &event) {
            if (event.what == "page-written" && event.value == 0.0)
                flashed.push_back(event.value);
        });
        const RecipeMatter matter = load(rack, shortText);
        std::string runName;
        bool died = false;
        {
            DyingJournal dying(*books->journal, lives, writesLast);
            QueueRun run(rack, *books, matter, {}, &dying);
            run.queue.start();
            rack.clock.runUntil([&] { return run.isEnded || dying.isDead; }, 5min);
            died = dying.isDead;
            runName = run.queue.run();
        }
        rack.clock.advance(2s); // whoever comes back takes his time
        if (died) {
            books->open();
            QueueOptions options;
            options.run = runName;
            QueueRun again(rack, *books, matter, options);
            EXPECT_TRUE(again.run(10min)) << "cut " << lives;
            EXPECT_EQ(again.queue.counts().passed, 1) << "cut " << lives << writesLast;
            EXPECT_EQ(again.queue.counts().refused, 1) << "cut " << lives << writesLast;
        }
        const auto visits = books->visits();
        if (visits.size() != 2 || testing::Test::HasFailure())
            print(visits);
        EXPECT_EQ(visits.size(), 2U) << "cut " << lives << writesLast;
        std::set<int> numbers;
        for (const Visit &visit : visits) {
            EXPECT_EQ(visit.outcome, visit.serial == "210334000001" ? Outcome::Passed : Outcome::Refused);
            EXPECT_EQ(visit.from, "1.23");
            if (visit.number)
                numbers.insert(*visit.number);
        }
        EXPECT_EQ(numbers, (std::set<int>{10})) << "cut " << lives << writesLast;
        EXPECT_EQ(flashed.size(), 1U) << "the firmware is written once, cut " << lives << writesLast;
        rack.clock.advance(1s);
        const auto found = test::run(rack.clock, rack.session->scan(*rack.link));
        EXPECT_TRUE(found && found->size() == 2U);
        return died;
    }
};

/// A unit that was cut off, and is silent or back when the queue goes on.
class CutUnits : public ServiceQueues {
protected:
    /// Served until its firmware is being written, or until a later step has begun; the name of the run.
    std::string cut(UnitRack &rack, const RecipeMatter &matter, Step during = Step::Firmware)
    {
        QueueRun run(rack, *books, matter, options({}));
        run.queue.start();
        EXPECT_TRUE(rack.clock.runUntil(
            [&] {
                const auto rows = run.queue.rows();
                return !rows.empty() && rows[0]->visit.step == during
                    && (during != Step::Firmware || rows[0]->done > 5);
            },
            1min));
        return run.queue.run();
    }
    [[nodiscard]] static QueueOptions options(const std::string &run, std::optional<int> units = 1)
    {
        QueueOptions options;
        options.units = units;
        options.run = run;
        return options;
    }
};

TEST_F(CutUnits, WhichStaySilentHaveFailedAndNobodyWaitsForEver)
{
    for (const std::optional<int> units : {std::optional<int>(1), std::optional<int>()}) {
        UnitRack rack({"dmc60c:5,serial=210334000001,firmware=1.23"});
        const RecipeMatter matter = load(rack, shortText);
        const std::string name = cut(rack, matter);
        rack.putOn(std::nullopt);
        rack.clock.advance(1s);
        QueueRun again(rack, *books, matter, options(name, units));
        again.queue.start();
        ASSERT_TRUE(rack.clock.runUntil([&] { return !again.queue.rows().empty(); }, 5s));
        EXPECT_EQ(again.queue.rows()[0]->state, RowState::Waiting);
        EXPECT_EQ(again.queue.rows()[0]->what.english(), "does not answer") << "its row says so meanwhile";
        ASSERT_TRUE(rack.clock.runUntil([&] { return again.isEnded; }, 30s));
        const auto visits = books->visits();
        ASSERT_EQ(visits.size(), 1U);
        EXPECT_EQ(visits[0].outcome, Outcome::Failed);
        EXPECT_EQ(visits[0].step, Step::Firmware);
        EXPECT_EQ(visits[0].cause.english(), "it was cut off at 'firmware' and does not answer any more");
        EXPECT_TRUE(visits[0].steps.back().ended);
        EXPECT_EQ(again.queue.counts().failed, 1);
    }
}

TEST_F(CutUnits, WhichComeBackSomeSecondsLaterGoOnInTheirOwnRow)
{
    UnitRack rack({"dmc60c:5,serial=210334000001,firmware=1.23"});
    const RecipeMatter matter = load(rack, shortText);
    const std::string name = cut(rack, matter);
    rack.putOn(std::nullopt);
    rack.clock.advance(1s);
    QueueRun again(rack, *books, matter, options(name));
    again.queue.start();
    rack.clock.advance(6s);
    rack.putOn(0);
    ASSERT_TRUE(rack.clock.runUntil([&] { return again.isEnded; }, 2min));
    const auto visits = books->visits();
    ASSERT_EQ(visits.size(), 1U) << "no visit twice";
    EXPECT_EQ(visits[0].outcome, Outcome::Passed) << visits[0].cause.english();
    EXPECT_EQ(again.queue.rows().size(), 1U);
}

TEST_F(CutUnits, WhichAreRefusedWhenTheQueueGoesOnHaveFailedWhereTheyWereWrittenTo)
{
    UnitRack rack({"dmc60c:5,serial=210334000001,firmware=1.23"});
    const RecipeMatter matter = load(rack, shortText);
    const std::string name = cut(rack, matter, Step::Parameters);
    Device *const unit = rack.session->devices().front();
    tuning::Trial trial;
    trial.device = unit->selector();
    trial.unit = unitKeyOf(*unit);
    const auto number = test::run(rack.clock, books->trials->begin(trial));
    const auto tried = test::run(rack.clock, unit->read(*findParameter(unit->family().parameters, "slot0.p")));
    ASSERT_TRUE(number && tried);
    ASSERT_TRUE(test::run(rack.clock, books->trials->owe(*number, trial.unit, {{"slot0.p", *tried + 7, *tried}})));
    books->trials->abandon(*number);
    QueueRun again(rack, *books, matter, options(name));
    ASSERT_TRUE(again.run(5min));
    const auto visits = books->visits();
    ASSERT_EQ(visits.size(), 1U);
    EXPECT_NE(visits[0].cause.english().find("did not put back what it changed"), std::string::npos)
        << visits[0].cause.english();
    EXPECT_EQ(visits[0].outcome, Outcome::Failed) << "its firmware was written";
    EXPECT_EQ(again.queue.counts().refused, 0);
}

TEST_F(CutUnits, AreNotUpdatedOnceMoreWhereTheyTellTheVersionOfTheImage)
{
    for (const bool isOld : {false, true}) {
        UnitRack rack({"dmc60c:5,serial=210334000001,firmware=1.23", "dmc60c:5,serial=210334000001,firmware=1.23"});
        rack.putOn(0);
        const RecipeMatter matter = load(rack, shortText);
        const std::string name = cut(rack, matter, Step::Test);
        if (isOld)
            rack.putOn(1); // as if somebody had put the old firmware back
        rack.clock.advance(2s);
        QueueRun again(rack, *books, matter, options(name));
        EXPECT_TRUE(again.run(10min));
        const auto visits = books->visits();
        ASSERT_EQ(visits.size(), 1U);
        EXPECT_EQ(visits[0].outcome, Outcome::Passed) << visits[0].cause.english();
        EXPECT_EQ(visits[0].to, "1.25");
        EXPECT_EQ(rack.session->devices().front()->identity().firmware, "1.25");
        EXPECT_EQ(std::ranges::count_if(visits[0].steps,
                      [](const StepEntry &entry) { return entry.step == Step::Firmware && entry.ended; }),
            isOld ? 2 : 1);
    }
}

/// Nothing that is installed is found; no programmer that hangs on this computer is touched.
struct WithoutPrograms {
    WithoutPrograms() { ::setenv("PATH", "/nowhere", 1); }
    WithoutPrograms(const WithoutPrograms &) = delete;
    WithoutPrograms &operator=(const WithoutPrograms &) = delete;
    ~WithoutPrograms() { ::setenv("PATH", before.c_str(), 1); }
    std::string before = qEnvironmentVariable("PATH").toStdString();
};

/// One of two nodes on a line was cut while its firmware was written through a programmer.
class MuteNodes : public CutUnits {
protected:
    MuteNodes()
    {
        cut.run = "of yesterday";
        cut.family = "supermodified";
        cut.device = "sim:serial/supermodified:4";
        cut.step = Step::Firmware;
        cut.simulated = true;
        Identity identity;
        identity.family = cut.family;
        identity.address = 4;
        cut.unit = unitKeyOf(identity, rack.link->line(), true);
        EXPECT_TRUE(test::run(rack.clock, books->journal->open(cut)));
    }
    [[nodiscard]] Visit visit() const { return books->visits()[0]; }

    const WithoutPrograms none;
    UnitRack rack{{"supermodified:4", "supermodified:5"}, "sim:serial"};
    const RecipeMatter matter = load(rack, R"({"recipe":1,"name":"nodes","family":"supermodified",
"firmware":{"file":"node.hex","via":"avrdude:usbasp:usb"}})");
    Visit cut;
};

TEST_F(MuteNodes, AreWrittenAgainOnlyWhereTheProgrammerCanHangOnNobodyElse)
{
    for (const bool isAlone : {false, true}) {
        rack.putOn(isAlone ? std::nullopt : std::optional<std::size_t>(1));
        QueueRun again(rack, *books, matter, options(cut.run, std::nullopt));
        ASSERT_TRUE(again.run());
        EXPECT_EQ(again.queue.trouble().has_value(), !isAlone);
        EXPECT_EQ(visit().outcome, isAlone ? Outcome::Failed : Outcome::Open) << "there is no program in the end";
        EXPECT_EQ(visit().cause.english().find("does not answer"), std::string::npos) << visit().cause.english();
    }
}

TEST_F(MuteNodes, WaitForWhoeverTakesTheOthersOffTheLineAndGoOnInTheirRow)
{
    rack.putOn(1);
    QueueRun again(rack, *books, matter, options(cut.run, 9));
    again.queue.start();
    const auto row = [&]() -> QueueRow {
        for (const auto &one : again.queue.rows()) {
            if (one->visit.device == cut.device)
                return *one;
        }
        return {};
    };
    ASSERT_TRUE(rack.clock.runUntil([&] { return row().state == RowState::Skipped; }, 1min));
    EXPECT_NE(row().visit.remedy.english().find("supermodified:5 answers"), std::string::npos)
        << row().visit.remedy.english();
    rack.putOn(std::nullopt);
    rack.clock.advance(5s);
    const auto id = row().id;
    ASSERT_TRUE(again.queue.retry(id));
    ASSERT_TRUE(rack.clock.runUntil([&] { return row().state == RowState::Failed; }, 2min));
    EXPECT_EQ(row().id, id);
    EXPECT_EQ(visit().outcome, Outcome::Failed);
    EXPECT_EQ(visit().cause.english().find("does not answer"), std::string::npos) << visit().cause.english();
}

TEST_F(Cuts, AtEveryWriteOfTheJournalTheQueueGoesOnAndNothingIsDoneTwice)
{
    int cuts = 0;
    for (const bool writesLast : {false, true}) {
        for (int lives = 0; cutAt(lives, writesLast) && !HasFailure(); ++lives)
            ++cuts;
    }
    std::printf("cut at %d writes of the journal, resumed each time\n", cuts);
    EXPECT_GE(cuts, 36);
}

} // namespace
} // namespace mb::service
