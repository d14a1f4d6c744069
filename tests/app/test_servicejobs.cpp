// SPDX-License-Identifier: GPL-3.0-or-later
// Units served in the engine's session: the link is lent, nothing turns unarmed, STOP ends all. Virtual time.
#include "app/engine/enginecore.h"
#include "async/virtualclock.h"
#include "heard.h"
#include "model/registry.h"
#include "storage/servicebook.h"
#include "storage/settingsbook.h"
#include "storage/trialbook.h"
#include "support/coreapplication.h"
#include "support/sourcetree.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QTemporaryDir>

#include <algorithm>

namespace mb {
namespace {

using namespace std::chrono_literals;

class Served : public testing::Test {
protected:
    Served()
    {
        test::needCoreApplication();
        auto opened = Database::open(folder.path().toStdString() + "/motorbench.db");
        EXPECT_TRUE(opened) << (opened ? "" : opened.error().text());
        database = std::move(*opened);
        journal = std::make_unique<ServiceBook>(*database, clock, "bench 1", "anna");
        settings = std::make_unique<SettingsBook>(*database, clock, "anna");
        trials = std::make_unique<TrialBook>(*database, clock);
        core = std::make_unique<EngineCore>(clock, families(), false);
        core->setSettingsLog(settings.get());
        core->send(orders::OpenLink{*LinkAddress::parse("sim:can")});
        EXPECT_TRUE(clock.runUntil([this] { return device(7) && device(7)->liveness().heard; }, 10s));
        clock.advance(3s);
        core->service().setBooks({journal.get(), settings.get(), trials.get()}, "bench 1");
    }
    /// What came of the order, which is answered at once.
    [[nodiscard]] Result<void> serve(orders::ServeUnits order)
    {
        test::Heard<> begun;
        core->send(std::move(order), begun.finished());
        EXPECT_TRUE(begun.has_value());
        return begun ? *begun : fail(Fault::Timeout);
    }
    [[nodiscard]] ServiceView view() const { return core->service().view(); }
    /// An order to a unit of the link is refused.
    [[nodiscard]] bool isLent()
    {
        test::Heard<> named;
        core->send(orders::Identify{core->session().idOf(*device(7))}, named.finished());
        return named && !*named;
    }
    [[nodiscard]] Device *device(int address)
    {
        for (Device *one : core->session().devices()) {
            if (one->identity().address == address && one->family().key == "dmc60c")
                return one;
        }
        return nullptr;
    }
    [[nodiscard]] std::shared_ptr<const service::RecipeMatter> recipe(const QByteArray &text)
    {
        QFile file(folder.filePath(QStringLiteral("recipe.json")));
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(text);
        file.close();
        auto loaded = service::loadRecipe(file.fileName().toStdString(), families());
        EXPECT_TRUE(loaded) << (loaded ? "" : loaded.error().text());
        return loaded ? std::make_shared<const service::RecipeMatter>(std::move(*loaded)) : nullptr;
    }
    [[nodiscard]] bool anyMoves()
    {
        const auto all = core->session().devices();
        return std::any_of(all.begin(), all.end(), [](const Device *one) { return one->liveness().moving; });
    }

    QTemporaryDir folder;
    VirtualClock clock;
    std::unique_ptr<Database> database;
    std::unique_ptr<ServiceBook> journal;
    std::unique_ptr<SettingsBook> settings;
    std::unique_ptr<TrialBook> trials;
    std::unique_ptr<EngineCore> core;

    /// The row whose self-test waits for arming.
    [[nodiscard]] service::QueueRow waiting() const
    {
        for (const service::QueueRow &row : view().rows) {
            if (row.state == service::RowState::Running)
                return row;
        }
        return {};
    }
    /// With a window that watches over the motors.
    [[nodiscard]] bool renewedUntil(const std::function<bool()> &is)
    {
        return clock.runUntil(
            [&] {
                core->send(orders::RenewService{});
                return is();
            },
            5min);
    }

