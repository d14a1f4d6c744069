// SPDX-License-Identifier: GPL-3.0-or-later
// What the user of a running queue orders: pause, skip, retry, end, stop.
#include "async/sleep.h"
#include "queuebench.h"
#include "service/goldenband.h"

namespace mb::service {
namespace {

using namespace std::chrono_literals;
using test::QueueRun;
using test::UnitRack;

TEST_F(ServiceQueues, PauseSkipAndRetry)
{
    UnitRack rack({"dmc60c:5,serial=210334000001", "dmc60c:6,serial=210334000002",
        "dmc60c:7,serial=210334000003,fault=encoder-reversed"});
    QueueRun run(rack, *books, load(rack, shortText));
    run.queue.start();
    ASSERT_TRUE(rack.clock.runUntil([&] { return run.queue.rows().size() == 3; }, 10s));
    run.queue.skip(run.queue.rows()[1]->id);
    ASSERT_TRUE(rack.clock.runUntil([&] { return run.queue.rows()[0]->state == RowState::Running; }, 10s));
    run.queue.pause();
    ASSERT_TRUE(rack.clock.runUntil([&] { return run.queue.isPaused(); }, 2min));
    EXPECT_EQ(run.queue.counts().ended(), 1);
    rack.clock.advance(20s);
    EXPECT_EQ(run.queue.counts().ended(), 1);
    run.queue.resume();
    ASSERT_TRUE(rack.clock.runUntil([&] { return run.isEnded; }, 2min));
    EXPECT_EQ(run.queue.rows()[1]->state, RowState::Skipped);
    EXPECT_EQ(run.queue.rows()[2]->state, RowState::Failed) << run.queue.rows()[2]->visit.cause.english();
    EXPECT_FALSE(run.queue.rows()[2]->visit.number); // a failed unit uses up no number
    run.isEnded = false;
    ASSERT_TRUE(run.queue.retry(run.queue.rows()[1]->id));
    ASSERT_TRUE(rack.clock.runUntil([&] { return run.isEnded; }, 2min));
    EXPECT_EQ(run.queue.counts().passed, 2);
    EXPECT_EQ(run.queue.rows()[1]->visit.number, 11);
    run.isEnded = false;
    run.queue.retryFailed();
    ASSERT_TRUE(rack.clock.runUntil([&] { return run.isEnded; }, 2min));
    EXPECT_EQ(run.queue.counts().failed, 1);
    EXPECT_EQ(run.queue.rows()[2]->tries, 2);
    EXPECT_EQ(books->visits().size(), 4U);
}

TEST_F(ServiceQueues, AQueueThatWasEndedTriesNothingAgainAndKeepsItsVerdict)
{
    UnitRack rack({"dmc60c:7,serial=210334000003,fault=encoder-reversed"});
    QueueRun run(rack, *books, load(rack, shortText));
    run.queue.start();
    ASSERT_TRUE(rack.clock.runUntil([&] { return run.queue.counts().failed == 1; }, 5min));
    run.queue.finish();
    ASSERT_TRUE(rack.clock.runUntil([&] { return run.isEnded; }, 1min));
    const std::string cause = run.queue.rows()[0]->visit.cause.english();
    EXPECT_FALSE(run.queue.retry(run.queue.rows()[0]->id));
    run.queue.retryFailed();
    EXPECT_EQ(run.queue.rows()[0]->state, RowState::Failed);
    EXPECT_EQ(run.queue.rows()[0]->visit.cause.english(), cause);
    EXPECT_EQ(run.queue.counts().failed, 1);
}

/// A journal whose disk takes a second for a new visit. It keeps what was last asked of it.
class SlowJournal final : public ServiceJournal {
public:
    SlowJournal(ServiceJournal &journal, Clock &clock)
        : m_journal(journal)
        , m_clock(clock)
    {
    }
    [[nodiscard]] Task<Visit> open(Visit visit) override
    {
        isOpening = true;
        co_await Sleep(m_clock, 1s);
        Visit opened = co_await m_journal.open(std::move(visit));
        isOpening = false;
        co_return opened;
    }
    [[nodiscard]] Task<Visit> write(Visit visit) override { return m_journal.write(std::move(visit)); }
    [[nodiscard]] Task<std::vector<Visit>> visits(VisitFilter filter) override
    {
        asked = filter;
        return m_journal.visits(std::move(filter));
    }
    [[nodiscard]] Task<std::optional<int>> number(NumberWish wish) override
    {
        return m_journal.number(std::move(wish));
    }
    bool isOpening = false;
    VisitFilter asked;

private:
    ServiceJournal &m_journal;
    Clock &m_clock;
};

TEST_F(ServiceQueues, ASelfTestIsComparedWithTheNewestThatPassedAndNotWithAWholeJournal)
{
    UnitRack rack({"dmc60c:7,serial=210334000003"});
    const RecipeMatter matter = load(rack, shortText);
    SlowJournal journal(*books->journal, rack.clock);
    QueueRun run(rack, *books, matter, {}, &journal);
    ASSERT_TRUE(run.run());
    EXPECT_EQ(journal.asked.outcome, Outcome::Passed);
    EXPECT_EQ(journal.asked.newest, visitsForBand);
    EXPECT_FALSE(journal.asked.steps);
}

TEST_F(ServiceQueues, AUnitThatIsLeftOutWhileItsVisitIsBeingOpenedIsNotServed)
{
    UnitRack rack({"dmc60c:7,serial=210334000003"});
    const RecipeMatter matter = load(rack, shortText);
    SlowJournal slow(*books->journal, rack.clock);
    QueueRun run(rack, *books, matter, {}, &slow);
    run.queue.start();
    ASSERT_TRUE(rack.clock.runUntil([&] { return slow.isOpening; }, 10s));
    run.queue.skip(run.queue.rows()[0]->id);
    ASSERT_TRUE(rack.clock.runUntil([&] { return run.isEnded; }, 5min));
    EXPECT_EQ(run.queue.rows()[0]->state, RowState::Skipped);
    EXPECT_EQ(run.queue.counts().ended(), 0);
    EXPECT_EQ(run.permit.count, 0);
}

TEST_F(ServiceQueues, AStopWhileAVisitIsBeingOpenedKeepsItsMotorStill)
{
    UnitRack rack({"dmc60c:7,serial=210334000003"});
    const RecipeMatter matter = load(rack, shortText);
    SlowJournal slow(*books->journal, rack.clock);
    QueueRun run(rack, *books, matter, {}, &slow);
    run.queue.start();
    ASSERT_TRUE(rack.clock.runUntil([&] { return slow.isOpening; }, 10s));
    run.queue.stop();
    ASSERT_TRUE(rack.clock.runUntil([&] { return run.isEnded; }, 5min));
    EXPECT_EQ(run.queue.rows()[0]->state, RowState::Skipped) << "nothing was judged";
    EXPECT_EQ(run.queue.counts().ended(), 0);
    EXPECT_EQ(run.permit.count, 0) << "what does not turn is not announced";
    QueueOptions options;
    options.run = run.queue.run();
    QueueRun again(rack, *books, matter, options);
    ASSERT_TRUE(again.run());
    ASSERT_EQ(books->visits().size(), 1U);
    EXPECT_EQ(books->visits()[0].outcome, Outcome::Passed) << books->visits()[0].cause.english();
}

TEST_F(ServiceQueues, AStopWhileAMotionIsAnnouncedLeavesItsVisitOpen)
{
    UnitRack rack({"dmc60c:7,serial=210334000003"});
    QueueRun run(rack, *books, load(rack, shortText));
    run.permit.asked = [&run] { run.queue.stop(); };
    ASSERT_TRUE(run.run());
    EXPECT_EQ(run.queue.rows()[0]->state, RowState::Skipped);
    EXPECT_EQ(books->visits().at(0).outcome, Outcome::Open);
}

TEST_F(ServiceQueues, AUnitThatIsLeftOutWhileItsMotorTurnsStandsAndTellsItselfAsOftenAsBefore)
{
    UnitRack rack({"dmc60c:7,serial=210334000003"});
    const RecipeMatter matter = load(rack, R"({"recipe":1,"name":"turn","family":"dmc60c",
"test":{"loop":"velocity","to":8000,"time":3,
"limits":{"travel":400000,"speed":40000,"duty":0.9,"current":60},"accept":{"settle":0.9}}})");
    QueueRun run(rack, *books, matter);
    ASSERT_TRUE(test::run(rack.clock, rack.session->scan(*rack.link)));
    Device &unit = *rack.session->devices().front();
    const ParameterIndex period = *findParameter(unit.family().parameters, "status.encoder.period");
    const auto before = test::run(rack.clock, unit.read(period));
    ASSERT_TRUE(before);
    Timer skipping(rack.clock);
    run.permit.asked = [&] { skipping.startIn(2s, [&run] { run.queue.skip(run.queue.rows()[0]->id); }); };
    run.queue.start();
    ASSERT_TRUE(rack.clock.runUntil([&] { return skipping.isActive(); }, 1min));
    rack.clock.advance(1900ms);
    EXPECT_TRUE(unit.liveness().moving);
    EXPECT_NE(unit.parameters().entry(period).raw, *before);
    ASSERT_TRUE(rack.clock.runUntil([&] { return run.isEnded; }, 1min));
    EXPECT_EQ(run.queue.rows()[0]->state, RowState::Skipped);
    EXPECT_EQ(books->visits().at(0).outcome, Outcome::Open);
    EXPECT_TRUE(unit.isSeenStopped());
    EXPECT_EQ(test::run(rack.clock, unit.read(period)), before);
}

TEST_F(ServiceQueues, AUnitThatWasTakenOffIsNotTriedAgainAndItsFailureStays)
{
    UnitRack rack({"dmc60c:7,serial=210334000003,fault=encoder-reversed", "dmc60c:8,serial=210334000004"});
    QueueOptions options;
    options.units = 0;
    QueueRun run(rack, *books, load(rack, shortText), options);
    rack.putOn(0);
    run.queue.start();
    ASSERT_TRUE(rack.clock.runUntil([&] { return run.queue.counts().failed == 1; }, 5min));
    rack.putOn(std::nullopt);
    rack.clock.advance(1min);
    const Result<void> again = run.queue.retry(run.queue.rows()[0]->id);
    ASSERT_FALSE(again);
    EXPECT_FALSE(again.error().detail.empty());
    EXPECT_EQ(run.queue.counts().failed, 1);
    EXPECT_EQ(run.queue.rows()[0]->state, RowState::Failed);
    EXPECT_FALSE(run.queue.retry(4711)) << "there is no such row";
}

} // namespace
} // namespace mb::service
