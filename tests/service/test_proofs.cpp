// SPDX-License-Identifier: GPL-3.0-or-later
// What a unit must not pass without: proof that it keeps what was written, every setting of the recipe, a serial number of its own.
#include "queuebench.h"
#include "support/loosemotor.h"

namespace mb::service {
namespace {

using namespace std::chrono_literals;
using test::QueueRun;
using test::ServiceBooks;
using test::UnitRack;

/// Every page was taken, and the version is that of before.
Task<UpdateReport> writtenBlind(Device &, const FirmwareImage &, UpdateOptions, Progress &)
{
    UpdateReport report;
    report.outcome = UpdateOutcome::Done;
    report.from = report.to = "1.3";
    report.pages = 4;
    report.evidence = say("nothing proves the new firmware");
    co_return report;
}

constexpr Family storingFamily = [] {
    Family family = test::looseFamily;
    family.update = &writtenBlind;
    family.capabilities.storesAfter = 15s;
    return family;
}();

constexpr Family untoldFamily = [] {
    Family family = storingFamily;
    family.capabilities.versionOnWire = false;
    return family;
}();

/// Answers, and cannot tell whether its flash was written.
class UnprovedUnit final : public test::MuteDevice {
public:
    UnprovedUnit(CanLink &link, Clock &clock, const Family &family = storingFamily, Identity identity = {})
        : MuteDevice(family, link, clock, std::move(identity))
    {
    }
    bool isStored = false;

private:
    Task<void> refresh() override { co_return {}; }
    Task<bool> store(Progress &) override { co_return isStored; }
    Result<void> doCommand(const SetPoint &) override { return {}; }
    void doStop() override { }
    [[nodiscard]] bool isSeenStopped() const override { return true; }
};

std::string told(const Visit &visit)
{
    return visit.cause.english() + " | " + visit.evidence.english();
}

TEST(Proofs, AUnitWhoseFlashIsNotProvedHasFailedAndSaysHowItCanBe)
{
    VirtualClock clock;
    test::LoggedLink link{clock, {Outlet::Form::CanSocket, 7}};
    ASSERT_TRUE(link.open());
    UnprovedUnit unit(link, clock);
    SetPointStream stream(unit, clock);
    ServiceBooks books(clock);
    RecipeMatter matter;
    NoProgress unseen;
    const auto serve = [&] {
        const ServiceSurroundings around{matter, *books.journal, nullptr, {}, nullptr, {}, {}};
        const Visit opened = *test::run(clock, books.journal->open({}));
        return *test::run(clock, serveUnit(unit, stream, opened, around, unseen));
    };
    const Visit failed = serve();
    EXPECT_EQ(failed.outcome, Outcome::Failed) << told(failed);
    EXPECT_EQ(failed.step, Step::Proof);
    EXPECT_EQ(failed.cause.english(), "nothing proves that its flash has what was written");
    unit.isStored = true;
    const Visit passed = serve();
    EXPECT_EQ(passed.outcome, Outcome::Passed) << told(passed);
    EXPECT_NE(passed.evidence.english().find("nothing had to be stored"), std::string::npos) << told(passed);
}

TEST(Proofs, AUnitThatWasWrittenWithoutProofSaysSo)
{
    VirtualClock clock;
    test::LoggedLink link{clock, {Outlet::Form::CanSocket, 7}};
    ASSERT_TRUE(link.open());
    UnprovedUnit unit(link, clock);
    unit.isStored = true;
    SetPointStream stream(unit, clock);
    ServiceBooks books(clock);
    RecipeMatter matter;
    matter.recipe.firmware = FirmwareRule{"new.hex", {}};
    NoProgress unseen;
    const ServiceSurroundings around{matter, *books.journal, nullptr, {}, nullptr, {}, {}};
    const Visit opened = *test::run(clock, books.journal->open({}));
    const Visit passed = *test::run(clock, serveUnit(unit, stream, opened, around, unseen));
    EXPECT_EQ(passed.outcome, Outcome::Passed) << told(passed);
    EXPECT_TRUE(passed.unproved);
    EXPECT_TRUE(books.visits().front().unproved) << "when it is looked up later";
    EXPECT_NE(
        passed.evidence.english().find("4 pages, 0 sent again; nothing proves the new firmware"), std::string::npos)
        << told(passed);
}

TEST(Proofs, AUnitThatAnswersWithAnotherVersionThanTheImageHasFailed)
{
    struct Row {
        const char *image;
        const Family *family;
        bool isWritten;
        Outcome outcome;
    };
    for (const Row &row : {Row{"9.9", &storingFamily, true, Outcome::Failed},
             {"1.0", &storingFamily, true, Outcome::Passed}, {"", &storingFamily, true, Outcome::Passed},
             {"9.9", &untoldFamily, true, Outcome::Passed}, {"9.9", &storingFamily, false, Outcome::Passed}}) {
        VirtualClock clock;
        test::LoggedLink link{clock, {Outlet::Form::CanSocket, 7}};
        ASSERT_TRUE(link.open());
        Identity identity;
        identity.firmware = "1.0";
        UnprovedUnit unit(link, clock, *row.family, identity);
        unit.isStored = true;
        SetPointStream stream(unit, clock);
        ServiceBooks books(clock);
        RecipeMatter matter;
        if (row.isWritten)
            matter.recipe.firmware = FirmwareRule{"new.hex", {}};
        matter.imageVersion = row.image;
        NoProgress unseen;
        const ServiceSurroundings around{matter, *books.journal, nullptr, {}, nullptr, {}, {}};
        const Visit opened = *test::run(clock, books.journal->open({}));
        const Visit visit = *test::run(clock, serveUnit(unit, stream, opened, around, unseen));
        EXPECT_EQ(visit.outcome, row.outcome) << row.image << ": " << told(visit);
        if (row.outcome == Outcome::Failed) {
            EXPECT_EQ(visit.step, Step::Proof);
            EXPECT_EQ(visit.cause.english(), "the unit answers with firmware 1.0, the image is 9.9");
        }
    }
}

class ProvedQueues : public ServiceQueues {
protected:
    RecipeMatter load(UnitRack &rack, const QByteArray &recipe, const QByteArray &parameters)
    {
        books.emplace(rack.clock);
        books->write("recipe.json", recipe);
        books->write("base.json", parameters);
        auto matter = loadRecipe(books->path("recipe.json"), rack.list());
        EXPECT_TRUE(matter) << (matter ? "" : matter.error().text());
        return matter ? *matter : RecipeMatter{};
    }
};

TEST_F(ProvedQueues, AUnitThatWasWrittenToSaysThatItsFlashHasIt)
{
    UnitRack rack({"dmc60c:5,serial=210334000001"});
    const RecipeMatter matter
        = load(rack, R"({"recipe":1,"name":"p","family":"dmc60c","parameters":{"file":"base.json"}})",
            R"({"family":"dmc60c","parameters":{"slot1.d":{"raw":77}}})");
    QueueRun run(rack, *books, matter);
    ASSERT_TRUE(run.run());
    EXPECT_NE(books->visits().front().evidence.english().find("its flash has it"), std::string::npos);
}

TEST_F(ProvedQueues, AUnitThatDoesNotOfferASettingOfTheRecipeIsRefusedWithItsName)
{
    for (const char *const dialect : {"D1", "D3"}) {
        UnitRack rack({std::string("supermodified:4,dialect=") + dialect}, "sim:serial");
        const RecipeMatter matter
            = load(rack, R"({"recipe":1,"name":"nodes","family":"supermodified","parameters":{"file":"base.json"}})",
                R"({"family":"supermodified","parameters":{"gain.p":{"raw":1100},"anti_windup":{"raw":4000}}})");
        QueueRun run(rack, *books, matter);
        ASSERT_TRUE(run.run());
        const auto visits = books->visits();
        ASSERT_EQ(visits.size(), 1U);
        if (std::string_view(dialect) == "D3") {
            EXPECT_EQ(visits[0].outcome, Outcome::Passed) << told(visits[0]);
            EXPECT_EQ(visits[0].parameters, 2);
            continue;
        }
        EXPECT_EQ(visits[0].outcome, Outcome::Refused) << told(visits[0]);
        EXPECT_NE(visits[0].cause.english().find("anti_windup"), std::string::npos) << told(visits[0]);
    }
}

TEST_F(ProvedQueues, ASettingThatActsAfterAPowerCycleIsNotTakenForAMistake)
{
    for (const char *const setting :
        {R"("limit.current.duration":{"raw":300})", R"("uart.baud":{"raw":19200})", R"("node.mask":{"raw":127})"}) {
        UnitRack rack({"supermodified:4,dialect=D1"}, "sim:serial");
        const RecipeMatter matter = load(rack,
            R"({"recipe":1,"name":"nodes","family":"supermodified","number":{"first":10},
"parameters":{"file":"base.json"}})",
            QByteArray(R"({"family":"supermodified","parameters":{"gain.p":{"raw":1100},)") + setting + "}}");
        QueueRun run(rack, *books, matter);
        ASSERT_TRUE(run.run());
        rack.unit(0).setPowered(false);
        rack.clock.advance(10s);
        rack.unit(0).setPowered(true);
        rack.clock.advance(10s);
        QueueRun again(rack, *books, matter);
        ASSERT_TRUE(again.run());
        const auto visits = books->visits();
        ASSERT_EQ(visits.size(), 2U) << setting;
        EXPECT_EQ(visits[0].outcome, Outcome::Passed) << told(visits[0]);
        EXPECT_NE(visits[0].evidence.english().find(
                      "1 setting holds from its next power cycle on, and nothing proves it before"),
            std::string::npos)
            << told(visits[0]);
        EXPECT_EQ(visits[0].parameters, 1) << "the other one was not read back";
        EXPECT_EQ(visits[1].outcome, Outcome::Passed) << told(visits[1]);
        EXPECT_NE(visits[1].evidence.english().find("0 of 2 settings written"), std::string::npos) << told(visits[1]);
        EXPECT_EQ(visits[1].parameters, 2);
    }
}