    const QByteArray plain = R"({"recipe":1,"name":"look","family":"dmc60c"})";
    const QByteArray moving = R"({"recipe":1,"name":"turn","family":"dmc60c","test":{"loop":"velocity","to":2000,
"limits":{"travel":20000,"speed":20000,"duty":0.5,"current":40},"accept":{"overshoot":9}}})";
    const QByteArray failing = R"({"recipe":1,"name":"strict","family":"dmc60c","test":{"loop":"velocity","to":2000,
"limits":{"travel":20000,"speed":20000,"duty":0.5,"current":40},"accept":{"settle":0.001}}})";
};

TEST_F(Served, EveryUnitOfALinkAndTheEngineLeavesItAloneMeanwhile)
{
    ASSERT_TRUE(serve({recipe(plain), {"sim:can"}, std::nullopt}));
    EXPECT_TRUE(view().running);
    test::Heard<> refused;
    core->send(orders::Identify{core->session().idOf(*device(7))}, refused.finished());
    ASSERT_TRUE(refused.has_value());
    EXPECT_FALSE(*refused) << "the link is lent";
    ASSERT_TRUE(clock.runUntil([this] { return !view().running; }, 10min));
    EXPECT_GE(view().counts.passed, 2);
    EXPECT_EQ(view().counts.ended(), static_cast<int>(view().rows.size()));
    EXPECT_GE(journal->list({})->size(), static_cast<std::size_t>(view().counts.passed));
    core->send(orders::Identify{core->session().idOf(*device(7))}, refused.finished());
    ASSERT_TRUE(clock.runUntil([&refused] { return refused && *refused; }, 10s)) << "it is given back";
}

TEST_F(Served, NoHandReachesIntoALinkThatIsLent)
{
    const DeviceId seven = core->session().idOf(*device(7));
    SetPoint slow;
    slow.mode = Mode::Duty;
    slow.target = 0.1;
    ASSERT_TRUE(serve({recipe(moving), {"sim:can"}, std::nullopt}));
    test::Heard<> started;
    core->send(orders::StartMotion{seven, slow, 500ms}, started.finished());
    ASSERT_TRUE(started.has_value());
    EXPECT_FALSE(*started);
    test::Heard<> released;
    core->send(orders::ReleaseMoves{seven}, released.finished());
    ASSERT_TRUE(released.has_value());
    EXPECT_EQ(released->error().detail.english(), "units are served on this link");
    test::Heard<> sent;
    core->send(orders::SendFrame{"sim:can", *canFrameFromText("123#00")}, sent.finished());
    ASSERT_TRUE(sent.has_value());
    EXPECT_FALSE(*sent);
    clock.advance(200ms);
    EXPECT_FALSE(anyMoves());
}

TEST_F(Served, ALinkWhoseMotorIsDrivenByHandIsNotServed)
{
    const DeviceId seven = core->session().idOf(*device(7));
    SetPoint slow;
    slow.mode = Mode::Duty;
    slow.target = 0.1;
    test::Heard<> started;
    core->send(orders::StartMotion{seven, slow, 500ms}, started.finished());
    ASSERT_TRUE(*started);
    EXPECT_FALSE(serve({recipe(moving), {"sim:can"}, std::nullopt}));
    EXPECT_FALSE(view().running);
    core->send(orders::StopMotion{seven});
    EXPECT_TRUE(serve({recipe(moving), {"sim:can"}, std::nullopt}));
}

TEST_F(Served, TheSameLinkAgainAndARetryOfNothingGivesItBack)
{
    for (int round = 0; round < 2; ++round) {
        ASSERT_TRUE(serve({recipe(plain), {"sim:can"}, std::nullopt}));
        EXPECT_FALSE(serve({recipe(plain), {"sim:can"}, std::nullopt})) << "it runs";
        EXPECT_TRUE(isLent());
        ASSERT_TRUE(clock.runUntil([this] { return !view().running; }, 10min));
        EXPECT_GE(view().counts.passed, 2);
        core->send(orders::RetryUnit{12345});
        EXPECT_FALSE(view().running);
    }
    test::Heard<> free;
    core->send(orders::Identify{core->session().idOf(*device(7))}, free.finished());
    ASSERT_TRUE(clock.runUntil([&free] { return free.has_value(); }, 10s));
    EXPECT_TRUE(*free);
}

