// SPDX-License-Identifier: GPL-3.0-or-later
// Units without a serial number: another one may stand in the same place. In virtual time.
#include "servicebench.h"

namespace mb::service {
namespace {

using namespace std::chrono_literals;
using test::QueueRun;
using test::ServiceBooks;
using test::UnitRack;

class UnitsByPlace : public testing::Test {
protected:
    RecipeMatter load(const UnitRack &rack, const QByteArray &recipe, const QByteArray &parameters = {})
    {
        books.emplace(rack.clock);
        books->write("recipe.json", recipe);
        books->write("base.json", parameters);
        auto matter = loadRecipe(books->path("recipe.json"), rack.list());
        EXPECT_TRUE(matter) << (matter ? "" : matter.error().text());
        return matter ? *matter : RecipeMatter{};
    }
    static QueueOptions units(int count, const std::string &run = {})
    {
        QueueOptions options;
        options.units = count;
        options.run = run;
        return options;
    }
    /// The bus is empty for long enough, then this one is on it.
    static void exchangeFor(UnitRack &rack, std::optional<std::size_t> place)
    {
        rack.putOn(std::nullopt);
        rack.clock.advance(1min); // a look at an empty bus takes long
        rack.putOn(place);
    }
    static bool waitFor(UnitRack &rack, QueueRun &run, int ended)
    {
        return rack.clock.runUntil([&] { return run.queue.counts().ended() >= ended; }, 3min);
    }
    std::optional<ServiceBooks> books;
};

const QByteArray driveRecipe
    = R"({"recipe":1,"name":"drives","family":"abstractdc","parameters":{"file":"base.json","store":true}})";
const QByteArray driveGains
    = R"({"family":"abstractdc","parameters":{"velocity.p":{"raw":77},"velocity.i":{"raw":5}}})";

TEST_F(UnitsByPlace, GainsThatCannotBeReadAreWrittenToTheNextUnitInThePlaceToo)
{
    UnitRack rack({"abstractdc:3", "abstractdc:3"});
    std::vector<std::size_t> saved;
    std::vector<Subscription> events;
    for (std::size_t i = 0; i < 2; ++i)
        events.push_back(rack.unit(i).events().add([&saved, i](const SimulatorEvent &event) {
            if (event.what == "settings-saved")
                saved.push_back(i);
        }));
    rack.putOn(0);
    QueueRun run(rack, *books, load(rack, driveRecipe, driveGains), units(2));
    run.queue.start();
    ASSERT_TRUE(waitFor(rack, run, 1));
    exchangeFor(rack, 1);
    ASSERT_TRUE(waitFor(rack, run, 2));
    const auto visits = books->visits();
    ASSERT_EQ(visits.size(), 2U);
    for (const Visit &visit : visits) {
        EXPECT_EQ(visit.outcome, Outcome::Passed) << visit.cause.english();
        const std::string &evidence = visit.evidence.english();
        EXPECT_NE(evidence.find("2 of 2 settings written"), std::string::npos) << evidence;
        EXPECT_NE(evidence.find("2 settings were written and cannot be read back"), std::string::npos) << evidence;
        EXPECT_EQ(evidence.find("proof: read back"), std::string::npos) << evidence;
        EXPECT_EQ(visit.parameters, 0) << "none was read back";
    }
    EXPECT_EQ(saved, (std::vector<std::size_t>{0, 1})) << "each has them in its flash";
}

TEST_F(UnitsByPlace, WhatIsKnownOfOneIsNotTakenForTheNext)
{
    UnitRack rack({"abstractdc:3", "abstractdc:3"});
    rack.putOn(0);
    QueueRun run(rack, *books, load(rack, driveRecipe, driveGains), units(2));
    run.queue.start();
    ASSERT_TRUE(waitFor(rack, run, 1));
    ASSERT_EQ(rack.session->devices().size(), 1U);
    rack.session->devices().front()->knowledge().setCounter("saves.velocity", 50);
    exchangeFor(rack, 1);
    ASSERT_TRUE(waitFor(rack, run, 2));
    const Visit next = books->visits().back();
    EXPECT_EQ(next.outcome, Outcome::Passed) << next.cause.english();
    EXPECT_NE(next.evidence.english().find("has 0 values"), std::string::npos) << next.evidence.english();
}

/// One command a board, and what is known of the place is kept from one to the next.
TEST_F(UnitsByPlace, NeitherIsItInAQueueOfItsOwnAndNobodyOwesItWhatTheOneBeforeHad)
{
    UnitRack rack({"abstractdc:3", "abstractdc:3"});
    rack.putOn(0);
    const RecipeMatter matter = load(rack, driveRecipe, driveGains);
    QueueRun first(rack, *books, matter);
    ASSERT_TRUE(first.run());
    DeviceKnowledge &known = rack.session->devices().front()->knowledge();
    known.setCounter("saves.velocity", 50);
    known.assume(*findParameter(rack.family->parameters, "position.p"), 9);
    exchangeFor(rack, 1);
    QueueRun second(rack, *books, matter);
    ASSERT_TRUE(second.run());
    const Visit next = books->visits().back();
    EXPECT_EQ(next.outcome, Outcome::Passed) << next.cause.english();
    EXPECT_NE(next.evidence.english().find("has 0 values"), std::string::npos) << next.evidence.english();
    EXPECT_TRUE(known.profile().lost.empty());
    EXPECT_FALSE(known.profile().written.contains("position.p"));
}

const QByteArray nodeRecipe = R"({"recipe":1,"name":"nodes","family":"supermodified","number":{"first":10}})";

TEST_F(UnitsByPlace, EachUnitOfAPlaceGetsANumberOfItsOwn)
{
    UnitRack rack({"supermodified:4", "supermodified:4"}, "sim:serial");
    rack.putOn(0);
    QueueRun run(rack, *books, load(rack, nodeRecipe), units(2));
    run.queue.start();
    ASSERT_TRUE(waitFor(rack, run, 1));
    exchangeFor(rack, 1);
    ASSERT_TRUE(waitFor(rack, run, 2));
    const auto visits = books->visits();
    ASSERT_EQ(visits.size(), 2U);
    EXPECT_EQ(visits[0].number, 10);
    EXPECT_EQ(visits[1].number, 11);
    for (const Visit &visit : visits)
        EXPECT_NE(visit.evidence.english().find("its number holds from its next power cycle on"), std::string::npos)
            << visit.evidence.english();
}

/// A look at an empty line of unknown rate takes 20 s, and asks nobody twice.
TEST_F(UnitsByPlace, WhoeverStandsWhereOneWasGoneForFiveSecondsIsTheNext)
{
    UnitRack rack({"supermodified:4", "supermodified:4"}, "sim:serial");
    rack.putOn(0);
    QueueRun run(rack, *books, load(rack, R"({"recipe":1,"name":"nodes","family":"supermodified"})"), units(2));
    run.queue.start();
    ASSERT_TRUE(waitFor(rack, run, 1));
    rack.clock.advance(10s);
    rack.putOn(std::nullopt);
    rack.clock.advance(5s);
    EXPECT_EQ(run.queue.counts().ended(), 1);
    rack.putOn(1);
    EXPECT_TRUE(rack.clock.runUntil([&] { return run.queue.counts().ended() == 2; }, 10s));
}

TEST_F(UnitsByPlace, WhoeverStandsWhereOneWasTakenOffWhileItWasServedIsTheNext)
{
    UnitRack rack({"supermodified:4", "supermodified:4"}, "sim:serial");
    rack.putOn(0);
    QueueRun run(rack, *books, load(rack, R"({"recipe":1,"name":"nodes","family":"supermodified"})"), units(2));
    run.queue.start();
    ASSERT_TRUE(rack.clock.runUntil(
        [&] { return !run.queue.rows().empty() && run.queue.rows()[0]->state == RowState::Running; }, 1min));
    rack.putOn(std::nullopt);
    ASSERT_TRUE(waitFor(rack, run, 1));
    rack.clock.advance(3s);
    rack.putOn(1);
    EXPECT_TRUE(rack.clock.runUntil([&] { return run.queue.counts().ended() == 2; }, 10s));
}

TEST_F(UnitsByPlace, AUnitThatWasSilentForAMomentIsNotServedAgain)
{
    UnitRack rack({"supermodified:4"}, "sim:serial");
    rack.putOn(0);
    QueueRun run(rack, *books, load(rack, R"({"recipe":1,"name":"nodes","family":"supermodified"})"), units(2));
    run.queue.start();
    ASSERT_TRUE(waitFor(rack, run, 1));
    for (int i = 0; i < 30; ++i) { // whatever the look does then
        rack.clock.advance(3s + i * 100ms);
        rack.putOn(std::nullopt);
        rack.clock.advance(1500ms);
        rack.putOn(0);
    }
    rack.clock.advance(1min);
    EXPECT_EQ(run.queue.counts().ended(), 1);
}

/// There it tells nothing by itself, so that only looks tell whether it is there.
TEST_F(UnitsByPlace, AUnitThatWaitsInItsBootloaderIsNotServedAgainUntilItWasGone)
{
    const QByteArray image = QByteArray::fromStdString(inSourceTree("resources/firmware/dmc60c-demo.hex"));
    const QByteArray writing = R"({"recipe":1,"name":"x","family":"dmc60c","firmware":{"file":")" + image + "\"}}";
    for (const QByteArray &recipe : {QByteArray(R"({"recipe":1,"name":"x","family":"dmc60c"})"), writing}) {
        UnitRack rack({"dmc60c:9,state=bootloader"});
        const auto fails = rack.unit(0).events().add([&rack](const SimulatorEvent &event) {
            if (event.what == "page-failed")
                rack.unit(0).disturb("flash-fail", 1);
        });
        rack.unit(0).disturb("flash-fail", 1);
        const RecipeMatter matter = load(rack, recipe);
        QueueRun run(rack, *books, matter, units(0));
        run.queue.start();
        ASSERT_TRUE(waitFor(rack, run, 1));
        rack.clock.advance(1min);
        EXPECT_EQ(run.queue.counts().ended(), 1) << recipe.constData();
        EXPECT_EQ(run.queue.counts().passed, 0);
        rack.putOn(std::nullopt);
        rack.clock.advance(4s);
        rack.putOn(0);
        EXPECT_TRUE(waitFor(rack, run, 2)) << recipe.constData();
    }
}

TEST_F(UnitsByPlace, AUnitWhoseLinkWasLostIsNotServedAgain)
{
    UnitRack rack({"supermodified:4"}, "sim:serial");
    rack.putOn(0);
    QueueRun run(rack, *books, load(rack, R"({"recipe":1,"name":"nodes","family":"supermodified"})"), units(0));
    run.queue.start();
    ASSERT_TRUE(waitFor(rack, run, 1));
    rack.clock.advance(5s);
    rack.link->close();
    rack.clock.advance(10s);
    ASSERT_FALSE(run.queue.isRunning());
    ASSERT_TRUE(rack.link->open());
    rack.clock.advance(10s);
    run.queue.start();
    rack.clock.advance(30s);
    EXPECT_EQ(books->visits().size(), 1U);
}

TEST_F(UnitsByPlace, WhoWaitsAndIsTakenOffIsNoRowAnyMoreAndWhoHasEndedStaysOne)
{
    UnitRack rack({"supermodified:4", "supermodified:5"}, "sim:serial");
    QueueRun run(rack, *books, load(rack, nodeRecipe), units(3));
    run.queue.start();
    ASSERT_TRUE(rack.clock.runUntil([&] { return run.queue.rows().size() == 2; }, 1min));
    run.queue.pause();
    ASSERT_TRUE(waitFor(rack, run, 1));
    ASSERT_EQ(run.queue.rows()[1]->state, RowState::Waiting);
    rack.putOn(std::nullopt);
    rack.clock.advance(1min);
    ASSERT_EQ(run.queue.rows().size(), 1U);
    EXPECT_EQ(run.queue.rows()[0]->state, RowState::Passed) << run.queue.rows()[0]->visit.cause.english();
}

TEST_F(UnitsByPlace, ALookAtAnEmptyLineDoesNotKeepTheQueueFromEnding)
{
    UnitRack rack({"supermodified:4"}, "sim:serial");
    rack.putOn(std::nullopt);
    QueueRun run(rack, *books, load(rack, nodeRecipe), units(0));
    run.queue.start();
    rack.clock.advance(5s);
    run.queue.finish();
    EXPECT_TRUE(rack.clock.runUntil([&] { return run.isEnded; }, 1s));
}

TEST_F(UnitsByPlace, AUnitThatComesBackUnderItsNewNumberIsNotServedAgain)
{
    UnitRack rack({"supermodified:4", "supermodified:4"}, "sim:serial");
    rack.putOn(0);
    QueueRun run(rack, *books, load(rack, nodeRecipe), units(2));
    run.queue.start();
    ASSERT_TRUE(waitFor(rack, run, 1));
    exchangeFor(rack, 0);
    rack.clock.advance(1min);
    EXPECT_EQ(run.queue.counts().ended(), 1) << "it is known by its number";
    rack.unit(1).setPowered(true);
    ASSERT_TRUE(waitFor(rack, run, 2)) << "another one in the place where it was";
    const auto visits = books->visits();
    ASSERT_EQ(visits.size(), 2U);
    EXPECT_EQ(visits[1].device, "sim:serial/supermodified:4");
    EXPECT_EQ(visits[1].number, 11);
}

TEST_F(UnitsByPlace, AQueueThatGoesOnServesWhoeverStandsWhereOneHasEnded)
{
    UnitRack rack({"abstractdc:3", "abstractdc:3"});
    rack.putOn(0);
    const RecipeMatter matter = load(rack, driveRecipe, driveGains);
    std::string name;
    {
        QueueRun run(rack, *books, matter);
        ASSERT_TRUE(run.run());
        name = run.queue.run();
    }
    exchangeFor(rack, 1);
    QueueOptions options;
    options.run = name;
    QueueRun again(rack, *books, matter, options);
    ASSERT_TRUE(again.run());
    const auto visits = books->visits();
    ASSERT_EQ(visits.size(), 2U) << "this place, not this unit";
    EXPECT_NE(visits[1].evidence.english().find("2 of 2 settings written"), std::string::npos);
}

class CutPlaces : public UnitsByPlace {
protected:
    /// Served until its number is reserved, or written; the name of the run.
    std::string cut(UnitRack &rack, const RecipeMatter &matter, bool isWritten = false)
    {
        QueueRun run(rack, *books, matter, units(1));
        run.queue.start();
        EXPECT_TRUE(rack.clock.runUntil(
            [&] {
                const auto rows = run.queue.rows();
                return !rows.empty() && rows[0]->visit.number
                    && (!isWritten || timesEnded(rows[0]->visit, Step::Number) > 0);
            },
            1min));
        return run.queue.run();
    }
    /// Goes on with what was cut: one visit, which passes with this number.
    Visit goOn(UnitRack &rack, const RecipeMatter &matter, const std::string &name, int number)
    {
        QueueRun again(rack, *books, matter, units(1, name));
        EXPECT_TRUE(again.run());
        EXPECT_EQ(again.queue.rows().size(), 1U);
        const auto visits = books->visits();
        EXPECT_EQ(visits.size(), 1U);
        const Visit visit = visits.empty() ? Visit() : visits.front();
        EXPECT_EQ(visit.outcome, Outcome::Passed) << visit.cause.english();
        EXPECT_EQ(visit.number, number);
        return visit;
    }
    static int timesEnded(const Visit &visit, Step step)
    {
        return static_cast<int>(std::count_if(visit.steps.begin(), visit.steps.end(),
            [step](const StepEntry &entry) { return entry.step == step && entry.ended; }));
    }
};

TEST_F(CutPlaces, GoOnWithTheirNumberAndAllElseIsDoneAgain)
{
    UnitRack rack({"supermodified:4", "supermodified:4"}, "sim:serial");
    rack.putOn(0);
    const RecipeMatter matter = load(rack, nodeRecipe);
    const std::string name = cut(rack, matter);
    exchangeFor(rack, 1);
    const Visit visit = goOn(rack, matter, name, 10);
    EXPECT_EQ(timesEnded(visit, Step::Backup), 2) << "the backup of the unit that is there now";
}

TEST_F(CutPlaces, GiveNoNumberTwiceOnceItWasWritten)
{
    UnitRack rack({"supermodified:4", "supermodified:4"}, "sim:serial");
    rack.putOn(0);
    const RecipeMatter matter = load(rack, nodeRecipe);
    const std::string name = cut(rack, matter, true);
    exchangeFor(rack, 1);
    QueueRun again(rack, *books, matter, units(2, name));
    ASSERT_TRUE(again.run());
    const auto visits = books->visits();
    ASSERT_EQ(visits.size(), 2U);
    EXPECT_EQ(visits[0].outcome, Outcome::Failed) << "nobody has seen it since";
    EXPECT_EQ(visits[0].number, 10);
    EXPECT_EQ(visits[1].outcome, Outcome::Passed) << visits[1].cause.english();
    EXPECT_EQ(visits[1].number, 11);
}

TEST_F(CutPlaces, GoOnUnderTheirNumberOnceItWasWritten)
{
    UnitRack rack({"supermodified:4"}, "sim:serial");
    rack.putOn(0);
    const RecipeMatter matter = load(rack, nodeRecipe);
    const std::string name = cut(rack, matter, true);
    exchangeFor(rack, 0); // under its number now
    goOn(rack, matter, name, 10);
}

TEST_F(CutPlaces, GoOnUnderANumberThatTheyHadBefore)
{
    UnitRack rack({"supermodified:4"}, "sim:serial");
    const RecipeMatter matter
        = load(rack, R"({"recipe":1,"name":"nodes","family":"supermodified","number":{"first":4}})");
    const std::string name = cut(rack, matter, true);
    goOn(rack, matter, name, 4);
}

/// A server of numbers that is silent until it is told to answer.
class SilentNumbers final : public ServiceJournal {
public:
    explicit SilentNumbers(ServiceJournal &journal)
        : m_journal(journal)
    {
    }
    [[nodiscard]] Task<Visit> open(Visit visit) override { return m_journal.open(std::move(visit)); }
    [[nodiscard]] Task<Visit> write(Visit visit) override { return m_journal.write(std::move(visit)); }
    [[nodiscard]] Task<std::vector<Visit>> visits(VisitFilter filter) override
    {
        return m_journal.visits(std::move(filter));
    }
    [[nodiscard]] Task<std::optional<int>> number(NumberWish wish) override
    {
        ++asked;
        if (!answers)
            co_return fail(Fault::Timeout, say("the server does not answer"));
        co_return co_await m_journal.number(std::move(wish));
    }
    int asked = 0;
    bool answers = false;

private:
    ServiceJournal &m_journal;
};

class WaitingForANumber : public UnitsByPlace {
protected:
    WaitingForANumber()
        : rack({"dmc60c:5,serial=210334000001,session=0x1111", "dmc60c:5,serial=210334000002,session=0x2222"})
        , matter(load(rack, R"({"recipe":1,"name":"numbers","family":"dmc60c","number":{"first":10}})"))
        , silent(*books->journal)
        , run(rack, *books, matter, units(1), &silent)
    {
        rack.putOn(0);
        run.queue.start();
        EXPECT_TRUE(rack.clock.runUntil([this] { return silent.asked > 0; }, 1min));
    }
    Visit end()
    {
        EXPECT_TRUE(rack.clock.runUntil([this] { return run.isEnded; }, 2min));
        const auto visits = books->visits();
        EXPECT_EQ(visits.size(), 1U);
        return visits.empty() ? Visit() : visits.front();
    }
    UnitRack rack;
    RecipeMatter matter;
    SilentNumbers silent;
    QueueRun run;
};

TEST_F(WaitingForANumber, AUnitThatIsTakenOffHasFailedAfterTwoSeconds)
{
    rack.clock.advance(1min);
    EXPECT_EQ(run.queue.counts().ended(), 0) << "while it is there it waits";
    rack.putOn(std::nullopt);
    rack.clock.advance(6s);
    EXPECT_EQ(run.queue.counts().failed, 1);
    const Visit visit = end();
    EXPECT_EQ(visit.outcome, Outcome::Failed);
    EXPECT_EQ(visit.cause.english(), "the unit was taken off while it waited for a number");
}

TEST_F(WaitingForANumber, TheUnitThatTookItsPlaceMeanwhileIsGivenNone)
{
    rack.clock.advance(10s);
    rack.putOn(1);
    rack.clock.advance(1500ms);
    silent.answers = true;
    const Visit visit = end();
    EXPECT_EQ(visit.outcome, Outcome::Failed);
    EXPECT_EQ(visit.cause.english(), "this is another unit by now, number 210334000002") << visit.cause.english();
    const auto found = test::run(rack.clock, rack.session->scan(*rack.link));
    ASSERT_TRUE(found);
    ASSERT_EQ(found->size(), 1U);
    EXPECT_EQ(found->front()->identity().serial, "210334000002");
    EXPECT_EQ(found->front()->identity().address, 5) << "it keeps its own";
}

} // namespace
} // namespace mb::service