TEST_F(ProvedQueues, SettingsThatAreLostWithThePowerAreSaidToBe)
{
    for (const char *const store : {"false", "true"}) {
        UnitRack rack({"abstractdc:3"});
        const RecipeMatter matter = load(rack,
            QByteArray(R"({"recipe":1,"name":"p","family":"abstractdc","parameters":{"file":"base.json","store":)")
                + store + "}}",
            R"({"family":"abstractdc","parameters":{"velocity.p":{"raw":77},"velocity.i":{"raw":5}}})");
        QueueRun run(rack, *books, matter);
        ASSERT_TRUE(run.run());
        const Visit visit = books->visits().front();
        EXPECT_EQ(visit.outcome, Outcome::Passed) << told(visit);
        EXPECT_EQ(visit.evidence.english().find("2 settings are lost with its power") != std::string::npos,
            std::string_view(store) == "false")
            << told(visit);
    }
}

const QByteArray numbersRecipe = R"({"recipe":1,"name":"numbers","family":"dmc60c","number":{"first":10}})";

TEST_F(ProvedQueues, TwoUnitsOfOneSerialNumberAreBothRefusedAndTheThirdIsServed)
{
    UnitRack rack({"dmc60c:5,serial=210334000001", "dmc60c:7,serial=210334000001", "dmc60c:6,serial=210334000002"});
    const RecipeMatter matter = load(rack, numbersRecipe, {});
    QueueRun run(rack, *books, matter);
    ASSERT_TRUE(run.run());
    EXPECT_EQ(run.queue.counts().passed, 1);
    EXPECT_EQ(run.queue.counts().refused, 2);
    for (const Visit &visit : books->visits()) {
        if (visit.outcome == Outcome::Refused) {
            EXPECT_EQ(visit.cause.english(), "two units tell the serial number 210334000001");
        }
    }
}