TEST_F(Served, NothingTurnsUnlessItIsArmed)
{
    ASSERT_TRUE(serve({recipe(moving), {"sim:can"}, std::nullopt}));
    EXPECT_FALSE(clock.runUntil([this] { return anyMoves() || !view().running; }, 20min));
    EXPECT_TRUE(view().waits);
    EXPECT_EQ(waiting().visit.step, service::Step::Test);
    EXPECT_EQ(waiting().what.english(), "waits until the station is armed");
    EXPECT_TRUE(waiting().mayInterrupt);
    EXPECT_EQ(view().counts.failed, 0);
    core->send(orders::CancelService{});
    ASSERT_TRUE(clock.runUntil([this] { return !view().running; }, 1min));
    EXPECT_EQ(view().counts.passed + view().counts.failed, 0) << "it goes on when it is resumed";
    EXPECT_FALSE(view().waits);
}

TEST_F(Served, WhoWaitsForArmingGoesOnByItselfAndWhoComesAfterAFailWaits)
{
    ASSERT_TRUE(serve({recipe(failing), {"sim:can"}, std::nullopt}));
    ASSERT_TRUE(clock.runUntil([this] { return view().waits; }, 5min));
    clock.advance(1min);
    const std::uint32_t first = waiting().id;
    core->send(orders::ArmService{true});
    EXPECT_FALSE(view().waits);
    ASSERT_TRUE(renewedUntil([this] { return view().counts.failed == 1; }));
    EXPECT_FALSE(view().armed) << "FAIL disarms";
    ASSERT_TRUE(renewedUntil([this] { return view().waits; }));
    EXPECT_NE(waiting().id, first);
    clock.advance(1min);
    EXPECT_EQ(view().counts.failed, 1) << "the next waits, and has not failed";
    core->send(orders::ArmService{true});
    ASSERT_TRUE(renewedUntil([this] { return !view().running; }));
    EXPECT_EQ(view().counts.failed, 2);
    for (const service::QueueRow &row : view().rows) {
        if (row.state == service::RowState::Failed) {
            EXPECT_NE(row.visit.cause.english().find("settle"), std::string::npos) << row.visit.cause.english();
        }
    }
}

TEST_F(Served, AFailOnOneBusEndsNoSelfTestOnAnother)
{
    core->send(orders::OpenLink{*LinkAddress::parse("sim:can?seed=2")});
    clock.advance(5s);
    ASSERT_TRUE(serve({recipe(failing), {"sim:can", "sim:can?seed=2"}, std::nullopt}));
    core->send(orders::ArmService{true});
    EXPECT_TRUE(clock.runUntil(
        [this] {
            if (view().armed || view().permitted) // as the page does
                core->send(orders::RenewService{});
            if (!view().armed && view().counts.failed % 2 == 0)
                core->send(orders::ArmService{true});
            return view().counts.failed >= 4;
        },
        10min));
    for (const service::QueueRow &row : view().rows) {
        if (row.state == service::RowState::Failed) {
            EXPECT_NE(row.visit.cause.english().find("settle"), std::string::npos) << row.visit.cause.english();
        }
    }
    core->send(orders::ArmService{false});
    EXPECT_FALSE(view().permitted) << "whoever disarms ends what runs, too";
}

TEST_F(Served, DisarmedInTheLastThreeSecondsItWaitsAgain)
{
    ASSERT_TRUE(serve({recipe(moving), {"sim:can"}, std::nullopt}));
    core->send(orders::ArmService{true});
    ASSERT_TRUE(clock.runUntil([this] { return view().announces; }, 5min));
    core->send(orders::ArmService{false});
    ASSERT_FALSE(clock.runUntil([this] { return anyMoves(); }, 1min));
    EXPECT_TRUE(view().waits);
    EXPECT_FALSE(view().announces);
    EXPECT_EQ(view().counts.failed, 0);
    core->send(orders::ArmService{true});
    EXPECT_TRUE(renewedUntil([this] { return anyMoves(); }));
}

TEST_F(Served, ArmedAnewInTheLastThreeSecondsItIsAnnouncedAnew)
{
    ASSERT_TRUE(serve({recipe(moving), {"sim:can"}, std::nullopt}));
    core->send(orders::ArmService{true});
    ASSERT_TRUE(clock.runUntil([this] { return view().announces; }, 5min));
    clock.advance(200ms);
    core->send(orders::ArmService{false});
    clock.advance(2600ms);
    core->send(orders::ArmService{true});
    const Instant armed = clock.now();
    EXPECT_TRUE(renewedUntil([this] { return anyMoves(); }));
    EXPECT_GE(clock.now() - armed, 3s);
}

TEST_F(Served, AUnitThatIsTakenOffWhileItWaitsForArmingHasFailedForThat)
{
    ASSERT_TRUE(serve({recipe(moving), {"sim:can"}, std::nullopt}));
    ASSERT_TRUE(clock.runUntil([this] { return view().waits; }, 5min));
    const std::uint32_t first = waiting().id;
    const int address = core->session().find(waiting().device)->identity().address;
    for (Simulator *unit : core->session().bench(*core->session().links().front())->simulators()) {
        if (unit->name() == "dmc60c:" + std::to_string(address))
            unit->setPowered(false);
    }
    ASSERT_TRUE(clock.runUntil([this] { return view().counts.failed == 1; }, 1min));
    const service::QueueRow row = view().rows.front();
    EXPECT_EQ(row.id, first);
    EXPECT_NE(row.visit.cause.english().find("taken off"), std::string::npos) << row.visit.cause.english();
    ASSERT_TRUE(clock.runUntil([this] { return view().waits; }, 1min)) << "and the rest goes on";
}

TEST_F(Served, ArmedItSaysSoThreeSecondsBeforeAMotorTurns)
{
    ASSERT_TRUE(serve({recipe(moving), {"sim:can"}, std::nullopt}));
    core->send(orders::ArmService{true});
    EXPECT_TRUE(view().armed);
    ASSERT_TRUE(clock.runUntil([this] { return view().announces; }, 5min));
    const Instant told = clock.now();
    ASSERT_TRUE(clock.runUntil(
        [this] {
            core->send(orders::RenewService{});
            return anyMoves();
        },
        1min));
    EXPECT_GE(clock.now() - told, 3s);
    core->stopAll(StopCause::User);
    core->stopAll(StopCause::User);
    EXPECT_FALSE(view().armed);
    ASSERT_TRUE(clock.runUntil([this] { return !view().running && !anyMoves(); }, 30s));
}

TEST_F(Served, WhoeverEndsItDisarms)
{
    ASSERT_TRUE(serve({recipe(moving), {"sim:can"}, 0}));
    core->send(orders::ArmService{true});
    core->send(orders::FinishService{});
    EXPECT_FALSE(view().armed);
    EXPECT_FALSE(serve({recipe(moving), {"sim:nowhere"}, 0})) << "no such link";
}

TEST_F(Served, AQueueThatWasEndedWaitsForNoArmingWhateverIsRefusedMeanwhile)
{
    ASSERT_TRUE(serve({recipe(moving), {"sim:can"}, std::nullopt}));
    ASSERT_TRUE(clock.runUntil([this] { return view().counts.failed > 0 || waiting().id != 0; }, 1min));
    ASSERT_FALSE(view().waits) << "its self-test is yet to come";
    core->send(orders::FinishService{});
    test::Heard<> retried;
    core->send(orders::RetryUnit{waiting().id}, retried.finished());
    ASSERT_TRUE(retried.has_value());
    EXPECT_FALSE(*retried);
    core->send(orders::RetryFailedUnits{});
    EXPECT_TRUE(clock.runUntil([this] { return !view().running; }, 5min));
    EXPECT_FALSE(view().waits);
}