TEST_F(ProvedQueues, OneOfTwoUnitsOfOneSerialNumberIsServedOnceTheOtherWasTakenOff)
{
    UnitRack rack({"dmc60c:5,serial=210334000001", "dmc60c:7,serial=210334000001"});
    QueueOptions options;
    options.units = 0;
    const RecipeMatter matter = load(rack, numbersRecipe, {});
    QueueRun run(rack, *books, matter, options);
    run.queue.start();
    ASSERT_TRUE(rack.clock.runUntil([&] { return run.queue.counts().refused == 2; }, 1min));
    rack.putOn(1);
    rack.clock.advance(10s);
    const auto rows = run.queue.rows();
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_TRUE(run.queue.retry(rows[1]->id));
    rack.clock.advance(1min);
    EXPECT_EQ(run.queue.counts().passed, 1);
}

TEST_F(ProvedQueues, TwoUnitsOfOneSerialNumberOnTwoBusesGetNoCommonNumber)
{
    UnitRack rack({"dmc60c:5,serial=210334000001"});
    UnitRack other({"dmc60c:7,serial=210334000001"}, "sim:can", &rack.clock);
    const RecipeMatter matter = load(rack, numbersRecipe, {});
    QueueRun run(rack, *books, matter);
    run.queue.addBus(*other.session, *other.link);
    ASSERT_TRUE(run.run());
    EXPECT_LE(run.queue.counts().passed, 1);
    EXPECT_EQ(run.queue.counts().ended(), 2);
}

const QByteArray storingRecipe
    = R"({"recipe":1,"name":"p","family":"dmc60c","number":{"first":10},"parameters":{"file":"base.json"}})";

/// Two buses, each with the units that tell 210334000001; A serves another one as well.
class TwoBuses : public ProvedQueues {
protected:
    void begin(std::optional<int> units)
    {
        a.emplace(std::vector<std::string>{"dmc60c:5,serial=210334000001", "dmc60c:6,serial=210334000002"});
        b.emplace(std::vector<std::string>{"dmc60c:7,serial=210334000001"}, "sim:can", &a->clock);
        a->putOn(0);
        QueueOptions options;
        options.units = units;
        run.emplace(
            *a, *books, load(*a, storingRecipe, R"({"family":"dmc60c","parameters":{"slot1.d":{"raw":77}}})"), options);
        run->queue.addBus(*b->session, *b->link);
    }
    [[nodiscard]] bool hasEnded(int passed, int refused)
    {
        return a->clock.runUntil(
            [&] { return run->queue.counts().passed == passed && run->queue.counts().refused == refused; }, 2min);
    }
    std::optional<UnitRack> a;
    std::optional<UnitRack> b;
    std::optional<QueueRun> run;
};