TEST_F(Served, TickedUnitsOnlyAndTheOthersAreLeftOut)
{
    const DeviceId seven = core->session().idOf(*device(7));
    ASSERT_TRUE(serve({recipe(plain), {"sim:can"}, std::nullopt, std::vector{seven}}));
    ASSERT_TRUE(clock.runUntil([this] { return !view().running; }, 10min));
    const ServiceView last = view();
    EXPECT_EQ(last.counts.ended(), 1);
    for (const service::QueueRow &row : last.rows)
        EXPECT_EQ(row.state, row.device == seven ? service::RowState::Passed : service::RowState::Skipped);
    EXPECT_GE(last.rows.size(), 2U);
    EXPECT_FALSE(last.run.empty());
    EXPECT_EQ(last.matter->recipe.name, "look");
}

TEST_F(Served, AnotherLinkThatIsNotThereLendsNone)
{
    EXPECT_FALSE(serve({recipe(plain), {"sim:can", "sim:nowhere"}, std::nullopt}));
    EXPECT_FALSE(isLent()) << "it was given back";
}

TEST_F(Served, ALinkOnWhichUnitsAreServedStaysOpen)
{
    ASSERT_TRUE(serve({recipe(plain), {"sim:can"}, std::nullopt}));
    test::Heard<> closed;
    core->send(orders::CloseLink{"sim:can"}, closed.finished());
    ASSERT_TRUE(closed.has_value());
    EXPECT_FALSE(*closed);
    ASSERT_TRUE(clock.runUntil([this] { return !view().running; }, 10min));
    const auto rows = view().rows.size();
    core->send(orders::CloseLink{"sim:can"}, closed.finished());
    EXPECT_TRUE(*closed);
    EXPECT_EQ(view().rows.size(), rows) << "what came of it stays in sight";
    core->send(orders::RetryFailedUnits{}); // of a queue that is gone: nothing
    EXPECT_FALSE(view().running);
}

/// The firmware of the bench, over all three units that take it.
class Updated : public Served {
protected:
    [[nodiscard]] std::shared_ptr<const service::RecipeMatter> update()
    {
        service::Recipe recipe;
        recipe.name = "demo";
        recipe.family = &device(7)->family();
        recipe.firmware = service::FirmwareRule{inSourceTree("resources/firmware/dmc60c-demo.hex"), {}};
        auto matter = service::gatherMatter(std::move(recipe), folder.path().toStdString());
        EXPECT_TRUE(matter) << (matter ? "" : matter.error().text());
        return matter ? std::make_shared<const service::RecipeMatter>(std::move(*matter)) : nullptr;
    }
    [[nodiscard]] std::vector<DeviceId> units()
    {
        return {core->session().idOf(*device(5)), core->session().idOf(*device(7)), core->session().idOf(*device(9))};
    }
    [[nodiscard]] service::QueueRow row(int address)
    {
        const Device *unit = device(address);
        for (const service::QueueRow &row : view().rows) {
            if (unit && row.device == core->session().idOf(*unit))
                return row;
        }
        return {};
    }
    [[nodiscard]] Simulator *simulated(int address)
    {
        for (const Link *link : core->session().links()) {
            for (Simulator *unit : core->session().bench(*link)->simulators()) {
                if (unit->name() == "dmc60c:" + std::to_string(address))
                    return unit;
            }
        }
        return nullptr;
    }
    /// Pages of the unit of this number are being written.
    [[nodiscard]] bool writes(int address)
    {
        return clock.runUntil(
            [this, address] {
                const service::QueueRow now = row(address);
                return now.state == service::RowState::Running && now.mayInterrupt && now.done > 5 && now.total > 20;
            },
            5min);
    }
    void expectAllEnded()
    {
        ASSERT_TRUE(clock.runUntil([this] { return !view().running; }, 20min));
    }
};