TEST_F(TwoBuses, OneOfTwoUnitsIsServedAgainOnceItsTwinWasTakenOffTheOtherBus)
{
    begin({});
    ASSERT_TRUE(run->run());
    ASSERT_EQ(run->queue.counts().refused, 2);
    b->putOn({});
    a->clock.advance(1s);
    const auto rows = run->queue.rows();
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_TRUE(run->queue.retry(rows[rows[0]->visit.device.ends_with(":5") ? 0 : 1]->id));
    EXPECT_TRUE(hasEnded(1, 1));
}

TEST_F(TwoBuses, AUnitOfALostLinkIsServedOnTheOther)
{
    begin(0);
    b->putOn({});
    run->queue.start();
    ASSERT_TRUE(hasEnded(1, 0));
    a->link->close();
    a->clock.advance(1s);
    b->putOn(0);
    EXPECT_TRUE(hasEnded(2, 0));
}

TEST_F(TwoBuses, AUnitThatIsMovedWhileItsBusServesTheNextIsServedOnTheOther)
{
    begin(0);
    a->unit(1).setPowered(true);
    b->putOn({});
    run->queue.start();
    ASSERT_TRUE(hasEnded(1, 0));
    a->clock.advance(50ms);
    ASSERT_EQ(run->queue.rows()[1]->state, RowState::Running);
    a->putOn(1);
    b->putOn(0);
    EXPECT_TRUE(hasEnded(3, 0));
}

TEST_F(TwoBuses, ARowOfWhichNothingChangedIsTheSameObjectForWhoeverLooks)
{
    begin({});
    b->putOn({});
    a->unit(1).setPowered(true);
    run->queue.start();
    ASSERT_TRUE(hasEnded(1, 0));
    const auto before = run->queue.rows();
    a->clock.advance(1s);
    const auto after = run->queue.rows();
    ASSERT_EQ(after.size(), 2U);
    EXPECT_TRUE(after[0].isSameAs(before[0])) << "it has ended";
    EXPECT_FALSE(after[1].isSameAs(before[1])) << "it is being served";
}

/// A journal whose disk is full from the n-th write on.
class FullJournal final : public ServiceJournal {
public:
    FullJournal(ServiceJournal &journal, int writes)
        : m_journal(journal)
        , left(writes)
    {
    }
    [[nodiscard]] Task<Visit> open(Visit visit) override
    {
        return left-- > 0 ? m_journal.open(std::move(visit)) : full();
    }
    [[nodiscard]] Task<Visit> write(Visit visit) override
    {
        return left-- > 0 ? m_journal.write(std::move(visit)) : full();
    }
    [[nodiscard]] Task<std::vector<Visit>> visits(VisitFilter filter) override
    {
        return m_journal.visits(std::move(filter));
    }
    [[nodiscard]] Task<std::optional<int>> number(NumberWish wish) override
    {
        return m_journal.number(std::move(wish));
    }

private:
    static Task<Visit> full() { co_return fail(Fault::NotKept, say("the disk is full"), say("make room")); }
    ServiceJournal &m_journal;

public:
    int left;
};

TEST_F(ProvedQueues, AUnitWhoseJournalIsFullIsNotRunningForEverAndGoesOnWhenThereIsRoom)
{
    for (const int writes : {0, 3}) {
        UnitRack rack({"dmc60c:5,serial=210334000001"});
        const RecipeMatter matter = load(rack, numbersRecipe, {});
        FullJournal journal(*books->journal, writes);
        QueueRun run(rack, *books, matter, {}, &journal);
        ASSERT_TRUE(run.run());
        ASSERT_TRUE(run.queue.trouble());
        const auto rows = run.queue.rows();
        ASSERT_EQ(rows.size(), 1U);
        EXPECT_EQ(rows[0]->state, RowState::Skipped);
        EXPECT_TRUE(rows[0]->what.empty()) << rows[0]->what.english();
        EXPECT_EQ(rows[0]->visit.cause.english(), "the disk is full");
        EXPECT_EQ(rows[0]->visit.outcome, Outcome::Open);
        journal.left = 1000;
        EXPECT_TRUE(run.queue.retry(rows[0]->id));
        ASSERT_TRUE(rack.clock.runUntil([&] { return run.queue.counts().passed == 1; }, 2min));
        EXPECT_EQ(books->visits().size(), 1U);
    }
}

} // namespace
} // namespace mb::service