TEST_F(Updated, ACableThatComesOutInTheMiddleFailsItsRowAndTheRestGoesOn)
{
    ASSERT_TRUE(serve({update(), {"sim:can"}, std::nullopt, units()}));
    ASSERT_TRUE(writes(5));
    simulated(5)->setPowered(false);
    expectAllEnded();
    const service::QueueRow failed = row(5);
    EXPECT_EQ(failed.state, service::RowState::Failed);
    EXPECT_FALSE(failed.visit.cause.empty());
    ASSERT_TRUE(failed.log);
    EXPECT_FALSE(failed.log->empty());
    EXPECT_EQ(row(7).state, service::RowState::Passed);
    EXPECT_EQ(row(9).state, service::RowState::Passed) << row(9).visit.cause.english();
    EXPECT_EQ(view().counts.failed, 1);
    simulated(5)->setPowered(true);
    clock.advance(2s);
    core->send(orders::RetryFailedUnits{});
    EXPECT_TRUE(view().running);
    expectAllEnded();
    EXPECT_EQ(view().counts.passed, 3) << row(5).visit.cause.english();
    EXPECT_EQ(device(5)->identity().firmware, "1.25");
}

TEST_F(Updated, CancelEndsWhereNothingMustNotBeCutAndTheRunGoesOnFromTheJournal)
{
    ASSERT_TRUE(serve({update(), {"sim:can"}, std::nullopt, units()}));
    ASSERT_TRUE(writes(5));
    const std::string run = view().run;
    core->send(orders::CancelService{});
    ASSERT_TRUE(clock.runUntil([this] { return !view().running; }, 1min));
    EXPECT_EQ(view().counts.ended(), 0);
    service::VisitFilter filter;
    filter.run = run;
    auto visits = journal->list(filter);
    ASSERT_TRUE(visits);
    ASSERT_EQ(visits->size(), 1U);
    EXPECT_EQ(visits->front().outcome, service::Outcome::Open);
    ASSERT_TRUE(serve({update(), {"sim:can"}, std::nullopt, std::vector<DeviceId>(), run}));
    expectAllEnded();
    EXPECT_EQ(view().counts.passed, 1) << "what was cut off only";
    EXPECT_EQ(journal->list(filter)->size(), 1U) << "no visit twice";
    ASSERT_TRUE(serve({update(), {"sim:can"}, std::nullopt, units(), run}));
    expectAllEnded();
    EXPECT_EQ(view().counts.passed, 3);
    EXPECT_EQ(journal->list(filter)->size(), 3U);
}

TEST_F(Updated, AProgramThatDiesInTheMiddleGoesOnFromTheJournal)
{
    ASSERT_TRUE(serve({update(), {"sim:can"}, std::nullopt, units()}));
    ASSERT_TRUE(clock.runUntil([this] { return view().counts.passed == 1; }, 5min));
    clock.advance(2s);
    const std::string run = view().run;
    core->service().setBooks({}, "bench 1"); // nothing is said to anybody
    clock.advance(5s);
    core->service().setBooks({journal.get(), settings.get(), trials.get()}, "bench 1");
    ASSERT_TRUE(serve({update(), {"sim:can"}, std::nullopt, units(), run}));
    expectAllEnded();
    EXPECT_EQ(view().counts.passed, 3);
    service::VisitFilter filter;
    filter.run = run;
    EXPECT_EQ(journal->list(filter)->size(), 3U);
    for (const int address : {5, 7, 9})
        EXPECT_EQ(device(address)->identity().firmware, "1.25") << address;
}

TEST_F(Updated, PausedAfterThisUnitNothingBeginsUntilItGoesOn)
{
    ASSERT_TRUE(serve({update(), {"sim:can"}, std::nullopt, units()}));
    ASSERT_TRUE(writes(5));
    core->send(orders::PauseService{true});
    ASSERT_TRUE(clock.runUntil([this] { return view().counts.ended() == 1; }, 5min));
    clock.advance(1min);
    EXPECT_EQ(view().counts.ended(), 1);
    EXPECT_TRUE(view().running && view().pausing);
    core->send(orders::SkipUnit{row(7).id});
    core->send(orders::PauseService{false});
    expectAllEnded();
    EXPECT_EQ(row(7).state, service::RowState::Skipped);
    EXPECT_EQ(view().counts.passed, 2);
    EXPECT_FALSE(core->service().mustStayAwake()) << "simulated units end with the program";
}

} // namespace
} // namespace mb
